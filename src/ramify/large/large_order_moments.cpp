#include "ramify/large/large_order_moments.hpp"

#include <algorithm>
#include <utility>

#include <Eigen/Core>

#include "ramify/core/error.hpp"
#include "ramify/large/grid_series.hpp"

namespace ramify {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Index index_of(std::size_t k) {
  return static_cast<Index>(k);
}

/// Counts are numbered N_1, M_1, N_2, M_2, ...: those that a smaller size reaches come first.
Index nodes_of(Index order) {
  return 2 * (order - 1);
}
Index streams_of(Index order) {
  return 2 * (order - 1) + 1;
}
OrderCount count_of(Index a) {
  return {a % 2 == 0 ? OrderCount::Of::nodes : OrderCount::Of::streams, static_cast<std::size_t>(a / 2 + 1)};
}
Index number_of(OrderCount count) {
  const Index order = index_of(count.order);
  return count.of == OrderCount::Of::nodes ? nodes_of(order) : streams_of(order);
}

}  // namespace

/// What is held of a size.
struct LargeOrderMoments::Place {
  VectorXd means;        ///< over leaves
  MatrixXd covariances;  ///< over leaves
  Index first;           ///< order; h = 0 below, where S >= s is sure
  MatrixXd by_order;     ///< h(s) of every count, s = first, first + 1, ...

  Index counts() const { return means.size(); }

  void add_by_order_to(MatrixXd& sum, Index sum_first, double weight) const {
    const Index low = std::max(first, sum_first),
                high = std::min(first + by_order.cols(), sum_first + sum.cols());
    if (low >= high) return;
    sum.block(0, low - sum_first, counts(), high - low) +=
        weight * by_order.middleCols(low - first, high - low);
  }
};

/// The sums over the row of one size. Columns stand for the orders s = first..last+1 of the root.
class LargeOrderMoments::Row {
 public:
  Row(const LargeOrderMoments& moments, std::size_t place, const std::vector<PlacedSplit>& splits, Place& own)
      : moments_(moments),
        own_(own),
        leaves_(moments.grid_->leaves(place)),
        // Where the order is surely `certain`, both children may have one less.
        first_(std::max<Index>(0, own.first - 2)),
        orders_(own.first + own.by_order.cols() + 1 - first_),
        references_(place, 0.0),
        steps_(index_of(splits.size()), own.counts()),
        added_(MatrixXd::Zero(index_of(splits.size()), own.counts())),
        weights_(index_of(splits.size())),
        joined_(MatrixXd::Zero(own.counts(), orders_)),
        born_(joined_),
        own_at_(VectorXd::Zero(orders_)),
        own_below_(own_at_),
        not_own_(own_at_),
        smaller_by_order_(joined_),
        larger_by_order_(joined_),
        smaller_from_(static_cast<std::size_t>(orders_)),
        larger_from_(smaller_from_) {
    for (std::size_t i = 0; i < splits.size(); ++i) add(splits[i], index_of(i));
  }

  /// Fills h and the covariances of the size itself.
  void solve() {
    const MatrixXd weighed = weights_.asDiagonal() * added_;
    steps_added_ = steps_.transpose() * weighed;
    added_mean_ = weighed.colwise().sum().transpose();
    solve_by_order();
    const MatrixXd with_added = steps_added_ + children_with_added();
    MatrixXd sum = steps_.transpose() * weights_.asDiagonal() * steps_ + with_added + with_added.transpose();
    add_squares_of_added(sum);
    sum /= leaves_;
    for (std::size_t p = 0; p < references_.size(); ++p) {
      const MatrixXd& there = moments_.places_[p].covariances;
      if (references_[p] != 0) sum.topLeftCorner(there.rows(), there.cols()) += references_[p] * there;
    }
    own_.covariances = sum / not_own_sum_;
  }

 private:
  void add(const PlacedSplit& split, Index i) {
    weights_[i] = split.weight;
    add_references(split, i);
    const TailTable& tails = *moments_.tails_;
    tails.interpolate(split.smaller, static_cast<std::size_t>(first_), smaller_from_);
    Stencil all = split.larger.others;
    all.weight.back() += split.larger.own;
    tails.interpolate(all, static_cast<std::size_t>(first_), larger_from_);
    add_root(i);
    add_children(split);
  }

