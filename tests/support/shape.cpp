#include "support/shape.hpp"

#include <stdexcept>
#include <utility>

namespace ramify::test {
namespace {

Shape read_node(std::string_view word, std::size_t& at) {
  if (at >= word.size()) throw std::invalid_argument("word too short");
  if (word[at] == 'E') {
    ++at;
    return {};
  }
  if (word[at] != '(') throw std::invalid_argument("neither E nor (");
  ++at;
  Shape shape;
  while (at < word.size() && word[at] != ')') shape.children.push_back(read_node(word, at));
  if (at == word.size() || shape.children.empty()) throw std::invalid_argument("no children, or no )");
  ++at;
  return shape;
}

}  // namespace

std::vector<Shape> all_shapes(std::size_t n) {
  if (n == 0) return {Shape{}};
  std::vector<Shape> shapes;
  for (std::size_t left = 0; left < n; ++left)
    for (const Shape& l : all_shapes(left))
      for (const Shape& r : all_shapes(n - 1 - left)) shapes.push_back(Shape{{l, r}});
  return shapes;
}

Shape read_shape(std::string_view word) {
  std::size_t at = 0;
  Shape shape = read_node(word, at);
  if (at != word.size()) throw std::invalid_argument("more follows after the tree");
  return shape;
}

std::string to_word(const Shape& shape) {
  if (shape.is_external()) return "E";
  std::string word = "(";
  for (const Shape& child : shape.children) word += to_word(child);
  word += ")";
  return word;
}

Shape right_chain(std::size_t n) {
  Shape shape;
  for (std::size_t i = 0; i < n; ++i) {
    Shape parent;
    parent.children.emplace_back();
    parent.children.push_back(std::move(shape));
    shape = std::move(parent);
  }
  return shape;
}

Shape complete_shape(std::size_t levels) {
  if (levels == 0) return {};
  const Shape half = complete_shape(levels - 1);
  return Shape{{half, half}};
}

}  // namespace ramify::test
