#include <algorithm>
#include <array>

#include "claim.hpp"
#include "session.hpp"

#include "ramify/core/nearest_name.hpp"
#include "ramify/experiment/law_request.hpp"
#include "ramify/io/csv_writer.hpp"
#include "ramify/model/registry.hpp"
#include "ramify/sample/sampling_method.hpp"
#include "ramify/statistic/registry.hpp"

namespace ramify::cli {
namespace {

std::string model_table() {
  CsvTable table({"name", "n_counts", "domain", "description", "sampled", "source"});
  for (const auto& info : models())
    table.add({info.signature(), std::string(info.n_counts), std::string(info.domain),
               std::string(info.description), info.is_split ? "exact laws; grafted" : "every node grown",
               std::string(info.source)});
  return table.text();
}

/// What is known without sampling, and how large trees are sampled.
std::string sampling_of(const StatisticInfo& info) {
  if (info.measure == Measure::size) return "known";
  const auto is_in = [&info](const auto& names) {
    return std::find(names.begin(), names.end(), info.name) != names.end();
  };
  const bool has_moments = is_in(moment_statistics()) || info.shape == Columns::orders;
  const std::string known = is_in(law_statistics()) ? "exact law; " : has_moments ? "exact moments; " : "";
  const std::array<std::string, 1> alone{std::string(info.name)};
  switch (sampling_method(StatisticSet::parse(alone), true).pass) {
    case Pass::lean:
    case Pass::full:
      return known + "grafted with others";
    case Pass::all:
      return known + "every node grown";
    case Pass::depth:
    case Pass::external_depth:
      return known + "walked alone, grafted with others";
    default:
      return known + "grafted alone or with others";
  }
}

std::string statistic_table() {
  CsvTable table({"name", "columns", "convention", "description", "sampled", "source"});
  for (const auto& info : statistics())
    table.add({std::string(info.name), info.columns(), std::string(info.convention),
               std::string(info.description), sampling_of(info), std::string(info.source)});
  return table.text();
}

/// Statistic by model: what is known of it without sampling and how it is sampled.
std::string coverage_table() {
  std::vector<std::string> header{"statistic"};
  for (const auto& model : models()) header.emplace_back(model.name);
  CsvTable table(std::move(header));
  for (const auto& statistic : statistics()) {
    std::vector<std::string> row{std::string(statistic.name)};
    for (const auto& model : models())
      row.push_back(model.is_split ? sampling_of(statistic) : "every node grown");
    table.add(std::move(row));
  }
  return table.text();
}

std::string claim_table() {
  CsvTable table({"claim", "statement", "source"});
  for (const auto& claim : claims())
    table.add({std::string(claim.id), std::string(claim.statement), std::string(claim.source)});
  return table.text();
}

std::string table_of(const std::string& what) {
  if (what == "models") return model_table();
  if (what == "statistics") return statistic_table();
  if (what == "claims") return claim_table();
  if (what == "coverage") return coverage_table();
  throw Error("cannot list '" + what + "'", "there is no such list",
              did_you_mean(what, {"models", "statistics", "claims", "coverage"}) +
                  "list models, statistics, claims or coverage");
}

}  // namespace

void add_list(CLI::App& app, Session& session) {
  struct Options {
    std::string what, output;
  };
  auto options = std::make_shared<Options>();
  auto* verb = app.add_subcommand(
      "list", "List the models, statistics, claims, or what is known of which statistic for which model");
  verb->add_option("what", options->what, "models, statistics, claims or coverage")->required();
  verb->add_option("-o,--output", options->output, "write the table to this file");
  verb->footer("Example: ramify list models");
  verb->callback([&session, options] {
    session.work = [options] {
      emit(table_of(options->what), options->output);
      return ExitCode::done;
    };
  });
}

}  // namespace ramify::cli
