#pragma once

#include <string>
#include <vector>

#include "ramify/law/law_cost.hpp"
#include "ramify/model/registry.hpp"

namespace ramify {

/// What is asked of a law. Of orders, which are not one number but counts: the mean counts, the moments of
/// every count, the covariances of every two.
enum class LawQuantity { law, moments, covariances };

/// What `ramify law` is asked for.
struct LawRequest {
  Model model;
  std::string statistic;  ///< of law_statistics() or moment_statistics()
  LawQuantity quantity;
  std::vector<Size> sizes;  ///< one or more

  Size largest_size() const;

  /// Throws Error for a statistic that has no law, with the names of those that have, and for covariances of
  /// anything but orders.
  LawKind kind() const;
};

/// Those with a law: strahler, height, depth, external_depth, fill_level, balance; and orders.
const std::vector<std::string>& law_statistics();

/// Those of which the mean and the variance alone are computed: path_length, sackin, colless.
const std::vector<std::string>& moment_statistics();

/// A law that takes longer is refused without --yes.
inline constexpr double long_law_seconds = 3600;

/// Throws Error where the request has no answer, where a size is above the model's largest, and where the law
/// would cost more than the limit, as far as law_cost can tell; the message says what would fit. O(1).
void require_computable(const LawRequest& request, const LawCost& limit);

}  // namespace ramify
