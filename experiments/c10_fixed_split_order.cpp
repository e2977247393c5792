// C10, Fact 3.2 (Kruszewski 1996): the deterministic split tree of a constant X <= 1/2 has S <= log_(1/X) n +
// 1. Proved there by induction on the smaller subtree, of size X n at most; met with equality at n = 4, X =
// 1/4.
//
// So that equality is no matter of rounding, S - 1 <= log_(1/X) n is asked as X^-(S-1) <= n, in whole numbers
// of the fraction as it is written.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "claim.hpp"
#include "exact_range.hpp"
#include "one_way_trees.hpp"
#include <boost/multiprecision/cpp_int.hpp>
#include <fmt/format.h>

#include "ramify/core/rational.hpp"

namespace ramify {
namespace {

constexpr Size fact_32_to = 100'000;
constexpr std::array fractions{"1/2",    "0.49", "0.4",    "1/2.74", "1/3",  "0.3", "1/4",
                               "1/4.35", "0.2",  "1/7.05", "0.1",    "0.05", "0.01"};

/// The smallest n of order S that the bound allows, ceil(X^-(S-1)), S = 1, 2, ..., up to the largest order
/// here.
std::vector<Size> smallest_allowed(const Rational& x) {
  using boost::multiprecision::cpp_int;
  cpp_int above = 1, below = 1;
  std::vector<Size> smallest;
  while (above <= cpp_int(fact_32_to) * below) {
    smallest.push_back(static_cast<Size>((above + below - 1) / below));
    above *= x.denominator;
    below *= x.numerator;
  }
  return smallest;
}

std::size_t sizes_that_break(const char* x, const Cancellation& cancellation) {
  const auto orders = one_way_orders(Model::parse(fmt::format("split({})", x)), fact_32_to, cancellation);
  const auto smallest = smallest_allowed(Rational::parse(x).value());
  std::size_t broken = 0;
  for (Size n = 1; n <= fact_32_to; ++n)
    broken += orders[n] > smallest.size() || n < smallest[orders[n] - 1u] ? 1 : 0;
  return broken;
}

Basis broken_bounds(const Cancellation& cancellation) {
  ExactRange broken;
  for (const char* x : fractions) broken.add(static_cast<double>(sizes_that_break(x, cancellation)));
  return broken.basis(
      static_cast<double>(fact_32_to),
      fmt::format("every n to {} of {} X from 0.01 to 1/2, in whole numbers", fact_32_to, fractions.size()));
}

/// S of every size beneath the bound, which X = 1/4 touches at n = 4.
std::vector<NamedPlot> orders_below_the_bound(const Evidence& evidence) {
  Plot plot{"Horton-Strahler number of deterministic split trees",
            "exact, every n; dashed: the bound log_(1/X) n + 1", "n (internal nodes)", "S(T) (leaf order 0)",
            true};
  for (const char* x : {"1/2", "1/4", "0.1"}) {
    const Model model = Model::parse(fmt::format("split({})", x));
    const auto orders = one_way_orders(model, fact_32_to, evidence.cancellation);
    PlotSeries series{fmt::format("X = {}", x)};
    const double log_base = -std::log(model.parameters().front());
    for (Size n = 1; n <= fact_32_to; ++n) {
      const bool is_drawn = n == 1 || n == fact_32_to || orders[n] != orders[n - 1] ||
                            orders[n] != orders[std::min(n + 1, fact_32_to)];
      if (!is_drawn) continue;
      const auto size = static_cast<double>(n);
      series.curve.push_back({size, static_cast<double>(orders[n])});
      series.guide.push_back({size, std::log(size) / log_base + 1});
    }
    plot.series.push_back(std::move(series));
  }
  return {{"C10_split_order", std::move(plot)}};
}

}  // namespace

Claim fixed_split_order_claim() {
  const Statement bound{"C10.1",
                        "S <= log_(1/X) n + 1: sizes that break it, X <= 1/2",
                        "K96 Fact 3.2",
                        "order of the root, leaf order 0",
                        Relation::equals,
                        "0",
                        0,
                        {{"1, a single size", 1}},
                        std::nullopt};
  return {"C10",
          "S <= log_(1/X) n + 1 of deterministic split trees",
          "K96 Fact 3.2",
          {part_without_trees(bound, [](const Evidence& e) { return broken_bounds(e.cancellation); })},
          {},
          orders_below_the_bound};
}

}  // namespace ramify
