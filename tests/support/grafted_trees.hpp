#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "support/columns.hpp"
#include "support/goodness.hpp"
#include "support/sanitized.hpp"
#include "support/seed.hpp"
#include "support/uninterrupted.hpp"

#include "ramify/sample/tree_sampler.hpp"

namespace ramify::test {

using Look = std::function<void(const TreeMeasures&)>;

/// So many trees (sanitized.hpp), replicates 0, 1, ... of the tag's seed, sampled as the method says.
inline void sample(const Model& model, SamplingMethod method, Size n, std::uint64_t trees,
                   const std::string& tag, const Look& look) {
  const auto sampler = make_tree_sampler({model, method, n, &uninterrupted});
  const StreamKey key{seed_of(tag), model.stream_cell(n)};
  TreeMeasures measures;
  for (std::uint64_t replicate = 0; replicate < replicates(trees); ++replicate) {
    sampler->sample(n, key, replicate, measures);
    look(measures);
  }
}

/// A statistic that has a pass of its own and an exact law.
struct Single {
  std::string name;
  FoldSet pass;
  std::uint32_t TreeMeasures::* value;

  const Recurrence& recurrence() const { return column(name).statistic->law.recurrence; }
};

inline const std::vector<Single> singles{
    {"strahler", Folded::strahler, &TreeMeasures::strahler},
    {"height", Folded::height, &TreeMeasures::height},
    {"fill_level", Folded::fill_level, &TreeMeasures::fill_level},
    {"balance", Folded::balance, &TreeMeasures::balance},
    {"depth", Folded::depth, &TreeMeasures::depth},
    {"external_depth", Folded::external_depth, &TreeMeasures::external_depth}};

inline Tally tally_of(const Model& model, SamplingMethod method, Size n, std::uint64_t trees,
                      const std::string& tag, std::uint32_t TreeMeasures::* value) {
  Tally tally;
  sample(model, method, n, trees, tag, [&](const TreeMeasures& m) { ++tally[{m.*value, 0}]; });
  return tally;
}

/// How often 0, 1, ... came, as far as either the tally or `values` reach.
inline std::vector<std::uint64_t> counts_of(const Tally& tally, std::size_t values) {
  std::vector<std::uint64_t> counts(values, 0);
  for (const auto& [outcome, count] : tally) {
    counts.resize(std::max<std::size_t>(counts.size(), outcome.first + 1), 0);
    counts[outcome.first] = count;
  }
  return counts;
}

/// Counts of a tally against P(0), P(1), ...
/// @param truth  of a negative control: the law that the tally has in fact
inline Goodness chi_square_from_0(const std::string& what, const Tally& tally, std::vector<double> pmf,
                                  std::vector<double> truth = {}) {
  const auto counts = counts_of(tally, std::max(pmf.size(), truth.size()));
  pmf.resize(counts.size(), 0.0);
  if (!truth.empty()) truth.resize(counts.size(), 0.0);
  constexpr double least = 5;
  return chi_square(what, counts, pmf, least, truth);
}

}  // namespace ramify::test
