// What grafting saves: the same statistics of trees of the same model, grown whole and grafted.
#include <string>

#include "cpu_time.hpp"
#include <benchmark/benchmark.h>

#include "ramify/sample/graft_rule.hpp"
#include "ramify/sample/tree_sampler.hpp"

namespace ramify::bench {
namespace {

/// A method's time for one tree at a time, and what it takes to get ready.
class Timed {
 public:
  Timed(const Model& model, SamplingMethod method, Size n) : n_(n), key_{1996, model.stream_cell(n)} {
    build_ = cpu_seconds([&] { sampler_ = make_tree_sampler({model, method, n, &cancellation_}); });
  }

  void sample() {
    spent_ += cpu_seconds([&] { sampler_->sample(n_, key_, trees_, measures_); });
    benchmark::DoNotOptimize(measures_);
    ++trees_;
  }

  double build_seconds() const { return build_; }
  double seconds_a_tree() const { return spent_ / static_cast<double>(trees_); }
  double nanoseconds_a_node() const { return 1e9 * seconds_a_tree() / static_cast<double>(n_); }

 private:
  Size n_;
  StreamKey key_;
  Cancellation cancellation_;
  std::unique_ptr<TreeSampler> sampler_;
  TreeMeasures measures_;
  double build_ = 0, spent_ = 0;
  std::uint64_t trees_ = 0;
};

/// One iteration samples one tree of grown_n nodes that is grown whole and `trees` of n that are grafted.
void graft(benchmark::State& state, const Model& model, SamplingMethod method) {
  const auto grown_n = static_cast<Size>(state.range(0)), n = static_cast<Size>(state.range(1));
  const auto trees = static_cast<int>(state.range(2));
  Timed whole(model, whole_trees(orders_and_height), grown_n), grafted(model, method, n);
  for (auto _ : state) {
    whole.sample();
    for (int i = 0; i < trees; ++i) grafted.sample();
  }
  state.counters["grown_ns"] = whole.nanoseconds_a_node();
  state.counters["grafted_ns"] = grafted.nanoseconds_a_node();
  state.counters["ratio"] = whole.nanoseconds_a_node() / grafted.nanoseconds_a_node();
  state.counters["ms_a_tree"] = 1e3 * grafted.seconds_a_tree();
  state.counters["build_ms"] = 1e3 * grafted.build_seconds();
  state.counters["up_to"] = static_cast<double>(GraftRule(model, method).size(n));
}

void add(const std::string& name, const char* text, SamplingMethod method, Size n, int trees) {
  constexpr Size grown = 10'000'000;
  benchmark::RegisterBenchmark(
      (name + "/" + text).c_str(),
      [model = Model::parse(text), method](benchmark::State& state) { graft(state, model, method); })
      ->ArgNames({"grown_n", "n", "trees"})
      ->Args({grown, static_cast<std::int64_t>(n), trees})
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
}

const bool registered = [] {
  for (const char* text : {"bst", "beta(2,2)", "beta(10,80)", "dst(0.23)", "patricia(0.23)", "catalan"})
    add("joint", text, {orders_and_height, true}, 10'000'000, 5);
  for (const char* text : {"bst", "beta(2,2)", "dst(0.23)", "patricia(0.23)", "catalan"})
    add("strahler", text, {Folded::strahler, true}, 1'000'000'000, 3);
  for (const char* text : {"bst", "patricia(0.23)"}) {
    add("height", text, {Folded::height, true}, 1'000'000'000, 3);
    add("strahler", text, {Folded::strahler, true}, 1'000'000'000'000, 1);
  }
  return true;
}();

}  // namespace
}  // namespace ramify::bench
