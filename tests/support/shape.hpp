#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ramify::test {

/// An ordered tree as explicit nodes. Recursive, slow and obvious: what the library is held against shares no
/// code with it.
struct Shape {
  std::vector<Shape> children;

  bool is_external() const { return children.empty(); }
};

/// All ordered strict binary trees with n internal nodes (A1), by left size 0..n-1; C_n of them.
std::vector<Shape> all_shapes(std::size_t n);

/// The shape of a word of E and (LR); any number of children. Throws std::invalid_argument.
Shape read_shape(std::string_view word);

/// The word of a shape.
std::string to_word(const Shape& shape);

/// n internal nodes, each with an external left child.
Shape right_chain(std::size_t n);

/// All external nodes at level `levels`: 2^levels - 1 internal nodes.
Shape complete_shape(std::size_t levels);

}  // namespace ramify::test
