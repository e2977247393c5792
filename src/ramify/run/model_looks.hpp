#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ramify/config/run_config.hpp"

namespace ramify {

/// The number of every model's look in plots (PlotSeries::look): its place among the models of all configs
/// that a command runs, so that one symbol and colour is one model throughout.
class ModelLooks {
 public:
  /// Models that are new come after those that are there, in the order of the config.
  void add(const RunConfig& config);

  /// @param model  of a config that was added
  std::size_t of(std::string_view model) const;

 private:
  std::vector<std::string> models_;
};

}  // namespace ramify
