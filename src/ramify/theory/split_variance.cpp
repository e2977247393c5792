#include "ramify/theory/split_variance.hpp"

#include "ramify/theory/beta_split.hpp"
#include "ramify/theory/binary_split.hpp"
#include "ramify/theory/make_constant.hpp"

namespace ramify {

std::optional<Constant> split_variance(const Model& model) {
  if (BinarySplit::of(model)) return Constant{"split_variance", 0, 0, "0", "C8"};
  const auto beta = BetaSplit::of(model);
  if (!beta) return std::nullopt;
  const Precise a = beta->a, b = beta->b;
  return make_constant("split_variance", round_to_double(a / (a + b) * (b / (a + b)) / (a + b + 1), 1),
                       "ab/((a+b)^2 (a+b+1))", "C8");
}

}  // namespace ramify
