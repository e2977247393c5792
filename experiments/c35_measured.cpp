// C35, last parts: Horton's second law and Murray's exponent of vessels that were measured order by order,
// the arteries and veins of the human lung (Huang et al. 1996).
//
// Second law: log D_k and log L_k are straight lines in k, so that the curvature of a parabola through them
// is 0. Its rival is a power of the order, which bends as far as the curvature says that it has between the
// same ends. Murray: the sum of D^x over the vessels of an order is the same for all orders, so that log M_k
// falls with log D_k by the slope x = 3. Intervals are Student's, 99 % over all parts together: that the
// residuals of orders are normal, alike and independent is believed, so the standing is "seen".
//
// What these data cannot say: orders were told apart by diameters, which makes diameters more regular than
// those of streams would be; lengths had no part in it. The one bronchial tree in data/ (airway_ct.csv) has
// six orders, whose scatter leaves x between 1 and 3 and the curvature where a power of the order has it: it
// decides nothing and is no part.
#include <cmath>
#include <numeric>
#include <string_view>
#include <utility>

#include "measured_lung.hpp"
#include <boost/math/distributions/students_t.hpp>
#include <fmt/format.h>

#include "ramify/core/contract.hpp"

namespace ramify {
namespace {

constexpr int vessel_parts = 6;
constexpr double vessel_chance = 0.01 / vessel_parts;

struct Vessels {
  std::string_view name;
  std::span<const VesselOrder> orders;
};

using Measure = double VesselOrder::*;

/// Orders and the logarithms of what is known of them.
struct MeasuredCurve {
  std::vector<double> x, y;
};

MeasuredCurve by_order(const Vessels& vessels, Measure measure) {
  MeasuredCurve curve;
  for (const VesselOrder& order : vessels.orders) {
    if (std::isnan(order.*measure)) continue;
    curve.x.push_back(order.order);
    curve.y.push_back(std::log(order.*measure));
  }
  return curve;
}

MeasuredCurve by_diameter(const Vessels& vessels) {
  MeasuredCurve curve;
  for (const VesselOrder& order : vessels.orders) {
    if (std::isnan(order.diameter)) continue;
    curve.x.push_back(std::log(order.diameter));
    curve.y.push_back(std::log(order.count));
  }
  return curve;
}

double product(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// Takes away what lies along a column, and returns how much of it.
double subtract(std::vector<double>& values, const std::vector<double>& column) {
  const double part = product(values, column) / product(column, column);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] -= part * column[i];
  return part;
}

/// The curvature of x_1 k^a, which has the same first and last value.
double curvature_of_power(const MeasuredCurve& curve) {
  const double power =
      (curve.y.back() - curve.y.front()) / (std::log(curve.x.back()) - std::log(curve.x.front()));
  std::vector<double> logs;
  for (const double k : curve.x) logs.push_back(power * std::log(k));
  return leading_coefficient(curve.x, logs, 2).value;
}

Basis of_measured(const FittedCoefficient& fitted, double sign, std::string method) {
  const auto [lower, upper] = fitted.interval(vessel_chance);
  return {EvidenceKind::measured,
          Standing::seen,
          sign * fitted.value,
          sign > 0 ? Interval{lower, upper} : Interval{-upper, -lower},
          Basis::none,
          fmt::format("{}, {:.0f} degrees of freedom; interval: Student's t, 99 % over {} parts together",
                      method, fitted.degrees, vessel_parts),
          "vessels of more orders",
          fitted.standard_error};
}

Statement of_vessels(std::size_t part, std::string text, std::string formula, double theory) {
  return {fmt::format("C35.{}", part),
          std::move(text),
          "K96 5.1.2, 5.1.6; Huang et al. 1996",
          "elements of diameter-defined orders 1 to 15, order 1 the smallest",
          Relation::equals,
          std::move(formula),
          theory,
          {},
          std::nullopt};
}

/// @param bends  known to be false: a power of the order holds instead
ClaimPart straight_line(std::size_t part, const Vessels& vessels, const char* symbol, Measure measure,
                        bool bends = false) {
  Statement statement =
      of_vessels(part, fmt::format("curvature of log {}_k on k is 0, {}", symbol, vessels.name), "0", 0);
  const MeasuredCurve curve = by_order(vessels, measure);
  const NamedValue power{"a power of k between the same ends", curvature_of_power(curve)};
  if (bends)
    statement.instead = power;
  else
    statement.rivals = {power};
  return part_without_trees(std::move(statement), [curve](const Evidence&) {
    return of_measured(
        leading_coefficient(curve.x, curve.y, 2), 1,
        "coefficient of k^2 in the least-squares parabola through the logarithms of the means");
  });
}

ClaimPart murray_of_vessels(std::size_t part, const Vessels& vessels) {
  Statement statement =
      of_vessels(part, fmt::format("sum of D^x alike for all orders: x is 3, {}", vessels.name), "3", 3);
  statement.rivals = {{"2, da Vinci", 2}};
  return part_without_trees(std::move(statement), [curve = by_diameter(vessels)](const Evidence&) {
    return of_measured(leading_coefficient(curve.x, curve.y, 1), -1,
                       "slope of the least-squares line of log counts on log mean diameters");
  });
}

}  // namespace

Interval FittedCoefficient::interval(double chance) const {
  const boost::math::students_t law(degrees);
  const double reach = standard_error * boost::math::quantile(boost::math::complement(law, chance / 2));
  return {value - reach, value + reach};
}

FittedCoefficient leading_coefficient(std::span<const double> x, std::span<const double> y, int power) {
  RAMIFY_EXPECTS(x.size() == y.size() && x.size() > static_cast<std::size_t>(power) + 1);
  const double mean = std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
  std::vector<double> left(y.begin(), y.end()), column;
  std::vector<std::vector<double>> columns;  // 1, x, x^2, ..., each orthogonal to those before it
  double value = 0;
  for (int degree = 0; degree <= power; ++degree) {
    column.clear();
    for (const double place : x) column.push_back(std::pow(place - mean, degree));
    for (const auto& before : columns) subtract(column, before);
    value = subtract(left, column);
    columns.push_back(column);
  }
  const double degrees = static_cast<double>(x.size() - columns.size());
  return {value, std::sqrt(product(left, left) / (degrees * product(column, column))), degrees};
}

std::vector<ClaimPart> measured_second_law_parts(std::size_t first) {
  const Vessels artery{"human pulmonary artery", measured_artery};
  const Vessels vein{"human pulmonary vein", measured_vein};
  std::vector<ClaimPart> parts;
  for (const Vessels& vessels : {artery, vein}) {
    const bool bends = vessels.name == vein.name;
    parts.push_back(straight_line(first + parts.size(), vessels, "D", &VesselOrder::diameter));
    parts.push_back(straight_line(first + parts.size(), vessels, "L", &VesselOrder::length, bends));
    parts.push_back(murray_of_vessels(first + parts.size(), vessels));
  }
  RAMIFY_EXPECTS(parts.size() == vessel_parts);
  return parts;
}

}  // namespace ramify
