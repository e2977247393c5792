#include "claim.hpp"

#include <sstream>

#include "ramify/core/find_named.hpp"

namespace ramify {

const std::vector<Claim>& claims() {
  static const std::vector<Claim> all{depth_claim(),         height_claim(),    patricia_order_claim(),
                                      patricia_fill_claim(), bst_order_claim(), catalan_order_claim()};
  return all;
}

std::vector<const Claim*> find_claims(std::string_view ids) {
  std::vector<const Claim*> found;
  std::istringstream words{std::string(ids)};
  for (std::string id; words >> id;) found.push_back(&find_named(claims(), &Claim::id, id, "claim"));
  return found;
}

}  // namespace ramify
