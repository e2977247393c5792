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
  const SplitFraction fraction = model.character().fraction;
  if (const auto* constant = std::get_if<ConstantFraction>(&fraction))
    return mean(Rounded{constant->p, 0}, constant->scatter == Scatter::none ? "x" : "p");
  const auto beta = BetaSplit::of(model);
  if (!beta) return std::nullopt;
  if (beta == uniform_split) return mean(Rounded{0.5, 0}, "1/2");
  const Precise a = beta->a, b = beta->b;
  return mean(round_to_double(a / (a + b), 1), "a/(a+b)");
}

}  // namespace ramify
