#pragma once

#include <string>

namespace ramify {

/// How a file of trees is read, where its content leaves a choice.
struct ReadOptions {
  /// For tables: the id of the node from which on a tree is taken; "all" for every root as a tree of its own;
  /// "neurites" for everything that leaves the soma of a neuron. Empty: the file must have one root.
  std::string root;
  /// For MTG: the scale whose vertices are the nodes; 0 for the finest description of every part.
  unsigned scale = 0;
};

}  // namespace ramify
