#include "ramify/theory/balance_constant.hpp"

#include "ramify/theory/beta_balance.hpp"
#include "ramify/theory/binary_split.hpp"
#include "ramify/theory/complete_constant.hpp"
#include "ramify/theory/make_constant.hpp"

namespace ramify {

std::optional<Constant> balance_constant(const Model& model) {
  const auto beta = BetaSplit::of(model);
  if (beta == uniform_split)
    return make_constant("balance", bst_balance(), "min over t > 1 of t/log(1 + (t-1) 2^t)",
                         "Biggins 1978, docs/theory/balance.md; corrects theorem C.2 (C19)");
  if (beta)
    return make_constant("balance", beta_balance(*beta),
                         "min over t > 1 of t/theta, e^theta E[min(X,1-X)^t] + E[max(X,1-X)^t] = 1",
                         "Biggins 1978, docs/theory/balance.md");
  if (is_complete(model)) return complete_constant("balance");
  const auto binary = BinarySplit::of_smaller_path(model);
  if (!binary) return std::nullopt;
  const bool fixed = binary->scatter == Scatter::none;
  return make_constant("balance", round_to_double(-1 / log(binary->smaller), 1), "1/log(1/min(p,1-p))",
                       fixed ? "the path of smaller children; C11" : "Kruszewski 1996, cor. B.2; C17");
}

}  // namespace ramify
