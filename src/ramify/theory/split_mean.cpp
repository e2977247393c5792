#include "ramify/theory/split_mean.hpp"

#include "ramify/theory/beta_split.hpp"
#include "ramify/theory/make_constant.hpp"

namespace ramify {
namespace {

std::optional<Constant> mean(const std::optional<Rounded>& found, std::string_view formula) {
  return make_constant("split_mean", found, formula, "C8");
}

}  // namespace

std::optional<Constant> split_mean(const Model& model) {
  if (std::holds_alternative<Bst>(model.law())) return mean(Rounded{0.5, 0}, "1/2");
  if (const auto* fixed = std::get_if<FixedSplit>(&model.law())) return mean(Rounded{fixed->x(), 0}, "x");
  if (const auto* dst = std::get_if<Dst>(&model.law())) return mean(Rounded{dst->p(), 0}, "p");
  if (const auto* patricia = std::get_if<Patricia>(&model.law())) return mean(Rounded{patricia->p(), 0}, "p");
  const auto beta = BetaSplit::of(model);
  if (!beta) return std::nullopt;
  const Precise a = beta->a, b = beta->b;
  return mean(round_to_double(a / (a + b), 1), "a/(a+b)");
}

}  // namespace ramify
