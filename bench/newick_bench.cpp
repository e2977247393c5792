// Newick of a million tips read and measured: a random tree, a caterpillar, a star of cherries, many small
// trees.
#include <string>

#include <benchmark/benchmark.h>

#include "ramify/format/newick.hpp"
#include "ramify/measure/tree_measurement.hpp"
#include "ramify/model/bst.hpp"
#include "ramify/model/split_tree.hpp"
#include "ramify/random/stream.hpp"
#include "ramify/text/remarks.hpp"
#include "ramify/tree/contract_unary.hpp"
#include "ramify/tree/store.hpp"

namespace {

using namespace ramify;

std::string random_tree(Size tips, std::uint64_t replicate) {
  Stream stream({1996, tips}, replicate);
  return write_newick({{}, grow_tree(SplitTree<Bst>(Bst()), tips - 1, stream), {}, {}, {}});
}

std::string caterpillar(Size tips) {
  std::string text(tips - 1, '(');
  text += 'a';
  for (Size i = 1; i < tips; ++i) text += ",b)";
  return text + ";\n";
}

std::string star(Size tips) {
  std::string text = "(";
  for (Size i = 0; i < tips / 2; ++i) text += i == 0 ? "(a,b)" : ",(a,b)";
  return text + ");\n";
}

std::string small_trees(Size tips) {
  constexpr Size tips_of_one = 20;
  std::string text;
  for (Size i = 0; i < tips / tips_of_one; ++i) text += random_tree(tips_of_one, i);
  return text;
}

void read_and_measure(benchmark::State& state, const std::string& text) {
  for (auto _ : state) {
    Remarks remarks;
    for (RecordedTree& tree : read_newick(SourceText(text, "bench"), remarks))
      benchmark::DoNotOptimize(measure_all(contract_unary(std::move(tree))));
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(text.size()) * state.iterations());
}

void add(const std::string& name, Size tips, std::string (*write)(Size)) {
  benchmark::RegisterBenchmark((name + '/' + std::to_string(tips)).c_str(), [=](benchmark::State& state) {
    read_and_measure(state, write(tips));
  })->Unit(benchmark::kMillisecond);
}

[[maybe_unused]] const bool registered = [] {
  for (const Size tips : {Size{1'000'000}, Size{2'000'000}}) {
    add("random", tips, [](Size n) { return random_tree(n, 0); });
    add("caterpillar", tips, caterpillar);
    add("star", tips, star);
    add("small", tips, small_trees);
  }
  return true;
}();

}  // namespace
