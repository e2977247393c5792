#pragma once

#include "ramify/model/model.hpp"

namespace ramify {

/// The largest n up to which the exact laws of all statistics of a model together take about 2 s on one core
/// (measured). Of split models. A fixed function of the model, never timed: tables must not depend on the
/// machine.
Size law_limit(const Model& model);

/// The largest n up to which OrderMoments take about 1 s on one core, besides; not above law_limit.
Size order_moments_limit(const Model& model);

}  // namespace ramify
