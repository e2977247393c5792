#include "ramify/theory/strahler_constant.hpp"

#include "ramify/theory/binary_split.hpp"

namespace ramify {
namespace {

std::optional<Constant> constant(const Precise& value, const char* formula, const char* source) {
  const auto rounded = round_to_double(value, 1);
  if (!rounded) return std::nullopt;
  return Constant{"strahler", rounded->value, rounded->error, formula, source};
}

}  // namespace

std::optional<Constant> strahler_constant(const Model& model) {
  if (std::holds_alternative<Catalan>(model.law()))
    return constant(1 / log(Precise(4)), "1/log 4", "Flajolet, Raoult, Vuillemin 1979; C22");
  if (std::holds_alternative<Dst>(model.law())) return std::nullopt;
  const auto binary = BinarySplit::of(model);
  if (!binary) return std::nullopt;
  const bool fixed = std::holds_alternative<FixedSplit>(model.law());
  return constant(
      -1 / log(binary->smaller), "1/log(1/min(p,1-p))",
      fixed ? "Kruszewski 1996, fact 3.2; C10, C11" : "Devroye, Kruszewski 1996, theorem B.3; C17");
}

}  // namespace ramify
