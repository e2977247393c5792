#include "ramify/theory/strahler_constant.hpp"

#include <cmath>
#include <limits>

#include "ramify/theory/beta_split.hpp"
#include "ramify/theory/binary_split.hpp"
#include "ramify/theory/complete_constant.hpp"
#include "ramify/theory/horton_ratio_constant.hpp"
#include "ramify/theory/make_constant.hpp"

namespace ramify {
namespace {

/// 1/log R with the error that R leaves, to the farther side, and the rounding of the logarithm and the
/// quotient.
Constant from_ratio(const Constant& ratio) {
  const double value = 1 / std::log(ratio.value);
  const double farthest = 1 / std::log(ratio.value - ratio.error);
  const double rounding = 2 * std::numeric_limits<double>::epsilon() * value;
  return {"strahler", value, farthest - value + rounding, "1/log R, R the Horton ratio", ratio.source};
}

}  // namespace

std::optional<Constant> strahler_constant(const Model& model, const std::optional<Constant>& horton_ratio) {
  const auto beta = BetaSplit::with_cut(model);
  if (beta == catalan_split)
    return make_constant("strahler", round_to_double(1 / log(Precise(4)), 1), "1/log 4",
                         "Flajolet, Raoult, Vuillemin 1979; C22");
  if (is_complete(model)) return complete_constant("strahler");
  if (beta) return horton_ratio ? std::optional(from_ratio(*horton_ratio)) : std::nullopt;
  const auto binary = BinarySplit::of_smaller_path(model);
  if (!binary) return std::nullopt;
  const bool fixed = binary->scatter == Scatter::none;
  return make_constant(
      "strahler", round_to_double(-1 / log(binary->smaller), 1), "1/log(1/min(p,1-p))",
      fixed ? "Kruszewski 1996, fact 3.2; C10, C11" : "Devroye, Kruszewski 1996, theorem B.3; C17");
}

std::optional<Constant> strahler_constant(const Model& model) {
  return strahler_constant(model, horton_ratio_constant(model));
}

}  // namespace ramify
