#pragma once

#include <span>
#include <vector>

#include "ramify/family/observed_splits.hpp"

namespace ramify {

/// What a fitted tree is like: where its fit lies, and what no estimate takes up.
struct FittedFeatures {
  std::vector<double> searched;  ///< the estimates, on the scale that is searched
  std::vector<double> values;    ///< features_of() the splits and the fit
};

/// The maximised log-likelihood a node, and by size of the node (3-7, 8-31, 32-127, larger) the mean and the
/// mean square of the balance 2 smaller / (n-1) of its split; 0 where there is no such node. Always as many.
std::vector<double> features_of(const ObservedSplits& splits, double log_likelihood);

/// How far each of several fitted trees is from what all of them are like.
///
/// The features are regressed on the estimates, and the residuals measured by their own covariance
/// (Mahalanobis). A maximised likelihood alone tells little: in an exponential family it is a function of the
/// estimate. What the estimate explains is taken off, so that it is the law's shape and its change with size
/// that are tested.
/// @param trees  the observed one is one of them, treated like the others: so ranks are fair
std::vector<double> lack_of_fit(std::span<const FittedFeatures> trees);

}  // namespace ramify
