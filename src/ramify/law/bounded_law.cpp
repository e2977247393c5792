#include "ramify/law/bounded_law.hpp"

#include <algorithm>
#include <numeric>

#include "ramify/core/contract.hpp"
#include "ramify/statistic/horton_strahler.hpp"

namespace ramify {
namespace {

constexpr double negligible_probability = 1e-40;
constexpr double reported = 1e-30;

}  // namespace

BoundedLaw::BoundedLaw(BoundedJoin join, Size largest_n)
    : rule_(*join.rule), top_(static_cast<std::ptrdiff_t>(HortonStrahler::largest_order(largest_n))) {
  for (auto& form : series_) {
    form.resize(static_cast<std::size_t>(top_) + 3);
    for (auto& of_value : form) of_value.reserve(largest_n + 1);
  }
  std::vector<double> external(static_cast<std::size_t>(top_) + 1, 0.0);
  external[0] = 1;
  append(external);
}

void BoundedLaw::extend(const SplitRow& row) {
  RAMIFY_EXPECTS(row.n == sizes());
  const Size last = row.smaller(row.weights.size() - 1);
  const bool has_equal = last == row.n - 1 - last;
  const std::size_t count = row.weights.size() - (has_equal ? 1 : 0);
  const SplitRow unequal{row.n, row.first, row.weights.first(count)};
  const SplitRow equal{row.n, row.first + count, row.weights.subspan(count)};
  std::vector<double> out(static_cast<std::size_t>(top_) + 1, 0.0);
  const auto top = static_cast<std::ptrdiff_t>(HortonStrahler::largest_order(row.n));
  for (std::ptrdiff_t k = 0; k <= top; ++k) {
    const auto ways = [&](const SplitRow& part, const JoinTerm& term) {
      return over_children(part, series(term.smaller, k + term.smaller_shift),
                           series(term.larger, k + term.larger_shift));
    };
    for (const JoinTerm& term : rule_.unequal) out[static_cast<std::size_t>(k)] += ways(unequal, term);
    for (const JoinTerm& term : rule_.equal) out[static_cast<std::size_t>(k)] += ways(equal, term);
  }
  append(out);
}

void BoundedLaw::append(const std::vector<double>& weights) {
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  const auto probability = [&](std::ptrdiff_t k) {
    if (k < 0 || k > top_) return 0.0;
    const double p = weights[static_cast<std::size_t>(k)] / sum;
    return p < negligible_probability ? 0.0 : p;
  };
  double below = 0, from = 0;
  for (std::ptrdiff_t k = -1; k <= top_ + 1; ++k) {
    series(LawForm::at, k).append(probability(k));
    series(LawForm::below, k).append(below);
    below = std::min(1.0, below + probability(k));
  }
  for (std::ptrdiff_t k = top_ + 1; k >= -1; --k) {
    from = k < 0 ? 1.0 : std::min(1.0, from + probability(k));
    series(LawForm::from, k).append(from);
  }
  ++sizes_;
}

std::vector<double> BoundedLaw::pmf(Size n) const {
  std::vector<double> probabilities;
  for (std::ptrdiff_t k = 0; k <= top_; ++k) probabilities.push_back(at(n, k) < reported ? 0 : at(n, k));
  return probabilities;
}

double BoundedLaw::at(Size n, std::ptrdiff_t k) const {
  RAMIFY_EXPECTS(n < sizes());
  return k < 0 || k > top_ ? 0 : series(LawForm::at, k)[n];
}

}  // namespace ramify
