#include <algorithm>
#include <array>

#include "claim.hpp"
#include "session.hpp"
#include "verbs.hpp"
#include <fmt/format.h>

#include "ramify/core/nearest_name.hpp"
#include "ramify/law/exact_means.hpp"
#include "ramify/model/preset.hpp"
#include "ramify/model/registry.hpp"
#include "ramify/sample/sampling_method.hpp"
#include "ramify/statistic/registry.hpp"

namespace ramify::cli {
namespace {

Table model_table() {
  Table table({"name", "n_counts", "domain", "description", "sampled", "source"});
  for (const auto& info : models())
    table.add(Row().texts({info.signature(), info.n_counts, info.domain(), info.description,
                           info.is_split ? "exact laws; grafted" : "every node grown", info.source}));
  return table;
}

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

Table statistic_table() {
  Table table({"name", "columns", "convention", "description", "known", "sampled", "source"});
  for (const auto& info : statistics())
    table.add(Row().texts({info.name, info.columns(), info.convention, info.description, known_of(info),
                           sampling_of(info), info.source}));
  return table;
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

/// Statistic by model; models of which all is the same share a column.
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

Table claim_table() {
  Table table({"claim", "statement", "source"});
  for (const auto& claim : claims()) table.add(Row().texts({claim.id, claim.statement, claim.source}));
  return table;
}

Table preset_table() {
  Table table({"name", "model", "n", "description", "source"});
  for (const auto& preset : presets())
    table.add(
        Row().texts({preset.name, preset.model}).whole(preset.n).texts({preset.description, preset.source}));
  return table;
}

Table table_of(const std::string& what) {
  if (what == "models") return model_table();
  if (what == "statistics") return statistic_table();
  if (what == "claims") return claim_table();
  if (what == "presets") return preset_table();
  if (what == "coverage") return coverage_table();
  throw Error("cannot list '" + what + "'", "there is no such list",
              did_you_mean(what, {"models", "statistics", "claims", "presets", "coverage"}) +
                  "list models, statistics, claims, presets or coverage");
}

}  // namespace

void add_list(Program& program) {
  struct Options {
    std::string what, output;
  };
  auto options = std::make_shared<Options>();
  Verb verb = program.verb(
      "list",
      "List the models, statistics, claims, presets, or what is known of which statistic for which model");
  verb.option("what", options->what, "models, statistics, claims, presets or coverage", Need::required);
  verb.option("-o,--output", options->output, "write the table to this file");
  verb.example("Example: ramify list models");
  verb.work([options](const Cancellation&) {
    emit(table_of(options->what), options->output);
    return ExitCode::done;
  });
}

}  // namespace ramify::cli
