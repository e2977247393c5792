#include "ramify/law/order_moments.hpp"

namespace ramify {

OrderMoments::OrderMoments(const OrderMeans& means, Size largest_n)
    : means_(&means), given_order_(means, largest_n), second_(given_order_.counts()) {
  for (std::size_t a = 0; a < second_.size(); ++a) {
    second_[a].resize(a + 1);
    for (std::size_t b = 0; b <= a; ++b) {
      second_[a][b].reserve(largest_n + 1);
      second_[a][b].append(given_order_.slope(a) * given_order_.slope(b));
    }
  }
}

/// E[e_a (Y_L + Y_R)_b].
double OrderMoments::root_product(std::size_t a, std::size_t b,
                                  const ConditionalOrderMeans::Step& step) const {
  const ConditionalOrderMeans::Joined& of_b = step.joined[b][given_order_.order_of(a)];
  return given_order_.counts_streams(a) ? of_b.born : of_b.all;
}

void OrderMoments::extend(const SplitRow& row) {
  const auto step = given_order_.step(row);
  for (std::size_t a = 0; a < second_.size(); ++a) {
    const std::size_t order = given_order_.order_of(a);
    for (std::size_t b = 0; b <= a; ++b) {
      const SizeSeries &mean_a = given_order_.centred(a), &mean_b = given_order_.centred(b);
      double value = over_children(row, second_[a][b]) + over_children(row, mean_a, mean_b) +
                     over_children(row, mean_b, mean_a) + root_product(a, b, step) + root_product(b, a, step);
      // e_a e_b = 1 where both count the root: as a node of the order, and, for streams, as one that begins.
      if (order == given_order_.order_of(b))
        value += given_order_.added(a, order, step);  // a counts streams if b does
      second_[a][b].append(value);
    }
  }
  given_order_.append(step);
}

double OrderMoments::covariance(Size n, OrderCount a, OrderCount b) const {
  if (std::min(a.order, b.order) == 0 || std::max(a.order, b.order) > given_order_.largest_order()) return 0;
  const auto [j, i] = std::minmax({given_order_.index(a), given_order_.index(b)});
  return second_[i][j][n] - given_order_.centred(i)[n] * given_order_.centred(j)[n];
}

}  // namespace ramify
