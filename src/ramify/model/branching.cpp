#include "ramify/model/branching.hpp"

#include <array>

#include <fmt/format.h>

#include "ramify/model/model_info.hpp"

namespace ramify {

Branching::Branching(double p0, double p1, double p2) {
  const double sum =
      require_distribution(fmt::format("branching({},{},{})", p0, p1, p2), std::array{p0, p1, p2});
  p0_ = p0 / sum;
  p1_ = p1 / sum;
  p2_ = p2 / sum;
}

const ModelInfo& Branching::info() {
  constexpr Domain not_negative{.low = 0, .holds_low = true};
  static const ModelInfo info{
      .name = "branching",
      .parameters = {{"p0", not_negative}, {"p1", not_negative}, {"p2", not_negative}},
      .together = ", sum 1",
      .n_counts = "generations",
      .description = "Galton-Watson process of 0, 1 or 2 children, limited to n generations",
      .source = "A20; Kruszewski 1996, 4.2.5",
      .make = [](std::span<const double> v) -> AnyModel { return grown_model(Branching(v[0], v[1], v[2])); },
      .is_split = false};
  return info;
}

}  // namespace ramify
