#include "ramify/model/ternary.hpp"

#include <array>

#include "ramify/model/model_info.hpp"

namespace ramify {

Ternary::Ternary(double p) : p_(p) {
  require_domain(info(), std::array{p});
}

const ModelInfo& Ternary::info() {
  static const ModelInfo info{
      .name = "ternary",
      .parameters = {{.name = "p",
                      .domain = {.low = 0, .high = 1.0 / 3, .holds_high = true},
                      .remedy = "give a number such as 1/4.8, the white fir's",
                      .reason = ": above, the main child would not be the largest"}},
      .largest_n = max_double_size,
      .description =
          "three children of sizes n-1-X-max(X-1,0), max(X-1,0), X; X ~ Bin(n,p) given that all are >= 0",
      .source = "A22, A23; Kruszewski 1996, 3.3.3",
      .make = [](std::span<const double> v) -> AnyModel { return grown_model(Ternary(v[0])); },
      .is_split = false,
      .is_binary = false};
  return info;
}

}  // namespace ramify
