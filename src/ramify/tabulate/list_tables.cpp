#include "ramify/tabulate/list_tables.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "ramify/law/exact_means.hpp"
#include "ramify/model/preset.hpp"
#include "ramify/model/registry.hpp"
#include "ramify/sample/sampling_method.hpp"
#include "ramify/statistic/registry.hpp"

namespace ramify {
namespace {

/// What is known without sampling of a statistic of a split model: they are all alike, so one is asked.
std::string known_of(const StatisticInfo& info) {
  static const ExactMeans exact(Model::parse("bst"), 7);
  const std::array<std::string, 1> alone{std::string(info.name)};
  const std::string column = StatisticSet::parse(alone).columns(1).back().name;
  if (exact.law(column, 7)) return "exact law";
  const auto moments = exact.moments(column, 7);
  if (!moments) return "";
  return moments->variance == 0 ? "known" : "exact moments";
}

/// How trees of split models are sampled for a statistic alone.
std::string sampling_of(const StatisticInfo& info) {
  const std::array<std::string, 1> alone{std::string(info.name)};
  switch (sampling_method(StatisticSet::parse(alone), true).pass) {
    case Pass::lean:
    case Pass::full:
      return "grafted with others";
    case Pass::all:
      return "streamed";
    case Pass::depth:
    case Pass::external_depth:
      return "walked, grafted with others";
    default:
      return "grafted";
  }
}

/// What is known of a statistic of a model without sampling, and how it is sampled.
std::string coverage_of(const StatisticInfo& statistic, const ModelInfo& model) {
  if (statistic.needs_binary && !model.is_binary) return "not defined";
  if (!model.is_split) return "streamed";
  std::string known = known_of(statistic);
  if (known == "known") return known;
  const std::string sampled = sampling_of(statistic) == "streamed" ? "streamed" : "grafted";
  return known.empty() ? sampled : known + " + " + sampled;
}

}  // namespace

Table model_table() {
  Table table({"name", "n_counts", "domain", "description", "sampled", "source"});
  for (const auto& info : models())
    table.add(Row().texts({info.signature(), info.n_counts, info.domain(), info.description,
                           info.is_split ? "exact laws; grafted" : "every node grown", info.source}));
  return table;
}

Table statistic_table() {
  Table table({"name", "columns", "convention", "description", "known", "sampled", "source"});
  for (const auto& info : statistics())
    table.add(Row().texts({info.name, info.columns(), info.convention, info.description, known_of(info),
                           sampling_of(info), info.source}));
  return table;
}

Table coverage_table() {
  std::vector<std::vector<std::string>> columns;
  std::vector<std::string> header{"statistic"};
  for (const auto& model : models()) {
    std::vector<std::string> column;
    for (const auto& statistic : statistics()) column.push_back(coverage_of(statistic, model));
    const auto same = std::find(columns.begin(), columns.end(), column);
    if (same == columns.end()) {
      columns.push_back(std::move(column));
      header.emplace_back(model.name);
    } else {
      header[static_cast<std::size_t>(same - columns.begin()) + 1].append(" ").append(model.name);
    }
  }
  Table table(std::move(header));
  for (std::size_t i = 0; i < statistics().size(); ++i) {
    Row row;
    row.text(statistics()[i].name);
    for (const auto& column : columns) row.text(column[i]);
    table.add(std::move(row));
  }
  return table;
}

Table preset_table() {
  Table table({"name", "model", "n", "description", "source"});
  for (const auto& preset : presets())
    table.add(
        Row().texts({preset.name, preset.model}).whole(preset.n).texts({preset.description, preset.source}));
  return table;
}

}  // namespace ramify
