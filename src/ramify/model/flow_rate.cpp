#include "ramify/model/flow_rate.hpp"

#include <fmt/format.h>

#include "ramify/core/error.hpp"

namespace ramify {
namespace {

double share(double f) {
  if (f > 0 && f <= 1) return f / 2;
  throw Error(fmt::format("flow_rate(f) with f = {}", f), "f must lie in (0,1]",
              "give the share of the flow, such as 0.8");
}

}  // namespace

FlowRate::FlowRate(double f) : split_(share(f)) {}

}  // namespace ramify
