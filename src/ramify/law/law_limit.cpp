#include "ramify/law/law_limit.hpp"

namespace ramify {

Size law_limit(const Model& model) {
  return model.character().reach.all_laws;
}

Size order_moments_limit(const Model& model) {
  return model.character().reach.order_moments;
}

}  // namespace ramify
