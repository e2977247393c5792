#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "ramify/random/stream.hpp"
#include "ramify/tree/recorded_tree.hpp"

namespace ramify {

/// How a fork of three or more children becomes forks of two.
enum class ForkResolution {
  ladder,  ///< the first child beside all others, again and again: (a,b,c,d) is (a,(b,(c,d)))
  random,  ///< two at a time, joined at random: every order of joining is as likely (a Yule tree of the
           ///< children)
};

/// The tree with forks of two alone, or one child. The new nodes have a length of 0, where the tree has
/// lengths, and neither radius nor name. With `ladder` nothing is drawn; left and right stay.
/// O(nodes) time for ladder, O(nodes log(children)) for random on average.
RecordedTree resolve_forks(RecordedTree tree, ForkResolution resolution, Stream& stream);

/// Nodes of three children or more.
std::size_t wide_forks(const Tree& tree);

/// "ladder" or "random". Throws Error for another.
ForkResolution parse_fork_resolution(const std::string& name);

}  // namespace ramify
