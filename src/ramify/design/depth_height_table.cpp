#include "ramify/design/depth_height_table.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/core/number.hpp"
#include "ramify/design/design_row.hpp"

namespace ramify {
namespace {

constexpr int said_digits = 10;

Table table_of(const std::vector<BetaSplit>& splits) {
  Table table({"model", "a", "b", "depth", "height"});
  for (const BetaSplit& split : splits) table.add(beta_row(split));
  return table;
}

/// "4.307538221 of beta(0.92,1.5)", or which split has the limit.
std::string said(const DepthCurve& curve, const HeightEnd& end) {
  const std::string height = format_significant(end.height, said_digits);
  if (!end.split)
    return fmt::format("{} of split({}), which no beta(a,b) to 1e9 reaches,", height,
                       format_significant(curve.end_fraction(), said_digits));
  return fmt::format("{} of beta({},{})", height, format_significant(end.split->a, said_digits),
                     format_significant(end.split->b, said_digits));
}

/// The height that is found and nearest to the wanted one, as short as may be: what is advised must work.
std::string nearest(const DepthCurve& curve, double wanted) {
  const double low = curve.lowest_found(), high = curve.highest_found();
  const double exact = std::clamp(wanted, low, high);
  const double unit = std::pow(10, std::floor(std::log10(exact)) + 1 - said_digits);
  const double steps = exact / unit, inward = wanted < low ? std::ceil(steps) : std::floor(steps);
  const std::string text = format_significant(inward * unit, said_digits);
  const double value = parse_real(text).value_or(exact);
  return value >= low && value <= high ? text : format_exact(exact);
}

/// Whether a height is missed only because a and b end somewhere.
bool is_beyond_domain(const DepthCurve& curve, double height) {
  const auto [lowest, highest] = curve.heights();
  return height > lowest.height && height < highest.height;
}

Error no_such_tree(const DepthCurve& curve, double height) {
  const auto [lowest, highest] = curve.heights();
  const std::string why =
      is_beyond_domain(curve, height)
          ? fmt::format("it takes a or b above 1e9: so near is it to split({})",
                        format_significant(curve.end_fraction(), said_digits))
          : fmt::format("no such tree: for this depth the feasible heights are from {} to {}",
                        said(curve, lowest), said(curve, highest));
  return {
      fmt::format("--depth {} --height {}", format_exact(curve.depth()), format_exact(height)), why,
      fmt::format("take --height {}, or another depth; see: ramify design --map", nearest(curve, height))};
}

}  // namespace

Table depth_height_table(const DepthCurve& curve, double height) {
  const auto splits = curve.with_height(height);
  if (splits.empty()) throw no_such_tree(curve, height);
  return table_of(splits);
}

Table depth_curve_table(const DepthCurve& curve) {
  return table_of(curve.splits());
}

}  // namespace ramify
