#include "ramify/large/large_law.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "ramify/core/contract.hpp"
#include "ramify/large/large_join.hpp"
#include "ramify/large/large_levels.hpp"
#include "ramify/large/large_node_sum.hpp"
#include "ramify/law/build_law.hpp"

namespace ramify {
namespace {

/// P(V >= k), k = 0, 1, ...: mean and variance, about the last value that is sure.
Moments moments_of_tail(const std::vector<double>& tail) {
  std::size_t sure = 0;
  while (sure + 1 < tail.size() && tail[sure + 1] >= 1) ++sure;
  double mean = 0, second = 0;
  for (std::size_t k = sure + 1; k < tail.size(); ++k) {
    mean += tail[k];
    second += (2 * static_cast<double>(k - sure) - 1) * tail[k];
  }
  return {static_cast<double>(sure) + mean, std::max(0.0, second - mean * mean)};
}

CompressedRows::LeftOut left_out(const Recurrence& recurrence) {
  const auto* join = std::get_if<BoundedJoin>(&recurrence);
  return join != nullptr && join->rule->takes_the_lower() ? CompressedRows::LeftOut::below_1e_42
                                                          : CompressedRows::LeftOut::below_1e_20;
}

}  // namespace

/// One computation, from one seam on one grid.
class LargeLaw::Solution {
 public:
  Solution(const Model& model, const Recurrence& recurrence, Size table, double step, double largest_n,
           const Cancellation& cancellation)
      : grid_(table, step, largest_n + 1), rows_(model, step, largest_n + 1, left_out(recurrence)) {
    const auto exact = [&](auto law) {
      return build_law(model, table + residue_reach, std::move(law), cancellation);
    };
    if (const auto* sum = std::get_if<NodeSum>(&recurrence)) {
      sum_.emplace(*sum, grid_, rows_, exact(NodeSumLaw(*sum)), cancellation);
    } else if (const auto* join = std::get_if<BoundedJoin>(&recurrence)) {
      const BoundedLaw law = exact(BoundedLaw(*join, table + residue_reach));
      if (join->rule->takes_the_lower())
        solve_lowest(law, cancellation);
      else
        join_.emplace(*join->rule, grid_, rows_, law, cancellation);
      tells_ties_ = join->rule->tells_ties();
    } else if (const auto* walk = std::get_if<WeightedWalk>(&recurrence)) {
      solve_walk(*walk, exact(DepthLaw(*walk)), cancellation);
    } else {
      RAMIFY_EXPECTS(std::holds_alternative<LongestPath>(recurrence));
      const HeightLaw law = exact(HeightLaw());
      levels_.emplace(
          LevelJoin{}, grid_, rows_, [&law](Size n, std::size_t h) { return law.above(n, h); }, cancellation);
    }
  }
  Solution(const Solution&) = delete;  // the computations refer to grid_
  Solution& operator=(const Solution&) = delete;
  Solution(Solution&&) = delete;
  Solution& operator=(Solution&&) = delete;
  ~Solution() = default;

  bool has_law() const { return !sum_; }

  /// What no solution sees of a law that tells ties: n modulo 8 and so on, three ties in a row of
  /// generations. 0 of others.
  double unseen(double n) const {
    if (!tells_ties_) return 0;
    double tie = 0;
    for (const SplitPlace& split : rows_.row(n + 1, Residue{1}).places) tie += split.equal ? split.weight : 0;
    return 2 * tie * tie * tie;
  }

  Moments moments(double n) const { return sum_ ? sum_->moments(n) : moments_of_tail(tail(n)); }

  /// P(V >= k), k = 0, 1, ...
  std::vector<double> tail(double n) const {
    if (join_) return join_->tail(n);
    std::vector<double> tail = levels_->levels(n + 1);
    if (of_the_lowest_) {
      for (double& p : tail) p = 1 - p;
    } else {
      tail.insert(tail.begin(), 1.0);
    }
    return tail;
  }

 private:
  /// 1 + the lower of the children's values, by P(V < k).
  void solve_lowest(const BoundedLaw& law, const Cancellation& cancellation) {
    of_the_lowest_ = true;
    const auto top = static_cast<std::size_t>(std::log2(static_cast<double>(law.sizes())));
    const auto below = [&](Size n, std::size_t k) {
      return k > top ? 1.0 : law.all_sizes(LawForm::below, static_cast<std::ptrdiff_t>(k))[n];
    };
    levels_.emplace(LevelJoin{nullptr, false}, grid_, rows_, below, cancellation);
  }

