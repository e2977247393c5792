#include "ramify/theory/split_mean.hpp"

#include "ramify/theory/beta_split.hpp"
#include "ramify/theory/precise.hpp"

namespace ramify {
namespace {

Constant parameter(double value, const char* formula) {
  return {"split_mean", value, 0, formula, "C8"};
}

}  // namespace

std::optional<Constant> split_mean(const Model& model) {
  if (std::holds_alternative<Bst>(model.law())) return parameter(0.5, "1/2");
  if (const auto* fixed = std::get_if<FixedSplit>(&model.law())) return parameter(fixed->x(), "x");
  if (const auto* dst = std::get_if<Dst>(&model.law())) return parameter(dst->p(), "p");
  if (const auto* patricia = std::get_if<Patricia>(&model.law())) return parameter(patricia->p(), "p");
  const auto beta = BetaSplit::of(model);
  if (!beta) return std::nullopt;
  const Precise a = beta->a, b = beta->b;
  const auto mean = round_to_double(a / (a + b), 1);
  if (!mean) return std::nullopt;
  return Constant{"split_mean", mean->value, mean->error, "a/(a+b)", "C8"};
}

}  // namespace ramify
