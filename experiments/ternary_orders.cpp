#include "ternary_orders.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <ranges>
#include <string>
#include <utility>
#include <vector>

#include "ramify/core/contract.hpp"
#include "ramify/model/formula.hpp"
#include "ramify/model/node_dependent.hpp"
#include "ramify/model/ternary.hpp"
#include "ramify/tree/largest_order.hpp"

namespace ramify {
namespace {

/// Nodes alike: of so many nodes from them down, and as deep; where the depth is no matter it is 1.
using Kind = std::pair<Size, Size>;

/// "1/4.8" of ternary(1/4.8).
std::string formula_of(const Model& model) {
  const std::string& text = model.text();
  const auto open = text.find('('), close = text.rfind(')');
  return text.substr(open + 1, close - open - 1);
}

/// P(Bin(size, p) = x | x <= size/2), x = 0, 1, ...
std::vector<double> third_child_law(Size size, double p) {
  const Size highest = size / 2;
  const Size mode = std::min(highest, static_cast<Size>(static_cast<double>(size + 1) * p));
  std::vector<double> law(highest + 1);
  law[mode] = 1;
  const auto step = [&](Size x) {  // from x to x+1
    return static_cast<double>(size - x) / static_cast<double>(x + 1) * p / (1 - p);
  };
  for (Size x = mode; x < highest; ++x) law[x + 1] = law[x] * step(x);
  for (Size x = mode; x > 0; --x) law[x - 1] = law[x] / step(x - 1);
  double sum = 0;
  for (const double weight : law) sum += weight;
  for (double& weight : law) weight /= sum;
  return law;
}

/// What is kept of all nodes of a kind. Orders are 0..K; index s+1 stands for "at most s", so that 0 is
/// never.
struct OrdersBelow {
  explicit OrdersBelow(std::size_t orders)
      : at_most(orders + 1),
        means(orders),
        given(orders, std::vector<double>(orders + 1)),
        products(orders, std::vector<double>(orders)) {}

  std::vector<double> at_most;                // P(S <= s)
  std::vector<double> means;                  // E M_k
  std::vector<std::vector<double>> given;     // E[M_k; S <= s]
  std::vector<std::vector<double>> products;  // E[M_j M_k], j <= k
};

/// Three children, independent of each other.
class Siblings {
 public:
  Siblings(const OrdersBelow& a, const OrdersBelow& b, const OrdersBelow& c) : of_{&a, &b, &c} {}

  /// P(S <= s) of their parent: all are below s, or all but one that has it.
  double at_most(std::size_t s) const {
    double sum = all_at_most(s);
    for (std::size_t i = 0; i < 3; ++i) sum += has(i, s) * others_at_most(i, s);
    return sum;
  }

  /// P(a stream of order s begins at the parent): all are below s, and more than one of them has s-1.
  double born(std::size_t s) const { return s == 0 ? 0 : all_at_most(s) - at_most(s - 1); }

  /// E[M_k of all three; all of them have orders below s].
  double mean_below(std::size_t k, std::size_t s) const {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += of_[i]->given[k][s] * others_at_most(i, s);
    return sum;
  }

  /// E[M_k of all three; S <= s of their parent].
  double mean_at_most(std::size_t k, std::size_t s) const {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, l = (i + 2) % 3;
      sum += of_[i]->given[k][s + 1] * others_at_most(i, s) +
             of_[i]->given[k][s] * (has(j, s) * below(l, s) + has(l, s) * below(j, s));
    }
    return sum;
  }

  /// E[M_k of all three; a stream of order s begins at their parent].
  double mean_born(std::size_t k, std::size_t s) const {
    return s == 0 ? 0 : mean_below(k, s) - mean_at_most(k, s - 1);
  }

  double mean(std::size_t k) const { return of_[0]->means[k] + of_[1]->means[k] + of_[2]->means[k]; }

  /// E of the product of the counts of all three.
  double product(std::size_t j, std::size_t k) const {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
      sum += of_[i]->products[j][k] + of_[i]->means[j] * (mean(k) - of_[i]->means[k]);
    return sum;
  }

 private:
  double below(std::size_t i, std::size_t s) const { return of_[i]->at_most[s]; }
  double has(std::size_t i, std::size_t s) const { return of_[i]->at_most[s + 1] - of_[i]->at_most[s]; }
  double all_at_most(std::size_t s) const { return below(0, s) * below(1, s) * below(2, s); }
  double others_at_most(std::size_t i, std::size_t s) const {
    return below((i + 1) % 3, s) * below((i + 2) % 3, s);
  }

