#include "ramify/model/trie.hpp"

#include <array>

#include "ramify/model/model_info.hpp"

namespace ramify {

Trie::Trie(double p) : p_(p) {
  require_domain(info(), std::array{p});
}

const ModelInfo& Trie::info() {
  static const ModelInfo info{
      .name = "trie",
      .parameters = {probability("p")},
      .largest_n = max_double_size,
      .n_counts = "strings",
      .description = "trie of n random bit strings, one-child nodes kept; patricia(p) is without them",
      .source = "A12; Kruszewski 1996, B.1.1",
      .make = [](std::span<const double> v) -> AnyModel { return grown_model(Trie(v[0])); },
      .is_split = false};
  return info;
}

}  // namespace ramify
