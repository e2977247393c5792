// Families fitted to one whole tree: splits of the tree, estimate, profile intervals. `evaluations` of the
// likelihood with its gradient a fit, `splits` of different kinds.
#include <string>

#include <benchmark/benchmark.h>

#include "ramify/core/cancellation.hpp"
#include "ramify/fit/tree_bootstrap.hpp"
#include "ramify/fit/tree_fit.hpp"
#include "ramify/tabulate/tree_batch.hpp"

namespace ramify::bench {
namespace {

RecordedTree tree_of(const char* model, Size n) {
  const Cancellation never;
  return TreeBatch{Model::parse(model), n, 1996, 1, false}.grown(0, 1, never)[0];
}

void fit(benchmark::State& state, const Family& family, const char* model) {
  const RecordedTree tree = tree_of(model, static_cast<Size>(state.range(0)));
  double evaluations = 0, kinds = 0;
  for (auto _ : state) {
    const ObservedSplits splits(tree.tree, tree.name);
    Objective objective = tree_objective(family, splits);
    objective.evaluate = [&evaluations, inner = objective.evaluate](std::span<const double> at, double& value,
                                                                    double* gradient) {
      ++evaluations;
      return inner(at, value, gradient);
    };
    benchmark::DoNotOptimize(fit_family(family, objective, splits.nodes()).log_likelihood);
    kinds = static_cast<double>(splits.splits().size());
  }
  state.counters["evaluations"] = evaluations / static_cast<double>(state.iterations());
  state.counters["splits"] = kinds;
}

void bootstrap(benchmark::State& state, const Family& family) {
  const Cancellation never;
  const RecordedTree tree = tree_of("bst", static_cast<Size>(state.range(0)));
  const ObservedSplits splits(tree.tree, tree.name);
  const FamilyFit fitted = fit_family(family, tree_objective(family, splits), splits.nodes());
  for (auto _ : state) {
    FamilyFit copy = fitted;
    bootstrap_tree_fit(copy, splits, {20, 1996}, 1, never);
    benchmark::DoNotOptimize(copy.goodness.p_value);
  }
  state.counters["trees"] = 20;
}

const bool registered = [] {
  for (const char* model : {"bst", "catalan"})
    for (const Family& family : families())
      benchmark::RegisterBenchmark(std::string(family.name).append(" on ").append(model).c_str(),
                                   [&family, model](benchmark::State& state) { fit(state, family, model); })
          ->Arg(1000)
          ->Arg(100000)
          ->Unit(benchmark::kMillisecond);
  for (const char* name : {"aldous", "beta_multinomial", "beta"})
    benchmark::RegisterBenchmark(std::string("20 bootstrap trees, ").append(name).c_str(),
                                 [name](benchmark::State& state) { bootstrap(state, find_family(name)); })
        ->Arg(10000)
        ->Unit(benchmark::kMillisecond);
  return true;
}();

}  // namespace
}  // namespace ramify::bench
