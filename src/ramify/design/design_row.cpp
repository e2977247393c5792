#include "ramify/design/design_row.hpp"

#include <limits>

#include <fmt/format.h>

#include "ramify/core/number.hpp"
#include "ramify/theory/depth_constant.hpp"
#include "ramify/theory/height_constant.hpp"

namespace ramify {
namespace {

double value_of(const std::optional<Constant>& constant) {
  return constant ? constant->value : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

double to_design_digits(double parameter) {
  return parse_real(format_significant(parameter, 12)).value_or(parameter);
}

std::string beta_text(const BetaSplit& split) {
  return fmt::format("beta({},{})", format_exact(split.a), format_exact(split.b));
}

double depth_of(const Model& model) {
  return value_of(depth_constant(model));
}

double height_of(const Model& model) {
  return value_of(height_constant(model));
}

Row beta_row(const BetaSplit& split) {
  const Model model = Model::parse(beta_text(split));
  return Row()
      .text(model.text())
      .exact(split.a)
      .exact(split.b)
      .exact(depth_of(model))
      .exact(height_of(model));
}

}  // namespace ramify
