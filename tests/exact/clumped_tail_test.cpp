// The tail that clumped_count_z takes for that of a total count, against the exact law of the total: the law
// of the nodes or streams of one order in one tree by a recurrence of its own, and its T-th power.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <boost/math/special_functions/erf.hpp>
#include <gtest/gtest.h>

#include "ramify/compare/clumped_count.hpp"
#include "ramify/model/model.hpp"
#include "ramify/statistic/order_count.hpp"

namespace ramify {
namespace {

using Probabilities = std::vector<double>;

/// P of every order below k, and, where the order is k or more, of every count of order k.
struct CountLaw {
  Probabilities orders, with_k, above_k;
};

/// Adds w times the law of a sum where one child has nothing to count.
void add_beside(const Probabilities& counts, double weight, std::size_t more, Probabilities& sum) {
  for (std::size_t c = 0; c < counts.size(); ++c)
    if (counts[c] > 0) sum[c + more] += weight * counts[c];
}

void add_both(const CountLaw& a, const CountLaw& b, double weight, Probabilities& sum) {
  for (std::size_t i = 0; i < a.with_k.size(); ++i)
    for (std::size_t j = 0; j < b.with_k.size(); ++j)
      if (i + j < sum.size())
        sum[i + j] += weight * (a.with_k[i] + a.above_k[i]) * (b.with_k[j] + b.above_k[j]);
}

double total(const Probabilities& law) {
  double sum = 0;
  for (const double p : law) sum += p;
  return sum;
}

/// The parent of an a-tree and a b-tree, with a weight.
void add_parent(const CountLaw& a, const CountLaw& b, double weight, std::size_t chain, CountLaw& parent) {
  const std::size_t k = a.orders.size();
  for (std::size_t s = 0; s < k; ++s)
    for (std::size_t t = 0; t < k; ++t) {
      const std::size_t order = s == t ? s + 1 : std::max(s, t);
      const double p = weight * a.orders[s] * b.orders[t];
      if (order < k)
        parent.orders[order] += p;
      else
        parent.with_k[1] += p;
    }
  const double a_low = total(a.orders), b_low = total(b.orders);
  add_beside(a.with_k, weight * b_low, chain, parent.with_k);
  add_beside(b.with_k, weight * a_low, chain, parent.with_k);
  add_beside(a.above_k, weight * b_low, 0, parent.above_k);
  add_beside(b.above_k, weight * a_low, 0, parent.above_k);
  add_both(a, b, weight, parent.above_k);
}

/// P(N_k = 0, 1, ...) or of M_k in one tree of n nodes, k >= 1.
Probabilities law_of_count(const Model& model, Size n, OrderCount count) {
  std::vector<CountLaw> laws{{Probabilities(count.order), {0}, {0}}};
  laws.front().orders.front() = 1;
  const std::size_t chain = count.of == OrderCount::Of::nodes ? 1 : 0;
  for (Size size = 1; size <= n; ++size) {
    CountLaw law{Probabilities(count.order), Probabilities(size + 1), Probabilities(size + 1)};
    const WeightWindow window = model.window(size, 1e-30);
    const double sum = total(window.weights);
    for (std::size_t i = 0; i < window.weights.size(); ++i) {
      const Size left = window.first + i;
      add_parent(laws[left], laws[size - 1 - left], window.weights[i] / sum, chain, law);
    }
    laws.push_back(std::move(law));
  }
  Probabilities counts(n + 1);
  for (std::size_t c = 1; c < counts.size(); ++c) counts[c] = laws[n].with_k[c] + laws[n].above_k[c];
  counts[0] = 1 - total(counts);
  return counts;
}

/// Of the sum of T such counts, up to a largest: f^T as a power series.
Probabilities power_of_law(const Probabilities& f, double trees, std::size_t largest) {
  Probabilities law{std::exp(trees * std::log(f[0]))};
  for (std::size_t x = 1; x <= largest; ++x) {
    double sum = 0;
    for (std::size_t j = 1; j <= std::min(x, f.size() - 1); ++j)
      sum += (static_cast<double>(j) * (trees + 1) - static_cast<double>(x)) * f[j] * law[x - j];
    law.push_back(std::max(0.0, sum / (static_cast<double>(x) * f[0])));
  }
  return law;
}

struct TailCase {
  const char* model;
  Size n;
  OrderCount count;
  double trees;
};

/// The chance by clumps over the exact one, where that is first below a millionth.
double tail_by_clumps_over_exact(const TailCase& of) {
  const Probabilities one = law_of_count(Model::parse(of.model), of.n, of.count);
  double mean = 0, square = 0;
  for (std::size_t c = 0; c < one.size(); ++c) {
    mean += static_cast<double>(c) * one[c];
    square += static_cast<double>(c * c) * one[c];
  }
  const double variance = of.trees * (square - mean * mean), expected = of.trees * mean;
  const Probabilities sum =
      power_of_law(one, of.trees, static_cast<std::size_t>(expected + 30 * std::sqrt(variance)) + 100);
  double tail = 0;
  std::size_t x = sum.size();
  while (x > 0 && tail + sum[x - 1] < 1e-6) tail += sum[--x];
  const double z = clumped_count_z(static_cast<double>(x), expected, variance);
  const double by_clumps = boost::math::erfc(z / std::sqrt(2.0)) / 2;
  std::cout << "  " << of.model << " n = " << of.n << " T = " << of.trees << ": exact " << tail << ", clumps "
            << by_clumps << '\n';
  return by_clumps / tail;
}

// As docs/validation.md has them; the normal tail is off by 2 to 170 powers of ten but for the BST. Takes a
// second: all pairs of counts of all splits to n = 300.
TEST(ClumpedTail, IsThatOfTheExactLawOfATotalOrAboveIt) {
  using enum OrderCount::Of;
  for (const TailCase& of : {TailCase{"catalan", 100, {nodes, 5}, 1000},
                             {"catalan", 100, {nodes, 5}, 10'000},
                             {"catalan", 100, {streams, 5}, 10'000},
                             {"catalan", 300, {nodes, 6}, 1000},
                             {"bst", 100, {nodes, 5}, 1000},
                             {"patricia(0.23)", 100, {nodes, 5}, 1000}}) {
    const double ratio = tail_by_clumps_over_exact(of);
    EXPECT_GT(ratio, 0.9) << of.model;
    EXPECT_LT(ratio, 5) << of.model;
  }
}

}  // namespace
}  // namespace ramify
