#include "ramify/fit/count_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "ramify/core/contract.hpp"
#include "ramify/core/parallel.hpp"
#include "ramify/fit/family_fit.hpp"
#include "ramify/fit/simulated_counts.hpp"
#include "ramify/large/stream_counts.hpp"

namespace ramify {
namespace {

constexpr std::size_t degree = 8;         // of one parameter
constexpr std::size_t degree_of_two = 4;  // of each of two
constexpr double least_mean = 1e-12;      // below, a count is taken to be that
constexpr double least_rest = 1e-9;       // of a variance, where rounding leaves none
constexpr double any_order = 1e-5;  // added to P(S = s), whose tails fall too fast to be read between places
constexpr double dense = 5;         // a mean count that a Gaussian likelihood may be asked about
constexpr double part_of_error = 0.02;  // what a reading may err by, of one tree's standard deviation
constexpr double of_simulation = 3;  // the same, in errors of a simulated mean: no panel is halved by chance
constexpr double seam_reach = 0.04;  // of a panel, on either side of where it meets the next
constexpr double narrowest = 1e-3;   // a panel that is not halved again

// Of two shapes of a beta law: log(a/b) and log(a+b).
constexpr double most_lopsided = -4.6, least_sum = -2.3, largest_sum = 6.9;

std::size_t degree_along(std::size_t dimensions) {
  return dimensions == 1 ? degree : degree_of_two;
}

/// cos(pi i / d): from 1 down to -1, ends included, so that halves share points.
double chebyshev_point(std::size_t i, std::size_t d) {
  return std::cos(std::numbers::pi * static_cast<double>(i) / static_cast<double>(d));
}

/// 2 log cosh(x/2): a smooth function of x that x and -x have in common, like |x| far from 0. Of a logit it
/// is -log 4 p (1-p).
double even(double x) {
  return std::abs(x) + 2 * std::log1p(std::exp(-std::abs(x))) - 2 * std::numbers::ln2;
}

/// The x >= 0 that has it.
double odd(double value) {
  return 2 * std::acosh(std::exp(value / 2));
}

/// Values at these points to coefficients of Chebyshev's polynomials.
std::vector<double> coefficients_of(const std::vector<double>& values) {
  const std::size_t d = values.size() - 1;
  std::vector<double> found(d + 1, 0.0);
  for (std::size_t k = 0; k <= d; ++k) {
    for (std::size_t i = 0; i <= d; ++i) {
      const double end = i == 0 || i == d ? 0.5 : 1;
      found[k] +=
          end * values[i] * std::cos(std::numbers::pi * static_cast<double>(i * k) / static_cast<double>(d));
    }
    found[k] *= (k == 0 || k == d ? 1.0 : 2.0) / static_cast<double>(d);
  }
  return found;
}

/// T_k(x) and T_k'(x), k = 0..d.
void chebyshev(double x, std::size_t d, std::vector<double>& values, std::vector<double>& slopes) {
  values.assign(d + 1, 1.0);
  slopes.assign(d + 1, 0.0);
  for (std::size_t k = 1; k <= d; ++k) {
    values[k] = k == 1 ? x : 2 * x * values[k - 1] - values[k - 2];
    slopes[k] = k == 1 ? 1 : 2 * values[k - 1] + 2 * x * slopes[k - 1] - slopes[k - 2];
  }
}

}  // namespace

CountSurface::CountSurface(const Family& family, Size n, unsigned threads, const Cancellation& cancellation)
    : family_(&family),
      n_(n),
      threads_(threads),
      cancellation_(&cancellation),
      orders_(static_cast<std::size_t>(std::log2(static_cast<double>(n) + 1))),
      allowed_(family.is_simulated() ? of_simulation / std::sqrt(static_cast<double>(simulated_trees(n)))
                                     : part_of_error) {
  RAMIFY_EXPECTS(family.parameters.size() <= 2);
  const SearchBox box = search_box(family);
  Point low = box.low, high = box.high;
  if (family.mirror == Mirror::reflected) {
    high[0] = even(low[0]);
    low[0] = 0;
  }
  if (family.mirror == Mirror::exchanged) {
    low = {0, least_sum};
    high = {even(most_lopsided), largest_sum};
  }
  panels_.push_back(make_panel(low, high));
}

CountSurface::Place CountSurface::place_of(std::span<const double> searched) const {
  if (family_->mirror == Mirror::reflected) return {{even(searched[0])}, {std::tanh(searched[0] / 2)}};
  if (family_->mirror != Mirror::exchanged) return {{searched.begin(), searched.end()}, {1.0}};
  const double log_a = searched[0], log_b = searched[1], off = log_a - log_b,
               share = 1 / (1 + std::exp(-off));
  const double log_sum = std::max(log_a, log_b) + std::log1p(std::exp(-std::abs(off)));
  return {{even(off), log_sum}, {std::tanh(off / 2), -std::tanh(off / 2), share, 1 - share}};
}

Point CountSurface::searched_of(const Point& place) const {
  if (family_->mirror == Mirror::reflected) return {-odd(place[0])};
  if (family_->mirror != Mirror::exchanged) return place;
  const double off = -odd(place[0]), log_b = place[1] - std::log1p(std::exp(off));
  return {off + log_b, log_b};
}

bool CountSurface::holds(const Point& place) const {
  for (std::size_t i = 0; i < place.size(); ++i)
    if (place[i] < panels_[0].low[i] || place[i] > panels_[0].high[i] || std::isnan(place[i])) return false;
  return true;
}

std::size_t CountSurface::panel_at(const Point& place) const {
  std::size_t at = 0;
  while (panels_[at].first_half >= 0) {
    const Panel& panel = panels_[at];
    const std::size_t along = panel.halved_along;
    const double middle = (panel.low[along] + panel.high[along]) / 2;
    at = static_cast<std::size_t>(panel.first_half) + (place[along] > middle ? 1 : 0);
  }
  return at;
}

std::vector<Point> CountSurface::points_of(const Panel& panel) const {
  std::vector<Point> points{{}};
  const std::size_t d = degree_along(panel.low.size());
  for (std::size_t along = 0; along < panel.low.size(); ++along) {
    std::vector<Point> longer;
    const double middle = (panel.low[along] + panel.high[along]) / 2,
                 half = (panel.high[along] - panel.low[along]) / 2;
    for (const Point& point : points)
      for (std::size_t i = 0; i <= d; ++i) {
        longer.push_back(point);
        // The ends as they are, so that neighbours find them again.
        longer.back().push_back(i == 0   ? panel.high[along]
                                : i == d ? panel.low[along]
                                         : middle + half * chebyshev_point(i, d));
      }
    points = std::move(longer);
  }
  return points;
}

std::vector<double> CountSurface::quantities(const Point& place) const {
  const auto values = family_->values(searched_of(place));
  const StreamCounts counts = family_->is_simulated()
                                  ? simulated_stream_counts(*family_, values, n_, *cancellation_)
                                  : stream_counts(family_->at(values), n_, *cancellation_);
  std::vector<double> found;
  std::vector<std::vector<double>> factor;  // Cholesky's, row by row
  const auto unit = [&counts](std::size_t k) { return std::max(0.0, counts.means[k]) + rounding_variance; };
  for (std::size_t k = 1; k <= orders_; ++k) {
    found.push_back(std::log(unit(k)));
    auto& row = factor.emplace_back();
    for (std::size_t j = 1; j <= k; ++j) {
      double rest = counts.covariance(j, k);
      if (j == k) rest = std::max(0.0, rest) + rounding_variance;
      rest /= std::sqrt(unit(j) * unit(k));
      for (std::size_t i = 0; i + 1 < j; ++i) rest -= row[i] * factor[j - 1][i];
      row.push_back(j < k ? rest / factor[j - 1].back() : std::sqrt(std::max(rest, least_rest)));
    }
    found.insert(found.end(), row.begin(), row.end() - 1);
    found.push_back(std::log(row.back()));
  }
  for (std::size_t s = 0; s <= orders_; ++s)
    found.push_back(std::log(std::max(counts.order_tail[s] - counts.order_tail[s + 1], 0.0) + any_order));
  return found;
}

void CountSurface::compute(const std::vector<Point>& places) {
  std::vector<Point> missing;
  for (const Point& place : places)
    if (!nodes_.contains(place)) missing.push_back(place);
  std::vector<std::vector<double>> found(missing.size());
  parallel_for(missing.size(), threads_, [&](std::size_t i, unsigned) { found[i] = quantities(missing[i]); });
  for (std::size_t i = 0; i < missing.size(); ++i) nodes_.emplace(missing[i], std::move(found[i]));
}

CountSurface::Panel CountSurface::make_panel(Point low, Point high) {
  Panel panel{std::move(low), std::move(high), {}, {}};
  const std::vector<Point> points = points_of(panel);
  compute(points);
  for (const Point& point : points) panel.at_nodes.push_back(nodes_.at(point));
  const std::size_t quantities = panel.at_nodes[0].size(), dimensions = panel.low.size();
  const std::size_t side = dimensions == 0 ? 1 : degree_along(dimensions) + 1;
  panel.coefficients.assign(points.size(), std::vector<double>(quantities));
  for (std::size_t q = 0; q < quantities; ++q) {
    std::vector<double> values;
    for (const auto& node : panel.at_nodes) values.push_back(node[q]);
    // Along the last dimension, then along the first of two.
    for (std::size_t line = 0; dimensions > 0 && line < values.size() / side; ++line) {
      const auto begin = values.begin() + static_cast<std::ptrdiff_t>(line * side);
      std::ranges::copy(coefficients_of({begin, begin + static_cast<std::ptrdiff_t>(side)}), begin);
    }
    for (std::size_t column = 0; dimensions == 2 && column < side; ++column) {
      std::vector<double> line;
      for (std::size_t i = 0; i < side; ++i) line.push_back(values[i * side + column]);
      line = coefficients_of(line);
      for (std::size_t i = 0; i < side; ++i) values[i * side + column] = line[i];
    }
    for (std::size_t c = 0; c < values.size(); ++c) panel.coefficients[c][q] = values[c];
  }
  return panel;
}

void CountSurface::halve(std::size_t panel, std::size_t along) {
  const Point low = panels_[panel].low, high = panels_[panel].high;
  const double middle = (low[along] + high[along]) / 2;
  Point below = high, above = low;
  below[along] = above[along] = middle;
  Panel first = make_panel(low, below), second = make_panel(above, high);
  panels_[panel].first_half = static_cast<std::ptrdiff_t>(panels_.size());
  panels_[panel].halved_along = along;
  panels_.push_back(std::move(first));
  panels_.push_back(std::move(second));
}

std::size_t CountSurface::index_of(std::size_t quantity, const CountReading& reading) const {
  const bool is_order = quantity + 1 == reading.size();
  return is_order ? CountReading::row(orders_ + 1) + reading.top : quantity;
}

/// One panel; beside a seam of one parameter both, so that what is read has no kink there.
std::vector<CountSurface::Share> CountSurface::shares_at(const Point& place) const {
  const std::size_t at = panel_at(place);
  const Point still(place.size(), 0.0);
  if (place.size() != 1) return {{at, 1, still}};
  const double x = place[0], low = panels_[at].low[0], high = panels_[at].high[0];
  const bool is_low = x - low < high - x;
  const double seam = is_low ? low : high;
  if (seam <= panels_[0].low[0] || seam >= panels_[0].high[0]) return {{at, 1, still}};
  const std::size_t other = panel_at({is_low ? low : std::nextafter(high, panels_[0].high[0])});
  const double reach = seam_reach * std::min(high - low, panels_[other].high[0] - panels_[other].low[0]);
  if (std::abs(x - seam) >= reach) return {{at, 1, still}};
  const double t = 0.5 + (x - seam) / (2 * reach);
  const double upper = t * t * (3 - 2 * t), slope = 3 * t * (1 - t) / reach;
  return {{is_low ? at : other, upper, {slope}}, {is_low ? other : at, 1 - upper, {-slope}}};
}

bool CountSurface::read(std::span<const double> searched, const CountReading& reading,
                        std::vector<double>& values, std::vector<double>& slopes) const {
  RAMIFY_EXPECTS(reading.orders <= orders_ && reading.top <= orders_);
  values.assign(reading.size(), 0.0);
  slopes.assign(reading.size() * searched.size(), 0.0);
  const Place place = place_of(searched);
  if (!holds(place.at)) return false;
  for (const Share& share : shares_at(place.at)) add_share(share, place, reading, values, slopes);
  return true;
}

void CountSurface::add_share(const Share& share, const Place& place, const CountReading& reading,
                             std::vector<double>& values, std::vector<double>& slopes) const {
  const Panel& panel = panels_[share.panel];
  const std::size_t dimensions = place.at.size(), size = reading.size();
  std::vector<std::vector<double>> polynomials(dimensions), derivatives(dimensions);
  for (std::size_t i = 0; i < dimensions; ++i) {
    const double half = (panel.high[i] - panel.low[i]) / 2;
    chebyshev((place.at[i] - panel.low[i]) / half - 1, degree_along(dimensions), polynomials[i],
              derivatives[i]);
    for (double& derivative : derivatives[i]) derivative /= half;
  }
  for (std::size_t c = 0; c < panel.coefficients.size(); ++c) {
    const std::size_t side = dimensions == 0 ? 1 : polynomials[0].size();
    const std::array<std::size_t, 2> power{dimensions == 2 ? c / side : c, c % side};
    double value = 1;
    for (std::size_t i = 0; i < dimensions; ++i) value *= polynomials[i][power[i]];
    Point along(dimensions, 0.0);  // by the searched numbers
    for (std::size_t i = 0; i < dimensions; ++i) {
      double slope = derivatives[i][power[i]];
      for (std::size_t j = 0; j < dimensions; ++j)
        if (j != i) slope *= polynomials[j][power[j]];
      slope = share.weight * slope + share.slopes[i] * value;
      for (std::size_t j = 0; j < dimensions; ++j) along[j] += slope * place.slopes[i * dimensions + j];
    }
    const std::vector<double>& coefficients = panel.coefficients[c];
    for (std::size_t q = 0; q < size; ++q) {
      const double coefficient = coefficients[index_of(q, reading)];
      values[q] += coefficient * share.weight * value;
      for (std::size_t j = 0; j < dimensions; ++j) slopes[j * size + q] += coefficient * along[j];
    }
  }
}

std::vector<double> CountSurface::computed(std::span<const double> searched,
                                           const CountReading& reading) const {
  const std::vector<double> all = quantities(place_of(searched).at);
  std::vector<double> found;
  for (std::size_t q = 0; q < reading.size(); ++q) found.push_back(all[index_of(q, reading)]);
  return found;
}

/// Of a reading's quantities along each dimension, in units of what is allowed.
std::vector<double> CountSurface::errors(const Panel& panel, const CountReading& reading) const {
  const std::size_t dimensions = panel.low.size(), side = degree_along(dimensions) + 1;
  std::vector<double> worst(dimensions, 0.0);
  const auto note = [&](std::size_t quantity, double allowed) {
    for (std::size_t i = 0; i < dimensions; ++i) {
      double last = 0, before = 0;
      for (std::size_t c = 0; c < panel.coefficients.size(); ++c) {
        const std::size_t power = dimensions == 2 && i == 0 ? c / side : c % side;
        const double coefficient = std::abs(panel.coefficients[c][quantity]);
        if (power == side - 1) last += coefficient;
        if (power == side - 2) before += coefficient;
      }
      worst[i] = std::max({worst[i], last / allowed, before / 4 / allowed});
    }
  };
  for (std::size_t k = 1; k <= reading.orders; ++k) {
    const std::size_t mean = CountReading::row(k), spread = mean + k;
    double largest = -std::numeric_limits<double>::infinity(), narrow = -largest;
    for (const auto& node : panel.at_nodes) {
      largest = std::max(largest, node[mean]);
      narrow = std::min(narrow, std::exp(node[spread] - node[mean] / 2));
    }
    if (largest < std::log(dense)) break;
    note(mean, allowed_ * narrow);
    for (std::size_t j = 1; j <= k; ++j) note(mean + j, allowed_);
  }
  const std::size_t order = CountReading::row(orders_ + 1) + reading.top;
  double most = -std::numeric_limits<double>::infinity();
  for (const auto& node : panel.at_nodes) most = std::max(most, node[order]);
  if (most > std::log(1e-6) && !family_->is_simulated()) note(order, 2 * allowed_);
  return worst;
}

bool CountSurface::refine(std::span<const double> searched, const CountReading& reading) {
  const Point place = place_of(searched).at;
  if (place.empty() || !holds(place)) return false;
  bool halved = false;
  while (refine_once(place, reading)) halved = true;
  return halved;
}

/// Halves one of the panels that are read there, if one is not accurate.
bool CountSurface::refine_once(const Point& place, const CountReading& reading) {
  for (const Share& share : shares_at(place)) {
    const Panel& panel = panels_[share.panel];
    const std::vector<double> found = errors(panel, reading);
    const auto worst = static_cast<std::size_t>(std::ranges::max_element(found) - found.begin());
    if (found[worst] <= 1 || panel.high[worst] - panel.low[worst] < narrowest) continue;
    halve(share.panel, worst);
    return true;
  }
  return false;
}

}  // namespace ramify
