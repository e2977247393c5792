#include "ramify/statistic/toll_sums.hpp"

#include "ramify/statistic/registry.hpp"

namespace ramify {

const std::vector<Toll>& all_tolls() {
  static const std::vector<Toll> tolls = [] {
    std::vector<Toll> found;
    for (const StatisticInfo& info : statistics())
      if (info.toll != nullptr) found.push_back(info.toll);
    return found;
  }();
  return tolls;
}

}  // namespace ramify
