// What laws at large sizes cost: exact tables, solutions on grids of sizes, and a mean at the largest n, with
// its error.
#include <cmath>
#include <functional>
#include <string>

#include <benchmark/benchmark.h>

#include "ramify/large/large_law.hpp"
#include "ramify/large/large_orders.hpp"
#include "ramify/model/registry.hpp"
#include "ramify/statistic/registry.hpp"

namespace ramify::bench {
namespace {

using MeanAt = std::function<Approximation(const Model& model, double n)>;

void add(const std::string& name, const char* model, double n, const MeanAt& mean_at) {
  benchmark::RegisterBenchmark((name + "/" + model).c_str(),
                               [mean_at, n, model = Model::parse(model)](benchmark::State& state) {
                                 Approximation mean{};
                                 for (auto _ : state) mean = mean_at(model, n);
                                 state.counters["mean"] = mean.value;
                                 state.counters["error"] = mean.error;
                               })
      ->ArgName("log10_n")
      ->Arg(std::lround(std::log10(n)))
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
}

void add_law(const StatisticInfo& statistic, const char* model, double n) {
  add(std::string(statistic.name), model, n, [&statistic](const Model& of, double at) {
    return LargeLaw(of, statistic.law.recurrence, {at}).moments(at).mean;
  });
}

/// The mean shown is that of the nodes of order 1.
void add_order_means(const char* model, double n) {
  add("order_means", model, n, [](const Model& of, double at) {
    return LargeOrders(of, {at}).means(at, OrderCount::Of::nodes).at(1);
  });
}

const bool registered = [] {
  constexpr double lung = 4.3e8;  // branches
  add_law(statistic::strahler, "bst", 1e9);
  add_order_means("bst", 1e9);
  add_law(statistic::height, "bst", 1e9);
  for (const char* model : {"patricia(0.295)", "beta(10,80)"}) {
    add_law(statistic::strahler, model, lung);
    add_order_means(model, lung);
  }
  add_law(statistic::strahler, "bst", 1e300);
  add_law(statistic::height, "bst", 1e300);
  return true;
}();

}  // namespace
}  // namespace ramify::bench
