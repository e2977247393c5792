#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ramify/law/law_cost.hpp"
#include "ramify/model/registry.hpp"
#include "ramify/statistic/statistic_info.hpp"

namespace ramify {

/// What is asked of a law. Of orders, which are not one number but counts: the mean counts, the moments of
/// every count, the covariances of every two.
enum class LawQuantity { law, moments, covariances };

/// What a law is of: one statistic, or the counts of all orders, of nodes and of streams, at once.
struct LawSubject {
  std::vector<const StatisticInfo*> statistics;

  /// "height", or "orders". Throws Error for what has no law, with the names of all that have one.
  static LawSubject parse(std::string_view name);

  bool is_orders() const { return statistics.size() > 1; }
  std::string_view name() const;
};

/// What `ramify law` is asked for.
struct LawRequest {
  Model model;
  LawSubject subject;
  LawQuantity quantity;
  std::vector<double> sizes;  ///< one or more, to largest_law_size
  bool exact = false;         ///< by the recurrence over all sizes, however long it takes

  /// Up to here laws are computed by the recurrence over all sizes, beyond on a grid of sizes: where the
  /// recurrence takes a second; infinite where `exact` is asked for, or the model has no other laws.
  double exact_to() const;
  /// The sizes to exact_to, and those beyond.
  std::vector<Size> exact_sizes() const;
  std::vector<double> large_sizes() const;

  /// Throws Error for the law of a sum, of which only moments are computed, and for covariances of anything
  /// but orders.
  LawWork work() const;
};

/// The subjects of whole laws: strahler, height and so on; and orders.
std::vector<std::string> law_subjects();

/// Those of which the mean and the variance alone are computed: path_length, cherries.
std::vector<std::string> moment_subjects();

/// A law that takes longer is refused without --yes.
inline constexpr double long_law_seconds = 3600;

/// Throws Error where the request has no answer, where a size is above the model's largest, and where the law
/// would cost more than the limit, as far as law_cost and large_law_seconds can tell; the message says what
/// would fit. O(1).
void require_computable(const LawRequest& request, const LawCost& limit);

}  // namespace ramify
