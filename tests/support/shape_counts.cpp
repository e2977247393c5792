#include "support/shape_counts.hpp"

#include <map>

#include "support/definitions.hpp"
#include "support/sanitized.hpp"

namespace ramify::test {
namespace {

double shape_probability(const Shape& shape, const std::vector<std::vector<double>>& laws) {
  if (shape.is_external()) return 1;
  const auto& left = shape.children[0];
  const auto& right = shape.children[1];
  return laws[internal_nodes(shape)][internal_nodes(left)] * shape_probability(left, laws) *
         shape_probability(right, laws);
}

}  // namespace

std::vector<double> shape_law(const std::vector<Shape>& shapes, std::size_t n, const SplitPmf& split) {
  std::vector<std::vector<double>> laws{{}};
  for (Size size = 1; size <= n; ++size) laws.push_back(split(size));
  std::vector<double> law;
  for (const auto& shape : shapes) law.push_back(shape_probability(shape, laws));
  return law;
}

std::vector<std::uint64_t> count_shapes(const std::vector<Shape>& shapes, std::uint64_t trees,
                                        const std::function<std::string(std::uint64_t replicate)>& word_of) {
  std::map<std::string, std::size_t> place;
  for (const auto& shape : shapes) place.emplace(to_word(shape), place.size());
  std::vector<std::uint64_t> counts(shapes.size(), 0);
  for (std::uint64_t replicate = 0; replicate < replicates(trees); ++replicate)
    ++counts[place.at(word_of(replicate))];
  return counts;
}

}  // namespace ramify::test
