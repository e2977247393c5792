#include "ramify/tabulate/law_request.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/core/error.hpp"
#include "ramify/core/memory.hpp"
#include "ramify/core/nearest_name.hpp"
#include "ramify/large/large_orders.hpp"
#include "ramify/large/large_reach.hpp"
#include "ramify/statistic/registry.hpp"

namespace ramify {
namespace {

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

double LawRequest::exact_to() const {
  if (exact || !no_large_laws(model).empty()) return std::numeric_limits<double>::infinity();
  constexpr LawCost at_once{1e10, 1};
  return static_cast<double>(std::max(large_law_table(model), largest_affordable(model, work(), at_once)));
}

std::vector<Size> LawRequest::exact_sizes() const {
  std::vector<Size> below;
  const double end = exact_to();
  for (const double n : sizes)
    if (n <= end) below.push_back(static_cast<Size>(std::min(n, 0x1p63)));
  return below;
}

std::vector<double> LawRequest::large_sizes() const {
  std::vector<double> beyond;
  std::ranges::copy_if(sizes, std::back_inserter(beyond), [end = exact_to()](double n) { return n > end; });
  return beyond;
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

namespace {

/// How the time of an exact law grows is law_cost's to say.
void require_exact(const LawRequest& request, const LawWork& work, const LawCost& limit) {
  const auto sizes = request.exact_sizes();
  for (const Size n : sizes) request.model.require_size(n);
  const Size largest = *std::ranges::max_element(sizes);
  const LawCost cost = law_cost(request.model, work, largest);
  const std::string what =
      fmt::format("{} of {} to n = {}", request.subject.name(), request.model.text(), largest);
  const auto affordable = [&] { return largest_affordable(request.model, work, limit); };
  if (cost.bytes > limit.bytes)
    throw Error(fmt::format("{} needs about {} of memory", what, in_bytes(cost.bytes)),
                fmt::format("this process may use {}", in_bytes(limit.bytes)),
                fmt::format("take --n {} or less", affordable()));
  if (cost.seconds > limit.seconds)
    throw Error(fmt::format("{} takes about {}", what, in_hours(cost.seconds)),
                fmt::format("more than {}", in_hours(limit.seconds)),
                fmt::format("add --yes if you mean it, or take --n {} or less", affordable()));
}

/// Two digits of the largest n whose law takes no longer.
double largest_in(double seconds, const LawRequest& request, const LawWork& work) {
  double low = std::log(request.exact_to()), high = std::log(largest_law_size);
  for (int halved = 0; halved < 60; ++halved) {
    const double middle = (low + high) / 2;
    (large_law_seconds(request.model, work.recurrence, std::exp(middle)) <= seconds ? low : high) = middle;
  }
  const double unit = std::pow(10, std::floor(low / std::numbers::ln10) - 1);
  return std::floor(std::exp(low) / unit) * unit;
}

void require_large(const LawRequest& request, const LawWork& work, const LawCost& limit) {
  const double largest = *std::ranges::max_element(request.sizes);
  if (std::holds_alternative<CountOfOrder>(work.recurrence) && !work.means_alone &&
      largest > largest_covariance_size)
    throw Error(fmt::format("variances and covariances of counts to n = {:g}", largest),
                "rounding would be all that is left of them",
                fmt::format("take --n {:g} or less", largest_covariance_size));
  const double seconds = large_law_seconds(request.model, work.recurrence, largest);
  if (seconds <= limit.seconds) return;
  throw Error(fmt::format("{} of {} to n = {:g} takes about {}", request.subject.name(), request.model.text(),
                          largest, in_hours(seconds)),
              fmt::format("more than {}", in_hours(limit.seconds)),
              fmt::format("add --yes if you mean it, or take --n {:g} or less",
                          largest_in(limit.seconds, request, work)));
}

}  // namespace

void require_computable(const LawRequest& request, const LawCost& limit) {
  const LawWork work = request.work();
  if (!request.model.is_split())
    throw Error(fmt::format("laws of {}", request.model.text()), "exact laws are those of split trees",
                "sample it: ramify sample --model ...");
  if (!request.exact_sizes().empty()) require_exact(request, work, limit);
  if (!request.large_sizes().empty()) require_large(request, work, limit);
}

}  // namespace ramify
