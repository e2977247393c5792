#pragma once

#include <map>
#include <memory>
#include <span>
#include <vector>

#include "ramify/core/cancellation.hpp"
#include "ramify/family/family.hpp"
#include "ramify/optimise/objective.hpp"

namespace ramify {

/// The variance of a number's distance from the nearest whole one: what a density of whole numbers is widened
/// by, so that an order whose count hardly varies does not decide alone.
inline constexpr double rounding_variance = 1.0 / 12;

/// Which of a surface's quantities are read: stream counts of orders 1..orders, leaf order 0, and P(S = top).
struct CountReading {
  std::size_t orders;
  std::size_t top;

  /// Of row k, k = 1..orders: log(E M_k + 1/12), then row k of Cholesky's factor L of the counts' covariances
  /// with 1/12 on the diagonal, each count in units of the root of its mean + 1/12: L_kj, j = 1..k-1, and log
  /// L_kk. Whatever is read between places, L L' is positive definite.
  static std::size_t row(std::size_t k) { return (k - 1) * (k + 2) / 2; }
  /// log(P(S = top) + 1e-5) comes last: an order that hardly occurs costs 11.5 and no more.
  std::size_t size() const { return row(orders + 1) + 1; }
};

/// Means and covariances of the stream counts of a family's trees of one size, and the law of their order, as
/// smooth functions of the family's parameters.
///
/// A law takes some 0.05 s (large/stream_counts.hpp), a fit asks for hundreds, a bootstrap for 10^5. So laws
/// are computed at Chebyshev's points of panels of parameter space, and read between them by the polynomials
/// through those; refine() halves a panel until it errs by less than 0.02 of one tree's standard deviation,
/// or, of a family without a law, by less than three errors of its simulation (simulated_counts.hpp).
///
/// Panels lie on a chart where mirror images are one place and nothing has a kink: the searched number itself
/// for one parameter, log p(1-p) where p and 1-p are alike, and of two shapes the same of a/(a+b), and
/// log(a+b).
class CountSurface {
 public:
  /// @param cancellation  must outlive it, like family
  CountSurface(const Family& family, Size n, unsigned threads, const Cancellation& cancellation);

  const Family& family() const { return *family_; }
  Size n() const { return n_; }
  /// Orders that trees of n can have above their leaves.
  std::size_t orders() const { return orders_; }

  /// The quantities of a reading at a searched point, and their derivatives by every searched number. False
  /// outside the chart. values: size(); slopes: parameters * size(), parameter by parameter.
  bool read(std::span<const double> searched, const CountReading& reading, std::vector<double>& values,
            std::vector<double>& slopes) const;

  /// The quantities there from a law of their own, read between nothing. Throws Interrupted. Cost: a law.
  std::vector<double> computed(std::span<const double> searched, const CountReading& reading) const;

  /// Halves the panel around a point until a reading there is accurate. True where it had to.
  /// Throws Interrupted. Cost: 8 laws a halving of one parameter, some 40 of two.
  bool refine(std::span<const double> searched, const CountReading& reading);

  /// Laws that were computed.
  std::size_t laws() const { return nodes_.size(); }

 private:
  struct Panel {
    Point low, high;
    std::vector<std::vector<double>> coefficients;  ///< of T_i (x) T_j, of every quantity
    std::vector<std::vector<double>> at_nodes;      ///< the quantities at its points
    std::ptrdiff_t first_half = -1;                 ///< the other follows it; none while it is whole
    std::size_t halved_along = 0;
  };

  /// A point of the chart, and how it moves with the searched numbers, row by row.
  struct Place {
    Point at;
    std::vector<double> slopes;
  };

  /// A panel's part of what is read at a place, and how it changes along the chart.
  struct Share {
    std::size_t panel;
    double weight;
    Point slopes;
  };

  std::vector<Share> shares_at(const Point& place) const;
  void add_share(const Share& share, const Place& place, const CountReading& reading,
                 std::vector<double>& values, std::vector<double>& slopes) const;
  Place place_of(std::span<const double> searched) const;
  Point searched_of(const Point& place) const;
  bool holds(const Point& place) const;
  std::size_t index_of(std::size_t quantity, const CountReading& reading) const;
  std::size_t panel_at(const Point& place) const;
  std::vector<Point> points_of(const Panel& panel) const;
  Panel make_panel(Point low, Point high);
  void compute(const std::vector<Point>& places);
  std::vector<double> quantities(const Point& place) const;
  void halve(std::size_t panel, std::size_t along);
  bool refine_once(const Point& place, const CountReading& reading);
  std::vector<double> errors(const Panel& panel, const CountReading& reading) const;

  const Family* family_;
  Size n_;
  unsigned threads_;
  const Cancellation* cancellation_;
  std::size_t orders_;
  double allowed_;  ///< that a reading errs by, of one tree's standard deviation
  std::map<Point, std::vector<double>> nodes_;
  std::vector<Panel> panels_;  ///< the first is the whole chart
};

}  // namespace ramify
