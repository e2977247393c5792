// What the full pass (last-node depth, fill level and balance besides order, height and counts) costs over
// the lean one.
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
  const auto lean = make_tree_sampler({model, grow_lean, max_size, &cancellation});
  const auto full = make_tree_sampler({model, grow_full, max_size, &cancellation});
  const StreamKey key{1996, model.stream_cell(n)};
  double lean_time = 0, full_time = 0;
  std::uint64_t replicate = 0;
  for (auto _ : state) {
    TreeMeasures by_lean, by_full;
    lean_time += cpu_seconds([&] { lean->sample(n, key, replicate, by_lean); });
    full_time += cpu_seconds([&] { full->sample(n, key, replicate, by_full); });
    ++replicate;
    if (by_lean.height != by_full.height || by_lean.streams != by_full.streams) {
      state.SkipWithError("the lean and the full pass saw different trees");
      break;
    }
  }
  const double ns = 1e9 / (static_cast<double>(n) * static_cast<double>(replicate));
  state.counters["lean_ns"] = lean_time * ns;
  state.counters["full_ns"] = full_time * ns;
  state.counters["ratio"] = full_time / lean_time;
}

const bool registered = [] {
  for (const char* text : {"bst", "beta(10,10)", "beta(2,2)", "beta_multinomial(2,2)", "split(0.25)",
                           "dst(0.23)", "patricia(0.23)", "catalan"}) {
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
