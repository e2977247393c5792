#pragma once

#include <string_view>
#include <vector>

#include "ramify/tree/grammar.hpp"

namespace ramify {

/// A tree of the sources: the model and size behind one of their figures or tables.
struct Preset {
  std::string_view name;
  std::string_view model;  ///< as Model::parse takes it
  Size n;
  std::string_view description;
  std::string_view source;
};

/// All presets, in the order they are listed.
const std::vector<Preset>& presets();

/// Throws Error for an unknown name, nearest names given.
const Preset& find_preset(std::string_view name);

}  // namespace ramify
