#pragma once

#include <cstddef>

namespace ramify {

/// What a rule of form may know of a node. All are numbers of the tree but the last two, which the rules
/// themselves gave the node before.
struct NodeFacts {
  double nodes;       ///< all nodes below and including it, |u|
  double leaves;      ///< external nodes below and including it (Shreve magnitude)
  double order;       ///< Horton-Strahler order, leaf order 1
  double main;        ///< main nodes on the path from the root, both ends counted
  double secondary;   ///< secondary nodes on that path
  bool is_main;       ///< goes on with the main branch of its mother; so does the root
  std::size_t place;  ///< among its siblings, from 0
  std::size_t node;   ///< its place in preorder: what was measured of it is found by this
  double radius = 0;
  double length = 0;

  double depth() const { return main + secondary; }  ///< of the root 1
  double size() const { return nodes - leaves; }     ///< internal nodes below and including it
  bool is_external() const { return nodes == 1; }
};

}  // namespace ramify
