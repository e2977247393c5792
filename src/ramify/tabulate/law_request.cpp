#include "ramify/tabulate/law_request.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/core/contract.hpp"
#include "ramify/core/error.hpp"
#include "ramify/core/nearest_name.hpp"

namespace ramify {
namespace {

std::string in_bytes(double bytes) {
  return bytes < 1e12 ? fmt::format("{:.3g} GB", bytes / 1e9) : fmt::format("{:.3g} TB", bytes / 1e12);
}

std::string in_hours(double seconds) {
  const double hours = seconds / 3600;
  return hours < 100 ? fmt::format("{:.2g} h", hours) : fmt::format("{:.2g} days", hours / 24);
}

}  // namespace

const std::vector<std::string>& law_statistics() {
  static const std::vector<std::string> all{"strahler",   "height",  "depth", "external_depth",
                                            "fill_level", "balance", "orders"};
  return all;
}

const std::vector<std::string>& moment_statistics() {
  static const std::vector<std::string> all{"path_length", "sackin", "colless"};
  return all;
}

Size LawRequest::largest_size() const {
  RAMIFY_EXPECTS(!sizes.empty());
  return *std::max_element(sizes.begin(), sizes.end());
}

LawKind LawRequest::kind() const {
  const auto is_in = [this](const auto& names) {
    return std::find(names.begin(), names.end(), statistic) != names.end();
  };
  const bool is_sum = is_in(moment_statistics());
  if (!is_sum && !is_in(law_statistics())) {
    auto known = law_statistics();
    known.insert(known.end(), moment_statistics().begin(), moment_statistics().end());
    throw Error(
        fmt::format("no exact law of '{}'", statistic),
        fmt::format("known are those of {}", fmt::join(known, ", ")),
        did_you_mean(statistic, known) + "name one of them; orders has the nodes and streams of every order");
  }
  if (statistic == "orders")
    return quantity == LawQuantity::law ? LawKind::order_means : LawKind::order_moments;
  if (is_sum && quantity == LawQuantity::law)
    throw Error(fmt::format("law of {}", statistic), "only its mean and variance are computed",
                "add --moments");
  if (quantity == LawQuantity::covariances)
    throw Error(fmt::format("covariances of {}", statistic), "it is one number",
                "take --moments, or --statistic orders");
  if (is_sum) return LawKind::node_sum;
  if (statistic == "height") return LawKind::height;
  return statistic == "depth" || statistic == "external_depth" ? LawKind::depth : LawKind::bounded;
}

void require_computable(const LawRequest& request, const LawCost& limit) {
  const LawKind kind = request.kind();
  if (!request.model.is_split())
    throw Error(fmt::format("laws of {}", request.model.text()), "exact laws are those of split trees",
                "sample it: ramify sample --model ...");
  for (const Size n : request.sizes) request.model.require_size(n);
  const LawCost cost = law_cost(request.model, kind, request.largest_size());
  const std::string what =
      fmt::format("{} of {} to n = {}", request.statistic, request.model.text(), request.largest_size());
  const auto affordable = [&] { return largest_affordable(request.model, kind, limit); };
  if (cost.bytes > limit.bytes)
    throw Error(fmt::format("{} needs about {} of memory", what, in_bytes(cost.bytes)),
                fmt::format("this machine has {}", in_bytes(limit.bytes)),
                fmt::format("take --n {} or less", affordable()));
  if (cost.seconds > limit.seconds)
    throw Error(fmt::format("{} takes about {}", what, in_hours(cost.seconds)),
                fmt::format("more than {}", in_hours(limit.seconds)),
                fmt::format("add --yes if you mean it, or take --n {} or less", affordable()));
}

}  // namespace ramify
