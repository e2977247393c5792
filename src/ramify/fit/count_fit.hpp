#pragma once

#include <map>
#include <memory>
#include <utility>

#include "ramify/core/cancellation.hpp"
#include "ramify/core/workforce.hpp"
#include "ramify/fit/bootstrap.hpp"
#include "ramify/fit/count_likelihood.hpp"
#include "ramify/fit/family_fit.hpp"
#include "ramify/fit/nested_test.hpp"

namespace ramify {

/// Fits families to the stream counts of trees by their likelihood (count_likelihood.hpp).
///
/// Keeps the laws that it computed of a family and n for the next tree of that size. For use by one thread at
/// a time.
class CountFitter {
 public:
  /// @param workforce     decides the time alone
  /// @param cancellation  must outlive it
  CountFitter(const Workforce& workforce, const Cancellation& cancellation,
              CountDensity density = CountDensity::gaussian)
      : workforce_(workforce), cancellation_(&cancellation), density_(density) {}

  /// Nothing where the family can be fitted to counts of this n; else why not.
  static std::string cannot_fit(const Family& family, Size n);

  /// Throws Interrupted. Cost: 20 to 60 laws for the first tree of a size (stream_counts.hpp), a hundredth of
  /// it for the next.
  FamilyFit fit(const Family& family, const ObservedCounts& counts);

  /// Likelihood and goodness of a fit anew, by the law at its estimate: so that families are ranked by what
  /// is read between nothing. Before a bootstrap. Cost: a law.
  void settle(FamilyFit& fit, const ObservedCounts& counts);

  /// Trees of the fitted model at the same n, drawn by their exact law (grafted) and fitted like the counts:
  /// fills the bootstrap of a fit, and the p-value of its goodness. A tree depends on (seed, model, n,
  /// replicate) alone. Throws Interrupted. Cost: some 3 ns a node, and 0.3 ms a tree.
  void bootstrap(FamilyFit& fit, const ObservedCounts& counts, const BootstrapPlan& plan);

  /// Likelihood ratios of trees of a simpler family at the same n, fitted with both, those of the bootstrap
  /// of the simpler one: what add_nested_test() takes. Throws Interrupted. Cost: as of a bootstrap.
  std::vector<double> grown_ratios(const NestedPair& pair, const ObservedCounts& counts,
                                   const BootstrapPlan& plan);

  /// Fills the valley of a family of two shapes, likelihoods by the law at every stop. Throws Interrupted.
  /// Cost: laws of some 10 panels, 26 further ones, and as many R(a,b).
  void trace_valley(FamilyFit& fit, const ObservedCounts& counts);

  /// The surface on which the family was fitted at n.
  CountSurface& surface(const Family& family, Size n);

 private:
  void refine_range(const FamilyFit& fit, const ObservedCounts& counts, CountSurface& surface);

  Workforce workforce_;
  const Cancellation* cancellation_;
  CountDensity density_;
  std::map<std::pair<const Family*, Size>, std::unique_ptr<CountSurface>> surfaces_;
};

}  // namespace ramify
