#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "support/model_cases.hpp"
#include "support/shape.hpp"

namespace ramify::test {

/// A shape's probability is the product of the split law over its internal nodes. shapes: of n internal
/// nodes.
std::vector<double> shape_law(const std::vector<Shape>& shapes, std::size_t n, const SplitPmf& split);

/// How often each shape came in so many trees (sanitized.hpp), replicates 0, 1, ...; word_of gives a tree's
/// word.
std::vector<std::uint64_t> count_shapes(const std::vector<Shape>& shapes, std::uint64_t trees,
                                        const std::function<std::string(std::uint64_t replicate)>& word_of);

}  // namespace ramify::test
