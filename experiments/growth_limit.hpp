#pragma once

#include <cstdint>
#include <future>
#include <map>
#include <mutex>
#include <string>

#include "ramify/compare/finding.hpp"
#include "ramify/core/cancellation.hpp"
#include "ramify/model/model.hpp"
#include "ramify/statistic/statistic_info.hpp"

namespace ramify {

/// How lim X_n / log n is read off the laws of X at sizes up to 10^300.
struct GrowthLadder {
  enum class Rungs : std::uint8_t {
    means,      ///< E X_n at n = largest/4^j
    variances,  ///< Var X_n there
    medians,    ///< the n at which X reaches its values (large/median_ladder.hpp): steps of E X_n do no harm
  };
  enum class Approach : std::uint8_t {
    settles,  ///< steps become equal at a geometric rate
    drifts,   ///< they do so like 1/log n, as of pulled fronts
  };

  const StatisticInfo* statistic;
  Rungs rungs;
  Approach approach;
  double largest_n;
};

/// Growth constants of models, each computed once, by the first who asks. Any thread.
class GrowthLimits {
 public:
  /// Evidence of the kind limit, extrapolated. Throws Interrupted. Cost: 0.2 to 5 s.
  Basis of(const Model& model, const GrowthLadder& ladder, const Cancellation& cancellation);

 private:
  std::mutex mutex_;
  std::map<std::string, std::shared_future<Basis>> known_;
};

}  // namespace ramify
