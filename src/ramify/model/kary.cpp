#include "ramify/model/kary.hpp"

#include <array>

#include "ramify/model/model_info.hpp"

namespace ramify {
namespace {

double checked_arity(double k) {
  require_domain(Kary::info(), std::array{k});
  return k;
}

}  // namespace

Kary::Kary(double k) : k_(static_cast<std::size_t>(checked_arity(k))) {}

const ModelInfo& Kary::info() {
  static const ModelInfo info{
      .name = "kary",
      .parameters = {{.name = "k",
                      .domain = {.low = 2, .high = 1000, .holds_low = true, .holds_high = true},
                      .remedy = "write kary(3)",
                      .is_whole = true}},
      .n_counts = "levels, external nodes counted",
      .description = "complete k-ary tree",
      .source = "A25",
      .make = [](std::span<const double> v) -> AnyModel { return grown_model(Kary(v[0])); },
      .is_split = false,
      .is_binary = false};
  return info;
}

}  // namespace ramify