  /// Covariances of the children and D: what is linear in the stencils.
  void add_references(const PlacedSplit& split, Index i) {
    const double smaller = split.smaller_leaves / leaves_, larger = split.larger_leaves / leaves_;
    not_own_sum_ += split.weight * (split.larger.not_own + split.larger.own * smaller);
    steps_.row(i).setZero();
    const auto refer = [&](const Stencil& stencil, double share) {
      for (std::size_t r = 0; r < Stencil::width; ++r) {
        if (stencil.weight[r] == 0) continue;
        const double w = share * stencil.weight[r];
        const Place& there = moments_.places_[stencil.first + r];
        references_[stencil.first + r] += split.weight * w;
        // By differences from the size's own mean: a slow mean keeps its digits.
        steps_.row(i).head(there.counts()) +=
            w * leaves_ * (there.means - own_.means.head(there.counts())).transpose();
        steps_.row(i).tail(own_.counts() - there.counts()) -=
            w * leaves_ * own_.means.tail(own_.counts() - there.counts()).transpose();
      }
    };
    refer(split.smaller, smaller);
    refer(split.larger.others, larger);
  }

  /// E e of every count in one split.
  void add_root(Index i) {
    const auto x = [this](Index j) { return smaller_from_[static_cast<std::size_t>(j)]; };
    const auto y = [this](Index j) { return larger_from_[static_cast<std::size_t>(j)]; };
    const auto reached = [&](Index j) {  // P(S >= first + j)
      return x(j) * (1 - y(j - 1)) + (1 - x(j - 1)) * y(j) + x(j - 1) * y(j - 1);
    };
    for (Index j = 1; j + 1 < orders_; ++j) {
      added_(i, nodes_of(first_ + j)) = reached(j) - reached(j + 1);
      added_(i, streams_of(first_ + j)) = (x(j - 1) - x(j)) * (y(j - 1) - y(j));
    }
  }

  /// h of both children where their orders join to s, and where they begin a stream of it.
  void add_children(const PlacedSplit& split) {
    const double w = split.weight, w_own = w * split.larger.own;
    interpolate(split.smaller, smaller_by_order_);
    interpolate(split.larger.others, larger_by_order_);
    for (Index j = 1; j < orders_; ++j) {
      const auto at = static_cast<std::size_t>(j);
      const double x = smaller_from_[at - 1], x_at = x - smaller_from_[at];
      const double y = larger_from_[at - 1], y_at = y - larger_from_[at];
      const auto smaller = smaller_by_order_.col(j), smaller_below = smaller_by_order_.col(j - 1),
                 larger = larger_by_order_.col(j), larger_below = larger_by_order_.col(j - 1);
      joined_.col(j) +=
          w * (1 - y) * smaller + w * y_at * smaller_below + w * (1 - x) * larger + w * x_at * larger_below;
      born_.col(j) += w * y_at * (smaller_below - smaller) + w * x_at * (larger_below - larger);
      own_at_[j] += w_own * (1 - x);
      own_below_[j] += w_own * x_at;
      not_own_[j] += w * split.larger.not_own + w_own * x;
    }
  }

  void interpolate(const Stencil& stencil, MatrixXd& out) const {
    out.setZero();
    for (std::size_t r = 0; r < Stencil::width; ++r)
      if (stencil.weight[r] != 0)
        moments_.places_[stencil.first + r].add_by_order_to(out, first_, stencil.weight[r]);
  }

  /// h(s), order after order; then joined_ and born_ without a reference to it.
  void solve_by_order() {
    MatrixXd by_order = MatrixXd::Zero(own_.counts(), orders_);
    for (Index j = own_.first - first_; j + 1 < orders_; ++j) {
      const Index order = first_ + j;
      VectorXd known = joined_.col(j) + own_below_[j] * by_order.col(j - 1);
      for (Index k = order; k < first_ + orders_ - 1; ++k) {
        known += steps_added_.col(nodes_of(k));
        known[nodes_of(k)] += added_mean_[nodes_of(k)];
        known[streams_of(k)] += added_mean_[streams_of(k)];
      }
      by_order.col(j) = known / not_own_[j];
    }
    for (Index j = 1; j < orders_; ++j) {
      joined_.col(j) += own_at_[j] * by_order.col(j) + own_below_[j] * by_order.col(j - 1);
      born_.col(j) += own_below_[j] * (by_order.col(j - 1) - by_order.col(j));
    }
    own_.by_order = by_order.middleCols(own_.first - first_, own_.by_order.cols());
  }

  /// E[(Z(x) + Z(y))_b e_a] in row b, column a.
  MatrixXd children_with_added() const {
    MatrixXd products = MatrixXd::Zero(own_.counts(), own_.counts());
    for (Index j = 1; j + 1 < orders_; ++j) {
      products.col(nodes_of(first_ + j)) = joined_.col(j) - joined_.col(j + 1);
      products.col(streams_of(first_ + j)) = born_.col(j);
    }
    return products;
  }

  /// e_a e_b = 1 where both count the root; a root that begins a stream is a node of its order too.
  void add_squares_of_added(MatrixXd& sum) const {
    for (Index j = 1; j + 1 < orders_; ++j) {
      const Index node = nodes_of(first_ + j), stream = streams_of(first_ + j);
      sum(node, node) += added_mean_[node];
      for (const auto& [a, b] : {std::pair(node, stream), std::pair(stream, node), std::pair(stream, stream)})
        sum(a, b) += added_mean_[stream];
    }
  }

