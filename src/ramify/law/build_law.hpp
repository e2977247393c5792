#pragma once

#include "ramify/core/cancellation.hpp"
#include "ramify/core/error.hpp"
#include "ramify/law/split_rows.hpp"

namespace ramify {

/// Adds the sizes that a law has not yet, up to n, from rows that are computed or kept.
///
/// Throws Interrupted when cancelled, which is looked at before each size.
template <class Law, class Rows>
void extend_law(Law& law, Rows& rows, Size n, const Cancellation& cancellation = {}) {
  while (law.sizes() <= n) {
    if (cancellation.requested()) throw Interrupted();
    law.extend(rows.row(law.sizes()));
  }
}

/// A law with all sizes up to n: build_law(model, n, BoundedLaw(Balance::recurrence, n)),
/// build_law(model, n, HeightLaw()).
/// Cost: the law's own (law_cost.hpp), and a split row for each size.
///
/// Throws Interrupted when cancelled, which is looked at before each size.
template <class Law>
Law build_law(const Model& model, Size n, Law law, const Cancellation& cancellation = {}) {
  SplitRows rows(model);
  extend_law(law, rows, n, cancellation);
  return law;
}

}  // namespace ramify
