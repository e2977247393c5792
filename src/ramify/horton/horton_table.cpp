#include "ramify/horton/horton_table.hpp"

#include <cmath>

#include <fmt/format.h>

namespace ramify {
namespace {

constexpr int ratio_digits = 5;

std::string_view name_of(ErrorSource source) {
  switch (source) {
    case ErrorSource::law:
      return "law";
    case ErrorSource::trees:
      return "trees";
    case ErrorSource::scatter:
      return "scatter";
    case ErrorSource::ratios:
      return "ratios";
    case ErrorSource::none:
      break;
  }
  return "";
}

/// "14/15" of a ratio of counts, "12" of a mean; several with a blank between.
std::string outlying_text(const HortonRatio& ratio, unsigned leaf_order) {
  std::string text;
  for (const std::size_t k : ratio.outlying) {
    if (!text.empty()) text += ' ';
    text += fmt::to_string(k + leaf_order);
    if (ratio.quantity == "R_B") text += fmt::format("/{}", k + 1 + leaf_order);
  }
  return text;
}

void add_row(const HortonLaws& tree, const HortonRatio& ratio, unsigned leaf_order, Table& table) {
  Row row;
  row.text(tree.data).text(ratio.quantity).text(ratio.estimator);
  if (ratio.estimator == "forks")
    row.nothing().nothing();
  else
    row.whole(ratio.orders.first + leaf_order).whole(ratio.orders.last + leaf_order);
  row.significant(ratio.value, ratio_digits).significant(ratio.standard_error, ratio_digits);
  row.text(std::isnan(ratio.standard_error) ? "" : name_of(ratio.error_from));
  row.significant(ratio.bias, ratio_digits).text(std::isnan(ratio.bias) ? "" : tree.reference_name);
  const bool of_model = ratio.error_from == ErrorSource::law || ratio.error_from == ErrorSource::trees;
  row.text(of_model ? tree.model : "");
  if (ratio.error_from == ErrorSource::trees)
    row.whole(tree.trees);
  else
    row.nothing();
  table.add(std::move(row.text(outlying_text(ratio, leaf_order)).text(ratio.note)));
}

}  // namespace

Table horton_table(std::span<const HortonLaws> trees, unsigned leaf_order) {
  Table table({"data", "quantity", "estimator", "first_order", "last_order", "value", "standard_error",
               "error_from", "bias", "bias_from", "model", "trees", "outlying", "note"});
  for (const HortonLaws& tree : trees)
    for (const HortonRatio& ratio : tree.ratios) add_row(tree, ratio, leaf_order, table);
  return table;
}

}  // namespace ramify
