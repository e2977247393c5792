// ramify::Stream (Philox4x64-10) against PCG64 and xoshiro256**: a word, and the draws that trees are made
// of.
#include <vector>

#include "generators.hpp"
#include <benchmark/benchmark.h>
#include <boost/random/gamma_distribution.hpp>

#include "ramify/random/alias_table.hpp"
#include "ramify/random/stream.hpp"
#include "ramify/random/uniform.hpp"
#include "ramify/random/variates.hpp"

namespace ramify::bench {
namespace {

template <class Generator>
Generator make();
template <>
Stream make() {
  return Stream({1996, 7}, 0);
}
template <>
Pcg64 make() {
  return Pcg64(1996, 7);
}
template <>
Xoshiro256 make() {
  return Xoshiro256({1996, 7, 11, 13});
}

/// Time of one draw(generator), a batch of them an iteration.
template <class Generator, class Draw>
void time_draws(benchmark::State& state, const Draw& draw) {
  constexpr int batch = 4096;
  auto generator = make<Generator>();
  for (auto _ : state)
    for (int i = 0; i < batch; ++i) benchmark::DoNotOptimize(draw(generator));
  using benchmark::Counter;
  state.counters["per_draw"] = Counter(batch, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

template <class Generator>
void word(benchmark::State& state) {
  time_draws<Generator>(state, [](Generator& g) { return g(); });
}

template <class Generator>
void bounded(benchmark::State& state) {
  time_draws<Generator>(state, [](Generator& g) { return uniform_below(g, 1'000'003); });
}

template <class Generator>
void alias(benchmark::State& state) {
  std::vector<double> weights(128);
  for (std::size_t i = 0; i < weights.size(); ++i) weights[i] = static_cast<double>(i * (weights.size() - i));
  std::vector<AliasCell> cells(weights.size());
  build_alias_cells(weights, cells);
  time_draws<Generator>(state, [&](Generator& g) { return draw_alias(cells, g); });
}

template <class Generator>
void beta_10_10(benchmark::State& state) {
  time_draws<Generator>(state, [](Generator& g) { return beta_variate(g, 10, 10).x; });
}

template <class Generator>
void gamma_10(benchmark::State& state) {
  time_draws<Generator>(state, [](Generator& g) { return gamma_variate(g, 10); });
}

template <class Generator>
void gamma_10_of_boost(benchmark::State& state) {
  time_draws<Generator>(state, [](Generator& g) { return boost::random::gamma_distribution<double>(10)(g); });
}

template <class Generator>
void binomial_1000(benchmark::State& state) {
  time_draws<Generator>(state, [](Generator& g) { return binomial_variate(g, 1000, 0.23); });
}

#define RAMIFY_BENCH_GENERATORS(draw) \
  BENCHMARK_TEMPLATE(draw, Stream);   \
  BENCHMARK_TEMPLATE(draw, Pcg64);    \
  BENCHMARK_TEMPLATE(draw, Xoshiro256)

RAMIFY_BENCH_GENERATORS(word);
RAMIFY_BENCH_GENERATORS(bounded);
RAMIFY_BENCH_GENERATORS(alias);
RAMIFY_BENCH_GENERATORS(beta_10_10);
RAMIFY_BENCH_GENERATORS(gamma_10);
RAMIFY_BENCH_GENERATORS(gamma_10_of_boost);
RAMIFY_BENCH_GENERATORS(binomial_1000);

}  // namespace
}  // namespace ramify::bench
