#pragma once

#include <algorithm>
#include <map>
#include <span>
#include <vector>

#include "ramify/core/cancellation.hpp"
#include "ramify/core/contract.hpp"
#include "ramify/core/error.hpp"
#include "ramify/law/choice_path.hpp"
#include "ramify/model/model.hpp"
#include "ramify/tree/fold.hpp"
#include "ramify/tree/tally.hpp"

namespace ramify {

/// What a fold can make of a tree, and how likely it is.
template <class Value, class Tally>
struct Outcome {
  Value value;
  Tally tally;
  double probability;
};

/// The outcomes of one size, ordered by value and tally.
template <class F>
using OutcomesOf = std::vector<Outcome<typename F::Value, TallyOf<F>>>;

namespace detail {

/// The outcomes that share one value, which is all that a join sees of them: calls visit(value, them) in
/// turn.
template <class Value, class Tally, class Visit>
void each_value(const std::vector<Outcome<Value, Tally>>& outcomes, Visit visit) {
  for (auto begin = outcomes.begin(); begin != outcomes.end();) {
    const auto end =
        std::find_if(begin, outcomes.end(), [&](const auto& o) { return o.value != begin->value; });
    visit(begin->value, std::span(begin, end));
    begin = end;
  }
}

/// Adds weight times the law of a.tally + b.tally + added.
template <class Value, class Tally>
void add_sums(std::span<const Outcome<Value, Tally>> as, std::span<const Outcome<Value, Tally>> bs,
              const Tally& added, double weight, std::map<Tally, double>& sums) {
  constexpr double negligible = 1e-30;
  for (const auto& a : as)
    for (const auto& b : bs) {
      const double probability = weight * a.probability * b.probability;
      if (probability < negligible) continue;
      Tally tally = added;
      (tally += a.tally) += b.tally;
      sums[tally] += probability;
    }
}

/// The outcomes of size n from those of all smaller sizes: the fold's join of every pair of them.
template <class F>
OutcomesOf<F> join_outcomes(const std::vector<double>& left_pmf, const std::vector<OutcomesOf<F>>& laws,
                            F& fold, ChoicePath& path) {
  using Value = typename F::Value;
  const Size n = left_pmf.size();
  std::map<Value, std::map<TallyOf<F>, double>> joined;
  for (Size left = 0; left < n; ++left) {
    const Pair<Size> sizes{left, n - 1 - left};
    each_value(laws[sizes[0]], [&](const Value& a, auto as) {
      each_value(laws[sizes[1]], [&](const Value& b, auto bs) {
        path.clear();
        do {
          path.restart();
          const Value value = fold.join(n, sizes, Pair<Value>{a, b});
          const TallyOf<F> added = take_tally(fold);
          add_sums(as, bs, added, left_pmf[left] * path.probability(), joined[value]);
        } while (path.next());
      });
    });
  }
  OutcomesOf<F> outcomes;
  double sum = 0;
  for (const auto& [value, tallies] : joined)
    for (const auto& [tally, probability] : tallies) {
      outcomes.push_back({value, tally, probability});
      sum += probability;
    }
  for (auto& outcome : outcomes) outcome.probability /= sum;
  return outcomes;
}

}  // namespace detail

/// The exact joint law of a fold's value and tally for every size 0..largest: the fold's own join applied to
/// outcomes instead of values. The generic engine: any fold, any split law, no recurrence of its own.
///
/// Sums of positive terms, scaled to sum 1: relative error of a probability about n 2^-53. Pairs of outcomes
/// less likely than 1e-30 are left out. Cost of a size: over all splits, the product of the children's
/// numbers of outcomes. Throws Interrupted when cancelled.
/// @param make_fold  fold from a ChoicePath& that its walk, if it has one, must follow (choice_path.hpp); its
///                   values are ordered
/// @param largest    at most largest_tallied of the fold
template <class MakeFold>
auto outcome_laws(const Model& model, Size largest, MakeFold make_fold,
                  const Cancellation& cancellation = {}) {
  ChoicePath path;
  auto fold = make_fold(path);
  using F = decltype(fold);
  static_assert(Fold<F, Size>);
  RAMIFY_EXPECTS(largest <= largest_tallied<F>());
  std::vector<OutcomesOf<F>> laws{{{fold.external(), TallyOf<F>(), 1.0}}};
  for (Size n = 1; n <= largest; ++n) {
    if (cancellation.requested()) throw Interrupted();
    const auto left_pmf = split_pmf(model, n);
    laws.push_back(detail::join_outcomes<F>(n == 1 ? std::vector{1.0} : left_pmf, laws, fold, path));
  }
  return laws;
}

}  // namespace ramify
