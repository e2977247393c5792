#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/dossier/commands.hpp"
#include "ramify/dossier/plain_words.hpp"
#include "ramify/dossier/sections.hpp"
#include "ramify/statistic/order_ratios.hpp"
#include "ramify/text/remarks.hpp"

namespace ramify {
namespace {

/// "3.64 +- 0.11", the error to two digits.
std::string plus_or_minus(double value, double error) {
  if (std::isnan(value)) return "";
  return std::isnan(error) ? fmt::format("{:.4g}", value) : fmt::format("{:.4g} ± {:.2g}", value, error);
}

const HortonRatio* over_all_orders(const HortonLaws& laws, std::string_view quantity, RatioKind kind) {
  const auto found = std::ranges::find_if(laws.ratios, [&](const HortonRatio& ratio) {
    return ratio.quantity == quantity && ratio.estimator == name_of(kind);
  });
  return found == laws.ratios.end() ? nullptr : &*found;
}

/// A quantity of the laws by every estimator over all orders; no row where it has none.
void add_quantity(Table& table, std::string_view what, const HortonLaws& laws, std::string_view quantity) {
  Row row;
  row.text(what);
  bool is_known = false;
  for (const RatioKind kind : ratio_kinds) {
    const HortonRatio* ratio = over_all_orders(laws, quantity, kind);
    row.text(ratio == nullptr ? "" : plus_or_minus(ratio->value, ratio->standard_error));
    is_known = is_known || ratio != nullptr;
  }
  if (is_known) table.add(std::move(row));
}

/// Of nodes, for which no law of errors is known.
void add_nodes(Table& table, const std::vector<std::uint64_t>& nodes) {
  if (nodes.size() < 2) return;
  const OrderRatios ratios = order_ratios(nodes);
  Row row;
  row.text("nodes, divided by");
  for (const double ratio :
       {ratios.mean_ratio, pooled_over_orders(nodes), ratios.regression, ratios.geometric})
    row.text(plus_or_minus(ratio, NAN));
  table.add(std::move(row));
}

Table ratios_table(const Subject& subject, const HortonLaws& laws) {
  Table table({"from order to order", "mean of ratios", "pooled", "regression", "ends"});
  add_quantity(table, "streams, divided by (R_B)", laws, "R_B");
  add_nodes(table, subject.measured.orders.nodes);
  add_quantity(table, "mean length, times (R_L)", laws, "R_L");
  add_quantity(table, "mean radius, times (R_D)", laws, "R_D");
  add_quantity(table, "mean area, times (R_A)", laws, "R_A");
  return table;
}

/// By what each estimator of R_B is off in trees of the model, beside what it would be without bias.
std::string bias_of(const HortonLaws& laws) {
  std::vector<std::string> biases;
  for (const RatioKind kind : ratio_kinds)
    if (const HortonRatio* ratio = over_all_orders(laws, "R_B", kind);
        ratio != nullptr && !std::isnan(ratio->bias))
      biases.push_back(fmt::format("{:+.2g}", ratio->bias));
  if (biases.empty()) return "";
  return fmt::format(
      " In such trees the four estimators of R_B, in this order, differ from the {} {:.4g} by {} in the "
      "mean.",
      laws.reference_name == "limit" ? "limiting ratio" : "pooled ratio of expected counts,", laws.reference,
      listed(biases));
}

/// What the errors are, and the notes on R_B.
std::string words_on_errors(const HortonLaws& laws) {
  std::string words =
      laws.model.empty()
          ? std::string("After ± stands the standard error, from the scatter about the regression.")
          : fmt::format(
                "After ± stands the standard error: of R_B from {} trees of {}, fitted to the counts of "
                "streams; of means from their scatter about the regression.{}",
                laws.trees, laws.model, bias_of(laws));
  const HortonRatio* regression = over_all_orders(laws, "R_B", RatioKind::regression);
  if (regression != nullptr && !regression->note.empty())
    words += fmt::format(" Of R_B: {}.", regression->note);
  return words + " The command has the ranges of orders (_below_top, _inner, _dense) too.";
}

std::string words_on_murray(const MurrayExponent& murray) {
  if (std::isnan(murray.median))
    return fmt::format(
        "Murray's exponent, the median over {}, is infinite: in half of them a child is as thick as its "
        "parent.",
        counted(murray.forks, "fork"));
  return fmt::format("Murray's exponent, fork by fork: {:.4g}, the median over {}.", murray.median,
                     counted(murray.forks, "fork"));
}

}  // namespace

PageSection ratios_section(const Subject& subject, const Findings& findings, const ReportRequest& request) {
  PageSection section{"Ratios", {}, {}};
  Table table = ratios_table(subject, findings.ratios);
  if (table.rows() == 0) {
    section.blocks.emplace_back(PageParagraph{"With one order there is no ratio."});
    return section;
  }
  section.blocks.emplace_back(PageTable{
      "By every estimator: mean of the ratios of neighbouring orders; sum over orders but the highest by sum "
      "but the lowest; least-squares line through the logarithms; lowest and highest order alone",
      std::move(table)});
  section.blocks.emplace_back(PageParagraph{words_on_errors(findings.ratios)});
  if (const MurrayExponent& murray = subject.measured.orders.murray; murray.forks > 0)
    section.blocks.emplace_back(PageParagraph{words_on_murray(murray)});
  std::vector<std::string_view> names;
  for (const Family* family : findings.error_families) names.push_back(family->name);
  section.blocks.emplace_back(
      PageCommands{{horton_command(subject, request, fmt::format("{}", fmt::join(names, ",")))}});
  return section;
}

}  // namespace ramify
