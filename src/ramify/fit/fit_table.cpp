#include "ramify/fit/fit_table.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include <fmt/format.h>

#include "ramify/core/number.hpp"

namespace ramify {
namespace {

constexpr int digits = 6;

void add_reals(Row& row, std::initializer_list<double> values) {
  for (const double value : values) row.significant(value, digits);
}

/// 0 stands for none.
void add_count(Row& row, std::size_t count) {
  if (count == 0)
    row.nothing();
  else
    row.whole(count);
}

std::string interval(double low, double high) {
  return std::isnan(low) ? std::string() : fmt::format("{:.4g} .. {:.4g}", low, high);
}

std::string with_error(double value, double error) {
  if (std::isnan(value)) return {};
  if (std::isnan(error)) return fmt::format("{:.4f}", value);
  return fmt::format("{:.4f} +- {:.4f}", value, error);
}

std::string heading(const FitRow& row) {
  if (row.parameter == "murray_exponent") return fmt::format("{}: R_B {:.4g}", row.data, row.observed);
  if (row.n == 0) return fmt::format("{}: R {:.4g}, n unknown", row.data, row.observed);
  return fmt::format("{}: R {:.4g}, n {} ({})", row.data, row.observed, row.n, row.n_source);
}

std::vector<std::string> cells(const FitRow& row) {
  std::string status(status_name(row.status));
  if (row.solutions > 1) status.append(fmt::format(" {} of {}", row.solution, row.solutions));
  return {"  " + row.parameter,
          with_error(row.estimate, row.standard_error),
          interval(row.lower, row.upper),
          format_significant(std::round(row.observed * 1e4) / 1e4, digits),
          with_error(row.expected_at_rule, row.expected_at_rule_error),
          interval(row.rule_low, row.rule_high),
          std::move(status)};
}

void append_aligned(std::string& text, const std::vector<std::string>& fields,
                    const std::vector<std::size_t>& widths) {
  std::string line;
  for (std::size_t i = 0; i < fields.size(); ++i) line.append(fmt::format("{:<{}}  ", fields[i], widths[i]));
  line.erase(line.find_last_not_of(' ') + 1);
  text.append(line).append("\n");
}

}  // namespace

std::string_view status_name(FitStatus status) {
  switch (status) {
    case FitStatus::computed:
      return "computed";
    case FitStatus::converged:
      return "converged";
    case FitStatus::no_solution:
      return "no_solution";
    case FitStatus::undetermined:
      return "undetermined";
    case FitStatus::not_converged:
      break;
  }
  return "not_converged";
}

bool any_not_converged(std::span<const FitRow> rows) {
  return std::any_of(rows.begin(), rows.end(),
                     [](const FitRow& row) { return row.status == FitStatus::not_converged; });
}

Table fit_table(std::span<const FitRow> rows) {
  Table table({"data", "model", "parameter", "estimate", "standard_error", "lower", "upper", "n", "n_source",
               "estimator", "observed", "expected_at_rule", "expected_at_rule_error", "rule_low", "rule_high",
               "solution", "solutions", "status", "note"});
  for (const FitRow& fit : rows) {
    Row row;
    row.text(fit.data).text(fit.model).text(fit.parameter);
    add_reals(row, {fit.estimate, fit.standard_error, fit.lower, fit.upper});
    add_count(row, fit.n);
    row.text(fit.n_source).text(fit.estimator);
    add_reals(row,
              {fit.observed, fit.expected_at_rule, fit.expected_at_rule_error, fit.rule_low, fit.rule_high});
    add_count(row, fit.solution);
    add_count(row, fit.solutions);
    table.add(row.text(status_name(fit.status)).text(fit.note));
  }
  return table;
}

std::string fit_text(std::span<const FitRow> rows) {
  const std::vector<std::string> header{"  parameter", "estimate",         "lower .. upper", "measured",
                                        "at the rule", "95 % at the rule", "status"};
  std::vector<std::size_t> widths;
  for (const std::string& title : header) widths.push_back(title.size());
  for (const FitRow& row : rows) {
    const auto fields = cells(row);
    for (std::size_t i = 0; i < fields.size(); ++i) widths[i] = std::max(widths[i], fields[i].size());
  }
  std::string text;
  append_aligned(text, header, widths);
  for (const FitRow& row : rows) {
    if (row.parameter == "p_rule" || row.parameter == "murray_exponent")
      text.append(heading(row)).append("\n");
    append_aligned(text, cells(row), widths);
    if (!row.note.empty() && row.solution <= 1) text.append("      ").append(row.note).append("\n");
  }
  return text;
}

}  // namespace ramify
