#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ramify/tree/recorded_tree.hpp"

namespace ramify {

/// How trees are made binary.
struct ForkRule {
  std::string resolution;    ///< "ladder" or "random" (resolve_forks.hpp); empty: forks of three are refused
  std::uint64_t seed;        ///< of "random"; the place of a tree in its file says the rest
  std::string_view because;  ///< why they must be, in the message: "trees of bst are binary"
};

/// Trees without one-child nodes and with forks of two alone. Throws Error where forks of three or more are
/// left, naming the first tree that has some, or for another resolution.
/// @param file  that they come from, for the message
std::vector<RecordedTree> binary_trees(std::vector<RecordedTree> trees, std::string_view file,
                                       const ForkRule& rule);

}  // namespace ramify
