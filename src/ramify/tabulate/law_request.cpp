#include "ramify/tabulate/law_request.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/core/contract.hpp"
#include "ramify/core/error.hpp"
#include "ramify/core/nearest_name.hpp"
#include "ramify/statistic/registry.hpp"

namespace ramify {
namespace {

std::string in_bytes(double bytes) {
  return bytes < 1e12 ? fmt::format("{:.3g} GB", bytes / 1e9) : fmt::format("{:.3g} TB", bytes / 1e12);
}

std::string in_hours(double seconds) {
  const double hours = seconds / 3600;
  return hours < 100 ? fmt::format("{:.2g} h", hours) : fmt::format("{:.2g} days", hours / 24);
}

constexpr std::string_view orders = "orders";

std::vector<std::string> subjects(Known known) {
  std::vector<std::string> names;
  for (const StatisticInfo& info : statistics())
    if (known_of(info.law.recurrence) == known) names.emplace_back(info.name);
  return names;
}

}  // namespace

std::vector<std::string> law_subjects() {
  auto names = subjects(Known::law);
  names.emplace_back(orders);
  return names;
}

std::vector<std::string> moment_subjects() {
  return subjects(Known::moments);
}

LawSubject LawSubject::parse(std::string_view name) {
  if (name == orders) return {{&statistic::nodes, &statistic::streams}};
  for (const StatisticInfo& info : ramify::statistics())
    if (info.name == name && known_of(info.law.recurrence) >= Known::moments) return {{&info}};
  auto known = law_subjects();
  std::ranges::copy(moment_subjects(), std::back_inserter(known));
  throw Error(
      fmt::format("no exact law of '{}'", name), fmt::format("known are those of {}", fmt::join(known, ", ")),
      did_you_mean(name, known) + "name one of them; orders has the nodes and streams of every order");
}

std::string_view LawSubject::name() const {
  return is_orders() ? orders : statistics.front()->name;
}

Size LawRequest::largest_size() const {
  RAMIFY_EXPECTS(!sizes.empty());
  return *std::max_element(sizes.begin(), sizes.end());
}

LawWork LawRequest::work() const {
  const Recurrence& recurrence = subject.statistics.front()->law.recurrence;
  if (subject.is_orders()) return {recurrence, quantity == LawQuantity::law};
  if (quantity == LawQuantity::law && known_of(recurrence) == Known::moments)
    throw Error(fmt::format("law of {}", subject.name()), "only its mean and variance are computed",
                "add --moments");
  if (quantity == LawQuantity::covariances)
    throw Error(fmt::format("covariances of {}", subject.name()), "it is one number",
                "take --moments, or --statistic orders");
  return {recurrence};
}

void require_computable(const LawRequest& request, const LawCost& limit) {
  const LawWork work = request.work();
  if (!request.model.is_split())
    throw Error(fmt::format("laws of {}", request.model.text()), "exact laws are those of split trees",
                "sample it: ramify sample --model ...");
  for (const Size n : request.sizes) request.model.require_size(n);
  const LawCost cost = law_cost(request.model, work, request.largest_size());
  const std::string what =
      fmt::format("{} of {} to n = {}", request.subject.name(), request.model.text(), request.largest_size());
  const auto affordable = [&] { return largest_affordable(request.model, work, limit); };
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
