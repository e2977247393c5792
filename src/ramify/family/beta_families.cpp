#include "ramify/family/all_families.hpp"
#include "ramify/model/beta.hpp"
#include "ramify/model/beta_multinomial.hpp"

namespace ramify {
namespace {

FamilyParameter shape(std::string_view name) {
  return {name, {SearchScale::Kind::log_above, 0, 0}, 0.05, 500, {0.3, 1.5, 8}};
}

constexpr std::string_view exchanged = "(a,b) and (b,a) grow mirror images: a <= b is given";

}  // namespace

Family beta_family() {
  return {.name = "beta",
          .model = &Beta::info(),
          .fixed = {},
          .parameters = {shape("a"), shape("b")},
          .mirror = Mirror::exchanged,
          .alike = exchanged};
}

Family beta_multinomial_family() {
  return {.name = "beta_multinomial",
          .model = &BetaMultinomial::info(),
          .fixed = {},
          .parameters = {shape("a"), shape("b")},
          .mirror = Mirror::exchanged,
          .alike = exchanged};
}

}  // namespace ramify
