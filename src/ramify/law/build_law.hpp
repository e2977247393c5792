#pragma once

#include "ramify/core/cancellation.hpp"
#include "ramify/core/error.hpp"
#include "ramify/law/split_rows.hpp"

namespace ramify {

/// A law with all sizes up to n: build_law(model, n, BoundedLaw(Balance::recurrence, n)),
/// build_law(model, n, HeightLaw()).
/// Cost: the law's own (law_cost.hpp), and a split row for each size.
///
/// Throws Interrupted when cancelled, which is looked at before each size.
template <class Law>
Law build_law(const Model& model, Size n, Law law, const Cancellation& cancellation = {}) {
  SplitRows rows(model);
  while (law.sizes() <= n) {
    if (cancellation.requested()) throw Interrupted();
    law.extend(rows.row(law.sizes()));
  }
  return law;
}

}  // namespace ramify
