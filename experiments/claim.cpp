#include "claim.hpp"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/core/nearest_name.hpp"

namespace ramify {

const std::vector<Claim>& claims() {
  static const std::vector<Claim> all{depth_claim(),         height_claim(),    patricia_order_claim(),
                                      patricia_fill_claim(), bst_order_claim(), catalan_order_claim()};
  return all;
}

std::vector<const Claim*> find_claims(std::string_view ids) {
  std::vector<std::string> known;
  for (const auto& claim : claims()) known.emplace_back(claim.id);
  std::vector<const Claim*> found;
  std::istringstream words{std::string(ids)};
  for (std::string id; words >> id;) {
    const auto claim =
        std::find_if(claims().begin(), claims().end(), [&](const Claim& c) { return c.id == id; });
    if (claim == claims().end())
      throw Error(fmt::format("unknown claim '{}'", id), "no claim has that number",
                  did_you_mean(id, known) + "see: ramify list claims");
    found.push_back(&*claim);
  }
  return found;
}

}  // namespace ramify
