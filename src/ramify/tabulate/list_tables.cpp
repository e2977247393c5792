#include "ramify/tabulate/list_tables.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/family/family.hpp"
#include "ramify/model/preset.hpp"
#include "ramify/model/registry.hpp"
#include "ramify/sample/sampling_method.hpp"
#include "ramify/statistic/registry.hpp"

namespace ramify {
namespace {

std::string known_without_sampling(const StatisticInfo& info) {
  switch (known_of(info.law.recurrence)) {
    case Known::nothing:
      return "";
    case Known::value:
      return "known";
    case Known::moments:
      return "exact moments";
    case Known::law:
      break;
  }
  return "exact law";
}

/// How trees of split models are sampled for a statistic alone.
std::string sampling_of(const StatisticInfo& info) {
  const FoldSet pass = sampling_method(StatisticSet({&info}), true).pass;
  if (is_streamed(pass)) return "streamed";
  if (is_walk(pass)) return "walked, grafted with others";
  return pass == orders_and_height || pass == orders_and_paths ? "grafted with others" : "grafted";
}

std::string coverage_of(const StatisticInfo& statistic, const ModelInfo& model) {
  if (statistic.needs_binary && !model.is_binary) return "not defined";
  if (!model.is_split) return "streamed";
  std::string known = known_without_sampling(statistic);
  if (known_of(statistic.law.recurrence) == Known::value) return known;
  const std::string sampled = sampling_of(statistic) == "streamed" ? "streamed" : "grafted";
  return known.empty() ? sampled : known + " + " + sampled;
}

}  // namespace

Table model_table() {
  Table table({"name", "n_counts", "domain", "description", "sampled", "source"});
  for (const ModelInfo& info : models())
    table.add(Row().texts({info.signature(), info.n_counts, info.domain(), info.description,
                           info.is_split ? "exact laws; grafted" : "every node grown", info.source}));
  return table;
}

Table family_table() {
  Table table({"name", "parameters", "searched", "given", "description", "alike"});
  for (const Family& family : all_families()) {
    std::vector<std::string_view> names;
    std::vector<std::string> ranges;
    for (const FamilyParameter& parameter : family.parameters) {
      names.push_back(parameter.name);
      ranges.push_back(fmt::format("{} <= {} <= {}", parameter.lowest, parameter.name, parameter.highest));
    }
    table.add(Row()
                  .text(family.name)
                  .text(fmt::format("{}", fmt::join(names, ",")))
                  .text(family.closed_form.empty() ? fmt::format("{}", fmt::join(ranges, ", "))
                                                   : std::string(family.closed_form))
                  .texts({name_of(family.given), family.model->description, family.alike}));
  }
  return table;
}

Table statistic_table() {
  Table table({"name", "columns", "convention", "description", "known", "sampled", "source"});
  for (const StatisticInfo& info : statistics())
    table.add(Row().texts({info.name, info.columns(), info.convention, info.description,
                           known_without_sampling(info), sampling_of(info), info.source}));
  return table;
}

Table coverage_table() {
  std::vector<std::vector<std::string>> columns;
  std::vector<std::string> header{"statistic"};
  for (const ModelInfo& model : models()) {
    std::vector<std::string> column;
    for (const StatisticInfo& statistic : statistics()) column.push_back(coverage_of(statistic, model));
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
    row.text(statistics()[i].get().name);
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
