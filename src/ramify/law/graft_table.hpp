#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "ramify/core/contract.hpp"
#include "ramify/law/outcome_law.hpp"
#include "ramify/random/alias_table.hpp"
#include "ramify/tree/tally.hpp"

namespace ramify {

/// Alias tables of what a fold makes of whole trees, for every size 0..sizes()-1. Immutable once filled, and
/// then shared by all threads.
///
/// A joint law has thousands of outcomes, most of them rare. Those that come up 99 times in 100 have a small
/// table of their own, which stays in the cache, with one more column for all others.
template <class Value, class Tally>
class GraftTable {
 public:
  using Law = std::vector<Outcome<Value, Tally>>;

  Size sizes() const { return places_.size(); }

  /// Adds the law of the size sizes(). O(outcomes log outcomes).
  void append(Law law) {
    std::stable_sort(law.begin(), law.end(),
                     [](const auto& a, const auto& b) { return a.probability > b.probability; });
    std::vector<double> weights;
    for (const auto& outcome : law) weights.push_back(outcome.probability);
    const std::size_t frequent = count_frequent(weights);
    places_.push_back({cells_.size(), results_.size(), frequent, weights.size() - frequent});
    const std::vector<double> rare(weights.begin() + static_cast<std::ptrdiff_t>(frequent), weights.end());
    weights.resize(frequent);
    if (!rare.empty()) weights.push_back(std::accumulate(rare.begin(), rare.end(), 0.0));
    append_cells(weights);
    if (!rare.empty()) append_cells(rare);
    for (const auto& outcome : law) results_.push_back({outcome.value, outcome.tally});
  }

  /// What the fold makes of a whole tree.
  struct Result {
    Value value;
    [[no_unique_address]] Tally tally;
  };

  /// Draws a whole tree of size 1 <= n < sizes(). One word, seldom two; O(1).
  template <class Urbg>
  const Result& drawn(Size n, Urbg& stream) const {
    const Place& place = places_[n];
    const std::size_t columns = place.frequent + (place.rare > 0 ? 1 : 0);
    std::size_t column = draw_alias(std::span(cells_.data() + place.cells, columns), stream);
    if (column == place.frequent)
      column += draw_alias(std::span(cells_.data() + place.cells + columns, place.rare), stream);
    return results_[place.results + column];
  }

  /// The same: gives its value, adds its tally to the fold.
  template <class Urbg, class F>
  Value draw(Size n, Urbg& stream, F& fold) const {
    const Result& result = drawn(n, stream);
    add_tally(fold, n, result.tally);
    return result.value;
  }

 private:
  struct Place {
    std::size_t cells, results, frequent, rare;
  };

  /// How many of the descending weights make up 99 in 100; all, where the others would save nothing.
  static std::size_t count_frequent(const std::vector<double>& weights) {
    constexpr double share = 0.99;
    constexpr std::size_t worth_it = 64;
    double sum = 0;
    std::size_t count = 0;
    while (count < weights.size() && sum < share) sum += weights[count++];
    return weights.size() - count < worth_it ? weights.size() : count;
  }

  void append_cells(const std::vector<double>& weights) {
    cells_.resize(cells_.size() + weights.size());
    build_alias_cells(weights, std::span(cells_).last(weights.size()));
  }

  std::vector<Place> places_;
  std::vector<AliasCell> cells_;
  std::vector<Result> results_;
};

/// A graft policy (graft.hpp): trees of a size up to `largest` are drawn from a table.
template <class Table>
class Graft {
 public:
  /// @param table    must outlive the policy, and hold the sizes 0..largest
  Graft(const Table& table, Size largest) : table_(&table), largest_(largest) {
    RAMIFY_EXPECTS(largest < table.sizes());
  }

  bool covers(Size n) const { return n <= largest_; }

  template <class Urbg, class F>
  auto draw(Size n, Urbg& stream, F& fold) const {
    return table_->draw(n, stream, fold);
  }

 private:
  const Table* table_;
  Size largest_;
};

}  // namespace ramify
