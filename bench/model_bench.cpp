// What a node of each model costs beside a node of a bst: sampled with every node grown, order, height and
// counts measured, external nodes counted as nodes. Models that are no split trees are stored and then
// measured, the others are measured as they grow.
#include <string>

#include "cpu_time.hpp"
#include <benchmark/benchmark.h>

#include "ramify/model/registry.hpp"
#include "ramify/sample/tree_sampler.hpp"

namespace ramify::bench {
namespace {

struct Case {
  const char* model;
  Size n;
};

/// Time and nodes of the trees of one model.
class Timed {
 public:
  Timed(const Case& sampled, const Cancellation& cancellation)
      : n_(sampled.n),
        model_(Model::parse(sampled.model)),
        key_{1996, model_.stream_cell(n_)},
        sampler_(make_tree_sampler({model_, whole_trees(orders_and_height), n_, &cancellation})) {}

  void sample(std::uint64_t replicate) {
    TreeMeasures measures;
    seconds_ += cpu_seconds([&] { sampler_->sample(n_, key_, replicate, measures); });
    for (const std::uint64_t nodes : measures.nodes) nodes_ += static_cast<double>(nodes);
  }

  double nanoseconds() const { return 1e9 * seconds_ / nodes_; }

 private:
  Size n_;
  Model model_;
  StreamKey key_;
  std::unique_ptr<TreeSampler> sampler_;
  double seconds_ = 0, nodes_ = 0;
};

/// One iteration grows a bst of 10^6 nodes and one tree of the model, or several small ones.
void against_bst(benchmark::State& state, const Case& sampled) {
  const Cancellation cancellation;
  Timed bst({"bst", 1'000'000}, cancellation), other(sampled, cancellation);
  const auto trees = static_cast<std::uint64_t>(state.range(0));
  std::uint64_t replicate = 0;
  for (auto _ : state) {
    bst.sample(replicate);
    for (std::uint64_t i = 0; i < trees; ++i) other.sample(trees * replicate + i);
    ++replicate;
  }
  state.counters["ns_a_node"] = other.nanoseconds();
  state.counters["ratio_to_bst"] = other.nanoseconds() / bst.nanoseconds();
}

const bool registered = [] {
  const auto add = [](const Case& sampled, std::int64_t trees) {
    benchmark::RegisterBenchmark((std::string("model/") + sampled.model).c_str(),
                                 [sampled](benchmark::State& state) { against_bst(state, sampled); })
        ->ArgName("trees")
        ->Arg(trees)
        ->Iterations(3)
        ->Unit(benchmark::kMillisecond);
  };
  for (const char* model :
       {"beta(2,2)", "beta_multinomial(2,2)", "split(0.25)", "dst(0.23)", "patricia(0.23)", "catalan",
        "aldous(-1)", "complete", "trie(0.23)", "ternary(1/4.8)", "node_beta(d,d)", "node_dst(0.2+0.1/d)",
        "node_ternary(1/(3.19+log(d)))"})
    add({model, 1'000'000}, 1);
  add({"chain", 100'000}, 10);
  add({"galton_watson(0.25,0.5,0.25)", 1'000'000}, 1);
  add({"branching(0,0.5,0.5)", 35}, 1);
  add({"tokunaga(1,2)", 9}, 5);
  add({"kary(3)", 13}, 1);
  add({"flow_rate(0.8)", 20}, 1);
  return true;
}();

}  // namespace
}  // namespace ramify::bench
