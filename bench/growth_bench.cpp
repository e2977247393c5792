// Growing and folding in one pass that stores nothing, against the same statistics on a tree of one `new` per
// node: order, height, and node and stream counts per order, from the same random numbers, on one core.
// `ratio` is against a tree whose external nodes are nodes too (2n+1 times `new`), `lean_ratio` against one
// that makes them null pointers (n); each on a fresh and on a warm heap (Heap below).
#include <string>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include "cpu_time.hpp"
#include "pointer_tree.hpp"
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

using LeanFold = Joint<Height, HortonStrahler>;

/// What both ways must agree on.
struct Measured {
  std::uint32_t height = 0;
  std::uint32_t strahler = 0;
  HortonStrahler::Counts nodes{};
  HortonStrahler::Counts streams{};

  Measured() = default;
  Measured(const LeanFold::Value& root, const LeanFold& fold)
      : height(get<0>(root)),
        strahler(get<1>(root)),
        nodes(fold.get<HortonStrahler>().nodes()),
        streams(fold.get<HortonStrahler>().streams()) {}

  friend bool operator==(const Measured&, const Measured&) = default;
};

struct PointerTimes {
  double build_and_fold = 0;
  double destroy = 0;
};

/// The heap a pointer tree is built on: it decides as much as the tree does.
enum class Heap {
  fresh,  ///< nothing allocated yet, as for the first tree of a program: the build pays for the page faults
  warm,   ///< left by an equal tree just deleted: no page faults, the kinder of the two to the pointer tree
};

template <External external, class Grammar>
void prepare_heap(Heap heap, const Grammar& grammar, Size n, Stream stream) {
#if defined(__GLIBC__)
  malloc_trim(0);  // else free lists in the disorder of the last tree would scatter the next one
#endif
  if (heap == Heap::warm) delete_pointer_tree(build_pointer_tree<external>(grammar, n, stream));
}

template <External external, class Grammar>
Measured measure_pointer_tree(Heap heap, const Grammar& grammar, Size n, Stream stream, PointerTimes& times) {
  prepare_heap<external>(heap, grammar, n, stream);
  PointerNode* tree = nullptr;
  LeanFold fold;
  LeanFold::Value root{};
  times.build_and_fold += cpu_seconds([&] {
    tree = build_pointer_tree<external>(grammar, n, stream);
    root = fold_pointer_tree<external>(tree, fold);
  });
  times.destroy += cpu_seconds([&] { delete_pointer_tree(tree); });
  return Measured(root, fold);
}

/// One iteration grows one tree every way, one after the other, so that the ratios are of neighbours in time.
template <class Law>
void growth(benchmark::State& state, const Law& law) {
  const auto n = static_cast<Size>(state.range(0));
  const auto heap = static_cast<Heap>(state.range(1));
  const SplitTree<Law> grammar(law);
  const Cancellation cancellation;
  Grower<SplitTree<Law>, LeanFold, Stream> grower(cancellation);
  double streamed = 0;
  PointerTimes full, lean;
  std::uint64_t replicate = 0;
  for (auto _ : state) {
    const Stream stream({1996, n}, replicate++);
    LeanFold fold;
    LeanFold::Value root{};
    streamed += cpu_seconds([&, words = stream]() mutable { root = grower(grammar, n, words, fold); });
    const Measured measured(root, fold);
    if (measure_pointer_tree<External::allocated>(heap, grammar, n, stream, full) != measured ||
        measure_pointer_tree<External::null>(heap, grammar, n, stream, lean) != measured) {
      state.SkipWithError("the streamed and the stored tree differ");
      break;
    }
  }
  const double ns = 1e9 / (static_cast<double>(n) * static_cast<double>(replicate));
  state.counters["streamed_ns"] = streamed * ns;
  state.counters["pointer_ns"] = full.build_and_fold * ns;
  state.counters["ratio"] = full.build_and_fold / streamed;
  state.counters["lean_ns"] = lean.build_and_fold * ns;
  state.counters["lean_ratio"] = lean.build_and_fold / streamed;
  state.counters["delete_ns"] = full.destroy * ns;
  state.counters["stack_bytes"] = static_cast<double>(grower.stack_bytes());
}

void register_model(const std::string& text) {
  std::visit(
      [&](const auto& law) {
        benchmark::RegisterBenchmark(("growth/" + text).c_str(),
                                     [law](benchmark::State& state) { growth(state, law); })
            ->ArgNames({"n", "warm"})
            ->ArgsProduct({{1'000'000, 10'000'000}, {0, 1}})
            ->Iterations(1)
            ->Unit(benchmark::kMillisecond);
      },
      Model::parse(text).law());
}

const bool registered = [] {
  for (const char* model : {"bst", "beta(10,10)", "beta(2,2)", "beta_multinomial(2,2)", "split(0.25)",
                            "dst(0.23)", "patricia(0.23)", "catalan", "aldous(-1)", "ford(0.3)"})
    register_model(model);
  return true;
}();

}  // namespace
}  // namespace ramify::bench
