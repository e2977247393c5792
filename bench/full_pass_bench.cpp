// What the full pass (last-node depth, fill level and balance besides order, height and counts) and that of
// all statistics cost over the lean one.
#include <string>

#include "cpu_time.hpp"
#include <benchmark/benchmark.h>

#include "ramify/model/registry.hpp"
#include "ramify/sample/tree_sampler.hpp"

namespace ramify::bench {
namespace {

/// One iteration measures the same tree by both passes.
void full_pass(benchmark::State& state, const Model& model) {
  const auto n = static_cast<Size>(state.range(0));
  const Cancellation cancellation;
  const auto lean = make_tree_sampler({model, whole_trees(orders_and_height), max_size, &cancellation});
  const auto full = make_tree_sampler({model, whole_trees(orders_and_paths), max_size, &cancellation});
  const StreamKey key{1996, model.stream_cell(n)};
  const auto all = make_tree_sampler({model, whole_trees(all_but_indices), max_size, &cancellation});
  double lean_time = 0, full_time = 0, all_time = 0;
  std::uint64_t replicate = 0;
  for (auto _ : state) {
    TreeMeasures by_lean, by_full, by_all;
    lean_time += cpu_seconds([&] { lean->sample(n, key, replicate, by_lean); });
    full_time += cpu_seconds([&] { full->sample(n, key, replicate, by_full); });
    all_time += cpu_seconds([&] { all->sample(n, key, replicate, by_all); });
    ++replicate;
    const bool same_tree = by_lean.height == by_full.height && by_lean.streams == by_full.streams &&
                           by_lean.height == by_all.height && by_lean.streams == by_all.streams;
    if (!same_tree) {
      state.SkipWithError("the passes saw different trees");
      break;
    }
  }
  const double ns = 1e9 / (static_cast<double>(n) * static_cast<double>(replicate));
  state.counters["lean_ns"] = lean_time * ns;
  state.counters["full_ns"] = full_time * ns;
  state.counters["all_ns"] = all_time * ns;
  state.counters["full_ratio"] = full_time / lean_time;
  state.counters["all_ratio"] = all_time / lean_time;
}

const bool registered = [] {
  for (const char* text : {"bst", "beta(10,10)", "beta(2,2)", "beta_multinomial(2,2)", "split(0.25)",
                           "dst(0.23)", "patricia(0.23)", "catalan", "aldous(-1)"}) {
    benchmark::RegisterBenchmark(
        (std::string("full_pass/") + text).c_str(),
        [model = Model::parse(text)](benchmark::State& state) { full_pass(state, model); })
        ->ArgName("n")
        ->Arg(1'000'000)
        ->Arg(10'000'000)
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
  }
  return true;
}();

}  // namespace
}  // namespace ramify::bench
