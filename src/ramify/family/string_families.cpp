#include "ramify/family/all_families.hpp"
#include "ramify/model/dst.hpp"
#include "ramify/model/patricia.hpp"

namespace ramify {
namespace {

/// At 0.02 the limiting ratio is 50. Laws of lopsided splits take the longest.
FamilyParameter bit_probability() {
  return {"p", {SearchScale::Kind::logit, 0, 1}, 0.02, 0.98, {0.45, 0.3, 0.15, 0.05}};
}

constexpr std::string_view mirrored = "p and 1-p grow mirror images: p <= 1/2 is given";

}  // namespace

Family patricia_family() {
  return {.name = "patricia",
          .model = &Patricia::info(),
          .fixed = {},
          .parameters = {bit_probability()},
          .mirror = Mirror::reflected,
          .alike = mirrored};
}

Family dst_family() {
  return {.name = "dst",
          .model = &Dst::info(),
          .fixed = {},
          .parameters = {bit_probability()},
          .mirror = Mirror::reflected,
          .alike = mirrored};
}

}  // namespace ramify
