#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "ramify/core/cancellation.hpp"
#include "ramify/fit/fit_row.hpp"
#include "ramify/fit/law_ratios.hpp"
#include "ramify/fit/ratio_curve.hpp"
#include "ramify/fit/ratio_datum.hpp"
#include "ramify/fit/root_search.hpp"
#include "ramify/model/model_info.hpp"

namespace ramify {

/// The model of that name, of which one ratio fixes the one parameter: a probability p that is its limiting
/// split fraction, about which sizes scatter. Throws Error for any other.
const ModelInfo& require_fittable(std::string_view name);

struct FitOptions {
  const ModelInfo* model = &Patricia::info();  ///< a fittable one
  std::uint64_t seed = 1996;
  std::optional<Size> n;  ///< the user's size, in place of every datum's own
  unsigned threads = 1;   ///< decides the time alone
  /// Internal nodes to grow at one point of the curve; 200 to 4,000 trees are (100 above n = 10^8). Errors
  /// fall with its square root.
  std::uint64_t nodes_per_point = 1'500'000;
};

/// Fits the split probability p of a model to a measured bifurcation ratio R at its size n.
///
/// For each size of a datum: the thesis's rule p = 1/R (K96 3.1.5, 3.2.2; H2), which holds only as n grows
/// without bound; then, for streams mean_ratio and the five other estimators, every p <= 1/2 at which trees
/// of that n have R as their expected ratio (1 - p is the mirror image), with its Monte Carlo error and all p
/// that one tree of ratio R does not reject at 5 %; last, the p at which the expected counts of streams have
/// R as pooled ratio and by regression, by law (LawRatios). Where a diameter ratio R_D is given, Murray's
/// exponent log R_B / log R_D as well (H14, C35).
///
/// Keeps the curves of sizes it has seen; a datum's rows depend on the datum, model, seed and nodes_per_point
/// alone.
class RatioFitter {
 public:
  /// cancellation must outlive the fitter.
  RatioFitter(FitOptions options, const Cancellation& cancellation);

  /// Throws Error for a size out of 2..largest_size, Interrupted when cancelled. Seconds on one core to n =
  /// 10^5, half a minute beyond.
  std::vector<FitRow> fit(const RatioDatum& datum);

  static constexpr Size largest_size = 1'000'000'000;

 private:
  SearchEffort effort(Size n) const;
  const RatioCurve& grid(const ResponseSurface& surface);
  void require_size(const RatioDatum& datum, Size n) const;
  void fit_size(const RatioDatum& datum, const SizeChoice& size, std::vector<FitRow>& rows);
  void fit_estimator(const ResponseSurface& surface, RatioEstimator estimator, const FitRow& blank,
                     std::vector<FitRow>& rows);

  void fit_by_law(const ResponseSurface& surface, const RatioDatum& datum, const FitRow& rule,
                  std::vector<FitRow>& rows);
  void fit_by_law(const LawRatios& laws, LawEstimator estimator, const FitRow& blank,
                  std::vector<FitRow>& rows);

  FitOptions options_;
  const Cancellation* cancellation_;
  std::map<Size, RatioCurve> grids_;
  std::map<Size, LawRatios> laws_;
};

/// The rows of one datum.
std::vector<FitRow> fit_ratio(const RatioDatum& datum, const FitOptions& options,
                              const Cancellation& cancellation);

}  // namespace ramify
