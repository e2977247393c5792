#pragma once

#include <concepts>
#include <utility>

#include "ramify/law/split_rows.hpp"

namespace ramify {

/// A law that holds nothing but size 0, with room up to n where it asks for that.
template <class Law>
Law empty_law(Size n) {
  if constexpr (std::constructible_from<Law, Size>) {
    return Law(n);
  } else {
    return Law();
  }
}

/// A law with all sizes up to n: build_law(model, n, StrahlerLaw(n)), build_law(model, n, HeightLaw()).
/// Cost: the law's own, and a split row for each size.
template <class Law>
Law build_law(const Model& model, Size n, Law law) {
  SplitRows rows(model);
  while (law.sizes() <= n) law.extend(rows.row(law.sizes()));
  return law;
}

}  // namespace ramify