  void solve_walk(WeightedWalk walk, const DepthLaw& law, const Cancellation& cancellation) {
    const auto weight = static_cast<double>(walk.weight_of_none);
    const auto share = [weight](double child, double all) {
      return (child - 1 + weight) / (all - 2 + 2 * weight);
    };
    // P(depth > d), summed once for each size.
    std::vector<std::vector<double>> above(grid_.table_size() + 1);
    for (Size n = 0; n < above.size(); ++n) {
      above[n] = law.pmf(n);
      for (std::size_t i = above[n].size() - 1; i-- > 0;) above[n][i] += above[n][i + 1];
    }
    const auto table = [&](Size n, std::size_t d) {
      if (d < law.lowest(n)) return 1.0;
      const std::size_t i = d - law.lowest(n) + 1;
      return i < above[n].size() ? above[n][i] : 0.0;
    };
    levels_.emplace(LevelJoin{share, true}, grid_, rows_, table, cancellation);
  }

  SizeGrid grid_;
  CompressedRows rows_;
  bool tells_ties_ = false;
  bool of_the_lowest_ = false;  ///< levels_ are P(V < k), not P(V > k)
  std::optional<LargeJoin> join_;
  std::optional<LargeLevels> levels_;
  std::optional<LargeNodeSum> sum_;
};

LargeLaw::LargeLaw(const Model& model, const Recurrence& recurrence, const std::vector<double>& sizes,
                   const Cancellation& cancellation) {
  RAMIFY_EXPECTS(!sizes.empty() && no_large_laws(model).empty());
  const double largest = *std::ranges::max_element(sizes);
  const auto solve = [&](Size seam, double step) {
    return std::make_unique<Solution>(model, recurrence, seam, step, largest, cancellation);
  };
  const auto fine_enough = [&](const Refined<Solution>& solutions) {
    return std::ranges::all_of(sizes, [&](double n) {
      const LargeMoments moments = moments_of(solutions, n);
      return is_good(moments.mean) && is_good(moments.variance);
    });
  };
  solutions_ = std::make_unique<Refined<Solution>>(large_law_table(model), solve, fine_enough);
}

LargeLaw::LargeLaw(LargeLaw&&) noexcept = default;
LargeLaw& LargeLaw::operator=(LargeLaw&&) noexcept = default;
LargeLaw::~LargeLaw() = default;

LargeMoments LargeLaw::moments_of(const Refined<Solution>& solutions, double n) {
  const Moments fine = solutions.fine().moments(n), coarse = solutions.coarse().moments(n),
                early = solutions.early().moments(n);
  LargeMoments moments{Refined<Solution>::combined(fine.mean, coarse.mean, early.mean),
                       Refined<Solution>::combined(fine.variance, coarse.variance, early.variance)};
  const double unseen = solutions.fine().unseen(n);
  moments.mean.error += unseen;
  moments.variance.error += unseen;
  return moments;
}

LargeMoments LargeLaw::moments(double n) const {
  return moments_of(*solutions_, n);
}

std::optional<LargeFiniteLaw> LargeLaw::law(double n) const {
  if (!solutions_->fine().has_law()) return std::nullopt;
  std::array tails{solutions_->fine().tail(n), solutions_->coarse().tail(n), solutions_->early().tail(n)};
  std::size_t values = 0;
  for (const auto& tail : tails) values = std::max(values, tail.size());
  for (auto& tail : tails) tail.resize(values + 1, 0.0);
  LargeFiniteLaw law{0, {}};
  const double unseen = solutions_->fine().unseen(n);
  const auto is_nothing = [](const Approximation& p) { return p.value <= p.error && p.value < 1e-12; };
  for (std::size_t k = 0; k < values; ++k) {
    const auto probability = [&](std::size_t s) { return std::max(0.0, tails[s][k] - tails[s][k + 1]); };
    Approximation p = Refined<Solution>::combined(probability(0), probability(1), probability(2));
    if (tails[0][k] > 0.5) p.error += Refined<Solution>::rounding;  // a difference of what is nearly 1
    p.error += unseen;
    if (law.probabilities.empty()) law.first = static_cast<double>(k);
    if (!is_nothing(p) || !law.probabilities.empty()) law.probabilities.push_back(p);
  }
  while (!law.probabilities.empty() && is_nothing(law.probabilities.back())) law.probabilities.pop_back();
  return law;
}

LargeFiniteLaw LargeFiniteLaw::mapped(AffineMap map) const {
  RAMIFY_EXPECTS(map.factor == 1);
  return {first + map.shift, probabilities};
}

LargeMoments LargeMoments::mapped(AffineMap map) const {
  const double square = map.factor * map.factor;
  return {{map.factor * mean.value + map.shift, std::abs(map.factor) * mean.error},
          {square * variance.value, square * variance.error}};
}

}  // namespace ramify
