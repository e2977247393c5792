#include "ramify/run/model_looks.hpp"

#include <algorithm>

#include "ramify/core/contract.hpp"

namespace ramify {

void ModelLooks::add(const RunConfig& config) {
  for (const SizeGroup& group : config.groups)
    for (const Model& model : group.models)
      if (std::ranges::find(models_, model.text()) == models_.end()) models_.push_back(model.text());
}

std::size_t ModelLooks::of(std::string_view model) const {
  const auto place = std::ranges::find(models_, model);
  RAMIFY_EXPECTS(place != models_.end());
  return static_cast<std::size_t>(place - models_.begin());
}

}  // namespace ramify
