#include <cmath>
#include <numbers>

#include "ramify/family/aldous_likelihood.hpp"
#include "ramify/family/all_families.hpp"
#include "ramify/model/aldous.hpp"
#include "ramify/model/bst.hpp"
#include "ramify/model/catalan.hpp"

namespace ramify {
namespace {

Family without_parameter(std::string_view name, const ModelInfo& model, std::vector<double> fixed,
                         SplitLikelihood (*of_splits)(const ObservedSplits&)) {
  return {.name = name,
          .model = &model,
          .fixed = std::move(fixed),
          .parameters = {},
          .mirror = Mirror::none,
          .alike = "",
          .of_splits = of_splits};
}

/// The likelihood of a law without parameters. @param log_probability  of a split and not its mirror image
template <class LogProbability>
SplitLikelihood constant_likelihood(const ObservedSplits& observed, LogProbability log_probability) {
  double minus_log = 0;
  for (const ObservedSplit& split : observed.splits())
    minus_log -= split.count * (log_probability(split) + (split.is_even() ? 0 : std::numbers::ln2));
  return [minus_log](std::span<const double>, double& value, double*) {
    value = minus_log;
    return std::isfinite(minus_log);
  };
}

SplitLikelihood bst_likelihood(const ObservedSplits& observed) {
  return constant_likelihood(
      observed, [](const ObservedSplit& split) { return -std::log(static_cast<double>(split.size())); });
}

/// C_i C_j / C_n.
SplitLikelihood catalan_likelihood(const ObservedSplits& observed) {
  const auto number = [](Size i) {  // C_i / 4^i
    return Catalan::central_binomial(i) / (static_cast<double>(i) + 1);
  };
  return constant_likelihood(observed, [number](const ObservedSplit& split) {
    return std::log(number(split.smaller) / (4 * number(split.size())) * number(split.larger));
  });
}

SplitLikelihood critical_likelihood(const ObservedSplits& observed) {
  const double minus_log = AldousLikelihood(observed)(-1.0);
  return [minus_log](std::span<const double>, double& value, double*) {
    value = minus_log;
    return std::isfinite(minus_log);
  };
}

}  // namespace

/// Yule trees.
Family bst_family() {
  return without_parameter("bst", Bst::info(), {}, bst_likelihood);
}

/// Uniform trees.
Family catalan_family() {
  return without_parameter("catalan", Catalan::info(), {}, catalan_likelihood);
}

/// Aldous's critical beta-splitting.
Family critical_family() {
  return without_parameter("aldous(-1)", Aldous::info(), {-1}, critical_likelihood);
}

}  // namespace ramify
