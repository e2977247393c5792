#pragma once

#include <utility>
#include <vector>

#include "ramify/config/run_config.hpp"
#include "ramify/config/toml_value.hpp"

namespace ramify::detail {

/// A value of a config and where it stands, for errors that are seen only when several are put together.
template <class T>
struct Placed {
  T value;
  TomlValue place;
};

std::vector<Placed<Model>> read_models(const TomlValue& models);
std::vector<Placed<Size>> read_sizes(const TomlValue& n);
ReplicateRule read_replicates(const TomlValue& replicates);

}  // namespace ramify::detail
