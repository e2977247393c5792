#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "claim.hpp"

namespace ramify {

/// A tree of a model with its picture: what a reader sees before the numbers.
struct SampleTree {
  Model model;
  Size n;
  std::uint64_t seed;
  std::string svg;

  /// "tree-beta-10-10": of a page.
  std::string anchor() const;
  /// Draws the same.
  std::string command() const;
};

/// Of every model whose trees parts of the claims take, in their order, the first tree of 100 internal nodes
/// in the thesis's own form (E21), coloured by order. Throws Interrupted.
std::vector<SampleTree> sample_trees(const std::vector<const Claim*>& claims, std::uint64_t seed,
                                     const Cancellation& cancellation);

/// Those of one claim. They live as long as the trees.
std::vector<const SampleTree*> trees_of(const Claim& claim, const std::vector<SampleTree>& trees);

}  // namespace ramify