  std::array<const OrdersBelow*, 3> of_;
};

/// Adds what the parent of the three has, with a weight.
void add(const Siblings& children, double weight, OrdersBelow& parent) {
  const std::size_t orders = parent.means.size();
  std::vector<double> born(orders);
  for (std::size_t s = 0; s < orders; ++s) {
    parent.at_most[s + 1] += weight * children.at_most(s);
    born[s] = children.born(s);
  }
  for (std::size_t k = 1; k < orders; ++k) {
    parent.means[k] += weight * (children.mean(k) + born[k]);
    for (std::size_t s = 1; s < orders; ++s)
      parent.given[k][s + 1] += weight * (children.mean_at_most(k, s) + (k <= s ? born[k] : 0));
    for (std::size_t j = 1; j <= k; ++j)
      parent.products[j][k] += weight * (children.product(j, k) + children.mean_born(j, k) +
                                         children.mean_born(k, j) + (j == k ? born[k] : 0));
  }
}

/// Every kind of node that a tree has, from the leaves to the root.
class TernaryNodes {
 public:
  TernaryNodes(const Model& model, Size n, const Cancellation& cancellation)
      : p_(formula_of(model), model.text()),
        by_depth_(model.is(NodeTernary::info())),
        n_(n),
        orders_(largest_strahler_order(2 * n + 1) + 1),
        cancellation_(&cancellation) {
    find_kinds();
  }

  /// What the root has.
  OrdersBelow solve() {
    std::map<Kind, OrdersBelow> solved;
    for (const auto& [kind, visits] : std::ranges::reverse_view(visits_)) {
      if (cancellation_->requested()) throw Interrupted();
      OrdersBelow below(orders_);
      if (kind.first == 0)
        std::ranges::fill(below.at_most | std::views::drop(1), 1.0);
      else
        for_each_split(kind, visits, [&](const std::array<Kind, 3>& children, double weight) {
          add({solved.at(children[0]), solved.at(children[1]), solved.at(children[2])}, weight, below);
        });
      solved.emplace(kind, std::move(below));
    }
    return std::move(solved.at(root()));
  }

 private:
  Kind root() const { return {n_, 1}; }

  /// How often nodes of every kind are expected, largest first: the map grows behind the kind at hand.
  void find_kinds() {
    visits_[root()] = 1;
    for (const auto& [kind, times] : visits_) {
      const double visits = times;
      if (kind.first == 0) continue;
      for_each_split(kind, visits, [&](const std::array<Kind, 3>& children, double weight) {
        for (const Kind& child : children) visits_[child] += visits * weight;
      });
    }
  }

  template <class Use>
  void for_each_split(const Kind& kind, double visits, const Use& use) {
    constexpr double never = 1e-18;
    const auto [size, depth] = kind;
    const auto law = third_child_law(size, p_({size, depth, n_}));
    for (Size third = 0; third < law.size(); ++third) {
      if (visits * law[third] < never) continue;
      const Size second = third > 0 ? third - 1 : 0, below = by_depth_ ? depth + 1 : depth;
      use(std::array<Kind, 3>{{{size - 1 - second - third, below}, {second, below}, {third, below}}},
          law[third]);
    }
  }

  Formula p_;
  bool by_depth_;
  Size n_;
  std::size_t orders_;
  const Cancellation* cancellation_;
  std::map<Kind, double, std::greater<>> visits_;
};

}  // namespace

StreamCounts ternary_stream_counts(const Model& model, Size n, const Cancellation& cancellation) {
  RAMIFY_EXPECTS(n > 0 && (model.is(Ternary::info()) || model.is(NodeTernary::info())));
  const OrdersBelow root = TernaryNodes(model, n, cancellation).solve();
  const std::size_t orders = root.means.size();
  StreamCounts counts;
  counts.means = root.means;
  counts.means[0] = 2 * static_cast<double>(n) + 1;
  for (std::size_t s = 0; s <= orders; ++s) counts.order_tail.push_back(std::max(0.0, 1 - root.at_most[s]));
  counts.covariances.assign(orders * orders, 0);
  for (std::size_t k = 1; k < orders; ++k)
    for (std::size_t j = 1; j <= k; ++j)
      counts.covariances[j * orders + k] = counts.covariances[k * orders + j] =
          root.products[j][k] - root.means[j] * root.means[k];
  return counts;
}

Interval ternary_orders_left(double p, double n, double chance) {
  RAMIFY_EXPECTS(p <= 1.0 / 3 && n >= 1);
  const double half_log = (std::log(4 / chance) + std::log(n)) / 2;
  const auto scatter = [&](double size) { return std::sqrt(size * half_log); };
  const auto least_child = [&](double size) {
    return std::min(p * size - scatter(size) - 1, (1 - 2 * p) * size - 2 * scatter(size));
  };
  const auto largest_side = [&](double size) { return std::min(size / 2, p * size + scatter(size)); };
  Interval orders{0, 0};
  for (double size = n; size >= 1; size = least_child(size)) ++orders.lower;
  for (double size = n; size >= 1; size = largest_side(size)) ++orders.upper;
  return orders;
}

}  // namespace ramify
