#include "ramify/family/aldous_likelihood.hpp"
#include "ramify/family/all_families.hpp"
#include "ramify/family/jet_likelihood.hpp"
#include "ramify/model/aldous.hpp"

namespace ramify {

Family aldous_family() {
  return {.name = "aldous",
          .model = &Aldous::info(),
          .fixed = {},
          .parameters = {{"beta", {SearchScale::Kind::log_above, -2, 0}, -1.99, 200, {-1.7, -1, 0.5, 8}}},
          .mirror = Mirror::none,
          .alike = "",
          .of_splits =
              [](const ObservedSplits& splits) {
                return jet_likelihood<1>(aldous_family(),
                                         [likelihood = AldousLikelihood(splits)](const auto& values) {
                                           return likelihood(values[0]);
                                         });
              },
          .nested = {{"bst", {0}}, {"catalan", {-1.5}}, {"aldous(-1)", {-1}}}};
}

}  // namespace ramify
