#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "ramify/random/stream.hpp"

namespace ramify::test {

/// A binary tree as it is built by insertion: internal nodes by number, -1 where a child is external.
struct LinkedTree {
  struct Node {
    int left = -1;
    int right = -1;
  };
  std::vector<Node> nodes;
  int root = -1;
};

// The models once more, by what they are defined by rather than by their split law.

/// A random permutation of n keys inserted into a binary search tree (A14).
LinkedTree bst_by_insertion(std::size_t n, Stream& stream);

/// n random bit strings inserted into a digital search tree: a string goes down by its own bits, left with
/// probability p, and takes the first free place (A11).
LinkedTree dst_by_insertion(std::size_t n, double p, Stream& stream);

/// The trie of n+1 random bit strings, its one-child nodes contracted (A12, A13).
LinkedTree patricia_of_strings(std::size_t n, double p, Stream& stream);

/// n+1 random bit strings inserted one by one into a PATRICIA tree: the first bit at which a string differs
/// from the one its own bits lead to splits an edge (A13).
LinkedTree patricia_by_insertion(std::size_t n, double p, Stream& stream);

/// Remy's algorithm (1985): a new leaf grows out of a uniformly chosen node, on a uniformly chosen side
/// (A15). Knuth's arrays, which know the segments of segmental_growth by other numbers.
LinkedTree catalan_by_remy(std::size_t n, Stream& stream);

/// A uniformly chosen terminal segment bifurcates, n times (A16, Horsfield and Woldenberg 1986).
LinkedTree terminal_growth(std::size_t n, Stream& stream);

/// A terminal segment is attached, on either side alike, to a segment chosen uniformly among all, the stem
/// below the root included; n times (A16).
LinkedTree segmental_growth(std::size_t n, Stream& stream);

/// A leaf grows out of an edge, chosen with a weight of 1-weight where it ends in a leaf, else weight, the
/// stem above the root among these; on either side alike; n-1 times from the cherry on (Ford 2005). 0 <=
/// weight < 1.
LinkedTree ford_by_growth(std::size_t n, double weight, Stream& stream);

/// Slip: nothing grows out of the stem.
LinkedTree stemless_segmental_growth(std::size_t n, Stream& stream);

/// Floor split tree with X the a-th smallest of a+b-1 uniforms, which is beta(a,b); whole a, b >= 1 (A8).
LinkedTree beta_by_order_statistics(std::size_t n, std::size_t a, std::size_t b, Stream& stream);

/// n keys inserted one after the other: where i keys have gone left and j right of a node, the next goes left
/// with probability (i+a)/(i+j+a+b). By Polya's urn that is a coin of bias X ~ beta(a,b) at every node (A8);
/// a, b > 0.
LinkedTree beta_multinomial_by_insertion(std::size_t n, double a, double b, Stream& stream);

/// Horton-Strahler order and height, by the definitions.
struct OrderAndHeight {
  std::size_t order;
  std::size_t height;
};
OrderAndHeight order_and_height(const LinkedTree& tree);

/// "((EE)E)"
std::string to_word(const LinkedTree& tree);

}  // namespace ramify::test
