#pragma once

#include "ramify/model/registry.hpp"

namespace ramify {

/// The largest n up to which the exact laws of all statistics of a model together take about 2 s on one core
/// (measured). A fixed function of the model, never timed: tables must not depend on the machine.
Size law_limit(const Model& model);

}  // namespace ramify
