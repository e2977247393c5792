#include "ramify/model/flow_rate.hpp"

#include <array>

#include "ramify/model/model_info.hpp"

namespace ramify {
namespace {

double share(double f) {
  require_domain(FlowRate::info(), std::array{f});
  return f / 2;
}

}  // namespace

FlowRate::FlowRate(double f) : split_(share(f)) {}

const ModelInfo& FlowRate::info() {
  static const ModelInfo info{
      .name = "flow_rate",
      .parameters = {{.name = "f",
                      .domain = {.low = 0, .high = 1, .holds_high = true},
                      .remedy = "give the share of the flow, such as 0.8"}},
      .largest_n = largest_n,
      .n_counts = "levels",
      .description = "split(f/2) of size 2^n cut below level n",
      .source = "A7, X20; Honda, Tomlinson and Fisher 1981",
      .make = [](std::span<const double> v) -> AnyModel { return grown_model(FlowRate(v[0])); },
      .is_split = false};
  return info;
}

}  // namespace ramify
