// How large the alias tables of SplitTree should be: time of a node by table_size, and the time to build the
// tables, which is paid once for each model.
#include <optional>
#include <string>

#include "cpu_time.hpp"
#include <benchmark/benchmark.h>

#include "ramify/core/cancellation.hpp"
#include "ramify/model/registry.hpp"
#include "ramify/model/split_tree.hpp"
#include "ramify/random/stream.hpp"
#include "ramify/statistic/height.hpp"
#include "ramify/statistic/horton_strahler.hpp"
#include "ramify/statistic/joint.hpp"
#include "ramify/tree/grow.hpp"

namespace ramify::bench {
namespace {

constexpr Size tree_size = 2'000'000;

template <class Law>
void table(benchmark::State& state, const Law& law) {
  using Fold = Joint<Height, HortonStrahler>;
  const auto table_size = static_cast<Size>(state.range(0));
  std::optional<SplitTree<Law>> grammar;
  const double build = cpu_seconds([&] { grammar.emplace(law, table_size); });
  const Cancellation cancellation;
  Grower<SplitTree<Law>, Fold, Stream> grower(cancellation);
  double growing = 0;
  std::uint64_t replicate = 0;
  for (auto _ : state) {
    Stream stream({1996, tree_size}, replicate++);
    Fold fold;
    growing += cpu_seconds([&] { benchmark::DoNotOptimize(grower(*grammar, tree_size, stream, fold)); });
  }
  state.counters["ns_per_node"] = growing * 1e9 / static_cast<double>(replicate * tree_size);
  state.counters["build_ms"] = build * 1e3;
  state.counters["table_kB"] =
      static_cast<double>(sizeof(AliasCell)) * static_cast<double>(table_size * (table_size + 1) / 2) / 1e3;
}

void register_model(const std::string& text) {
  std::visit(
      [&](const auto& law) {
        auto* bench = benchmark::RegisterBenchmark(("table/" + text).c_str(),
                                                   [law](benchmark::State& state) { table(state, law); });
        bench->ArgName("table_size")->Iterations(1)->Unit(benchmark::kMillisecond);
        for (const int size : {16, 32, 64, 128, 256, 512, 1024}) bench->Arg(size);
      },
      Model::parse(text).law());
}

const bool registered = [] {
  for (const char* model :
       {"patricia(0.23)", "dst(0.23)", "beta(10,10)", "beta(2,2)", "beta(10,80)", "catalan"})
    register_model(model);
  return true;
}();

}  // namespace
}  // namespace ramify::bench