  const LargeOrderMoments& moments_;
  Place& own_;
  double leaves_;
  Index first_, orders_;
  double not_own_sum_ = 0;          ///< 1 - the size's own part of the children's covariances
  std::vector<double> references_;  ///< weights of other places' covariances
  MatrixXd steps_, added_;          ///< D and E e, a split a line
  VectorXd weights_;
  MatrixXd joined_, born_;
  VectorXd own_at_, own_below_, not_own_;        ///< of h(s), h(s-1) of the size itself; 1 - own_at_
  MatrixXd smaller_by_order_, larger_by_order_;  // of the children of one split
  std::vector<double> smaller_from_, larger_from_;
  MatrixXd steps_added_;  ///< E[D_b e_a]
  VectorXd added_mean_;
};

LargeOrderMoments::LargeOrderMoments(const SizeGrid& grid, const CompressedRows& rows,
                                     const OrderMoments& table, const LargeJoin& strahler,
                                     const LargeOrderMeans& means, const Cancellation& cancellation)
    : grid_(&grid), tails_(&strahler.tails()), means_(&means) {
  places_.reserve(grid.places());
  fill_from(table);
  PlacedRows placed(grid, rows);
  while (places_.size() < grid.places()) {
    if (cancellation.requested()) throw Interrupted();
    extend(places_.size(), placed);
  }
}

LargeOrderMoments::~LargeOrderMoments() = default;

/// With its means, and room for the rest.
LargeOrderMoments::Place LargeOrderMoments::empty_place(std::size_t place) const {
  const Index before = places_.empty() ? 0 : places_.back().counts();
  const Index last = index_of(tails_->last(place)), first = index_of(tails_->certain(place)) + 1;
  const Index counts = std::max(before, 2 * last);
  VectorXd means(counts);
  for (Index a = 0; a < counts; ++a) means[a] = means_->over_leaves(place, count_of(a));
  return {means, MatrixXd::Zero(counts, counts), first, MatrixXd::Zero(counts, last + 1 - first)};
}

/// The sizes of the table, and the lead of the grid within it.
void LargeOrderMoments::fill_from(const OrderMoments& table) {
  for (Size n = 0; n <= grid_->table_size(); ++n) {
    Place own = empty_place(n);
    const auto leaves = static_cast<double>(n + 1);
    for (Index a = 0; a < own.counts(); ++a) {
      for (Index b = 0; b < own.counts(); ++b)
        own.covariances(a, b) = table.covariance(n, count_of(a), count_of(b)) / leaves;
      double above = 0;
      for (Index j = own.by_order.cols(); j-- > 0;) {
        above += table.given_order().about_mean(n, count_of(a), static_cast<std::size_t>(own.first + j));
        own.by_order(a, j) = above;
      }
    }
    places_.push_back(std::move(own));
  }
  for (std::size_t place = grid_->first_point(); place < grid_->first_new_point(); ++place) {
    Place own = empty_place(place);
    const Stencil stencil = grid_->in_table(grid_->leaves(place));
    for (std::size_t r = 0; r < Stencil::width; ++r) {
      const Place& there = places_[stencil.first + r];
      own.covariances.topLeftCorner(there.counts(), there.counts()) += stencil.weight[r] * there.covariances;
      there.add_by_order_to(own.by_order, own.first, stencil.weight[r]);
    }
    places_.push_back(std::move(own));
  }
}

void LargeOrderMoments::extend(std::size_t place, PlacedRows& rows) {
  Place own = empty_place(place);
  Row(*this, place, rows.row(place), own).solve();
  places_.push_back(std::move(own));
}

double LargeOrderMoments::covariance(double leaves, OrderCount a, OrderCount b) const {
  if (std::min(a.order, b.order) == 0) return 0;
  const Stencil stencil = grid_->anywhere(leaves);
  const Index i = number_of(a), j = number_of(b);
  double sum = 0;
  for (std::size_t r = 0; r < Stencil::width; ++r) {
    const Place& there = places_[stencil.first + r];
    if (std::max(i, j) < there.counts()) sum += stencil.weight[r] * there.covariances(i, j);
  }
  return leaves * sum;
}

double LargeOrderMoments::about_mean(double leaves, OrderCount count, std::size_t order) const {
  if (count.order == 0) return 0;
  const Stencil stencil = grid_->anywhere(leaves);
  const Index a = number_of(count), s = index_of(order);
  double sum = 0;
  for (std::size_t r = 0; r < Stencil::width; ++r) {
    const Place& there = places_[stencil.first + r];
    const bool held = a < there.counts() && s >= there.first && s < there.first + there.by_order.cols();
    if (held) sum += stencil.weight[r] * there.by_order(a, s - there.first);
  }
  return sum;
}

}  // namespace ramify
