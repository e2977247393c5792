#include "support/growing.hpp"

#include <variant>

#include "support/sanitized.hpp"
#include "support/uninterrupted.hpp"

#include "ramify/model/labelled_tree.hpp"
#include "ramify/tree/store.hpp"

namespace ramify::test {

const std::vector<std::string>& all_models() {
  static const std::vector<std::string> models{"bst",
                                               "beta(1,1)",
                                               "beta(10,80)",
                                               "beta(0.3,0.2)",
                                               "beta_multinomial(2,5)",
                                               "beta_multinomial(0.3,0.2)",
                                               "split(0.25)",
                                               "split(1/4.35)",
                                               "dst(0.23)",
                                               "dst(1/2)",
                                               "patricia(1/4.35)",
                                               "patricia(0.7)",
                                               "catalan",
                                               "aldous(-1.75)",
                                               "aldous(-1)",
                                               "aldous(2)",
                                               "ford(0.3)",
                                               "ford(0.8)",
                                               "ford(1)",
                                               "complete",
                                               "chain"};
  return models;
}

TreeSource tree_source(std::string_view model, StreamKey key, Size table_size) {
  return std::visit(
      [&]<class Law>(const Law& law) -> TreeSource {
        return [grammar = SplitTree<Law>(law, table_size), key](Size n, std::uint64_t replicate) {
          Stream stream(key, replicate);
          return grow_tree(grammar, n, stream);
        };
      },
      Model::parse(model).law());
}

Tree grown_tree(const Model& model, Size n, StreamKey key, std::uint64_t replicate) {
  Stream stream(key, replicate);
  return grow_labelled(model, n, stream, uninterrupted).tree;
}

std::vector<std::uint64_t> count_splits(std::string_view model, Size n, std::uint64_t draws,
                                        std::uint64_t seed, Size table_size) {
  std::vector<std::uint64_t> counts(n, 0);
  std::visit(
      [&]<class Law>(const Law& law) {
        const SplitTree<Law> grammar(law, table_size);
        Stream stream({seed, n}, 0);
        for (std::uint64_t i = 0; i < replicates(draws); ++i) ++counts.at(grammar.children(n, stream)[0]);
      },
      Model::parse(model).law());
  return counts;
}

void grow_and_measure(const Model& model, Size n, std::uint64_t trees, std::uint64_t seed, const Look& look) {
  std::visit([&](const auto& law) { grow_and_measure(law, n, trees, seed, look); }, model.law());
}

}  // namespace ramify::test
