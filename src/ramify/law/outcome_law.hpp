#pragma once

#include <map>
#include <utility>
#include <vector>

#include "ramify/core/cancellation.hpp"
#include "ramify/core/contract.hpp"
#include "ramify/core/error.hpp"
#include "ramify/law/choice_path.hpp"
#include "ramify/model/registry.hpp"
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

/// The outcomes of size n from those of all smaller sizes: the fold's join of every pair of them.
template <class F>
OutcomesOf<F> join_outcomes(const std::vector<double>& left_pmf, const std::vector<OutcomesOf<F>>& laws,
                            F& fold, ChoicePath& path) {
  using Value = typename F::Value;
  constexpr double negligible = 1e-30;
  const Size n = left_pmf.size();
  std::map<std::pair<Value, TallyOf<F>>, double> joined;
  for (Size left = 0; left < n; ++left) {
    const Pair<Size> sizes{left, n - 1 - left};
    for (const auto& a : laws[sizes[0]])
      for (const auto& b : laws[sizes[1]]) {
        const double weight = left_pmf[left] * a.probability * b.probability;
        if (weight < negligible) continue;
        path.clear();
        do {
          path.restart();
          const Value value = fold.join(n, sizes, Pair<Value>{a.value, b.value});
          TallyOf<F> tally = take_tally(fold);
          (tally += a.tally) += b.tally;
          joined[{value, tally}] += weight * path.probability();
        } while (path.next());
      }
  }
  double sum = 0;
  for (const auto& [outcome, probability] : joined) sum += probability;
  OutcomesOf<F> outcomes;
  for (const auto& [outcome, probability] : joined)
    outcomes.push_back({outcome.first, outcome.second, probability / sum});
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
    const auto left_pmf = std::visit([n](const auto& law) { return law.pmf(n); }, model.law());
    laws.push_back(detail::join_outcomes<F>(n == 1 ? std::vector{1.0} : left_pmf, laws, fold, path));
  }
  return laws;
}

}  // namespace ramify
