#include "ramify/theory/horton_ratio_constant.hpp"

#include "ramify/theory/beta_horton_ratio.hpp"
#include "ramify/theory/binary_split.hpp"
#include "ramify/theory/bst_horton_ratio.hpp"
#include "ramify/theory/complete_constant.hpp"
#include "ramify/theory/make_constant.hpp"

namespace ramify {

std::optional<Constant> horton_ratio_constant(const Model& model) {
  const auto beta = BetaSplit::with_cut(model);  // the wave wants no more
  if (beta == catalan_split)
    return make_constant("horton_ratio", Rounded{4, 0}, "4, ratio of streams (nodes: 2)",
                         "Moon 1980; C22, C23");
  if (is_complete(model))
    return make_constant("horton_ratio", Rounded{2, 0}, "2, ratio of streams", "A3; Viennot et al. 1989");
  if (beta == uniform_split)
    return make_constant(
        "horton_ratio", bst_horton_ratio(),
        "lim nu_(k-1)/nu_k, nu_k = integral of e^-t (D_(k-2) - D_(k-1))^2, D_k' = D_k (1 - D_k) + (D_(k-1) - "
        "D_k)^2; ratio of streams",
        "Kovchegov, Zaliapin 2017; against C20; docs/theory/horton-ratio.md");
  if (beta)
    return make_constant("horton_ratio", beta_horton_ratio(*beta),
                         "e^c, c the speed of the wave P(S_n > k) = psi(log n - c k); ratio of streams",
                         "derived in docs/theory/horton-ratio.md");
  const auto binary = BinarySplit::of_smaller_path(model);
  if (!binary) return std::nullopt;
  const bool fixed = binary->scatter == Scatter::none;
  return make_constant(
      "horton_ratio", round_to_double(1 / binary->smaller, 1),
      "1/min(p,1-p), ratio of streams as the order grows",
      fixed ? "Kruszewski 1996, fact 3.3; C10, C11" : "Devroye, Kruszewski 1996, theorem B.3; C17");
}

}  // namespace ramify
