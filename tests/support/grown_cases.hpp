#pragma once

#include <string>
#include <vector>

#include "ramify/tree/grammar.hpp"

namespace ramify::test {

/// A model whose trees are grown whole, and an n that makes some hundred nodes.
struct GrownCase {
  std::string model;
  Size n;
};

/// Every such model once; the split models are in growing.hpp.
const std::vector<GrownCase>& grown_cases();

}  // namespace ramify::test
