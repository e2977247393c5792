#include "ramify/family/all_families.hpp"
#include "ramify/model/aldous.hpp"
#include "ramify/model/bst.hpp"
#include "ramify/model/catalan.hpp"

namespace ramify {
namespace {

Family without_parameter(std::string_view name, const ModelInfo& model, std::vector<double> fixed) {
  return {.name = name,
          .model = &model,
          .fixed = std::move(fixed),
          .parameters = {},
          .mirror = Mirror::none,
          .alike = ""};
}

}  // namespace

/// Yule trees.
Family bst_family() {
  return without_parameter("bst", Bst::info(), {});
}

/// Uniform trees.
Family catalan_family() {
  return without_parameter("catalan", Catalan::info(), {});
}

/// Aldous's critical beta-splitting.
Family critical_family() {
  return without_parameter("aldous(-1)", Aldous::info(), {-1});
}

}  // namespace ramify
