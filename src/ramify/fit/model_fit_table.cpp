#include "ramify/fit/model_fit_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/fit/note.hpp"
#include "ramify/io/text_writer.hpp"

namespace ramify {
namespace {

constexpr int table_digits = 6;

std::string_view status_of(const FamilyFit& fit) {
  if (std::isnan(fit.log_likelihood)) return "not_fitted";
  if (!fit.converged) return "not_converged";
  if (fit.parameters.empty()) return "no_parameter";
  return fit.at_end ? "at_end" : "converged";
}

void add_other_optima(std::string& note, const FamilyFit& fit) {
  for (const auto& other : fit.other_optima)
    add_note(note, fmt::format("another optimum at ({:.4g})", fmt::join(other, ",")));
}

std::string note_of(const FamilyFit& fit, const FittedDatum& datum) {
  std::string note = fit.note;
  if (std::isnan(fit.log_likelihood)) return note;
  add_note(note, fmt::format("from {}", datum.used));
  add_note(note, fit.family->alike);
  if (fit.at_end) add_note(note, "the likelihood rises to the end of what is searched");
  add_other_optima(note, fit);
  return note;
}

/// Of one parameter, as far as it was found.
void add_estimate(Row& row, const FamilyFit& fit, const FittedParameter& parameter) {
  row.text(parameter.name).significant(parameter.estimate, table_digits);
  if (!fit.converged) {
    row.nothing().nothing().nothing();
    return;
  }
  row.significant(parameter.standard_error, table_digits);
  for (const auto& [end, is_open] :
       {std::pair(parameter.lower, parameter.lower_open), std::pair(parameter.upper, parameter.upper_open)}) {
    if (is_open)
      row.text("open");
    else
      row.significant(end, table_digits);
  }
}

void add_bootstrap(Row& row, const FamilyFit& fit, std::size_t parameter) {
  if (fit.goodness.trees == 0 || parameter >= fit.bootstrap.size()) {
    row.nothing().nothing().nothing().nothing();
    return;
  }
  const BootstrapEstimate& found = fit.bootstrap[parameter];
  row.whole(fit.goodness.trees).significant(found.lower, table_digits).significant(found.upper, table_digits);
  row.significant(found.bias, table_digits);
}

/// The row that a test of a simpler family has: "bst_suffices".
std::string suffices(const NestedTest& test) {
  return fmt::format("{}_suffices", test.simpler->name);
}

/// Of a p-value.
double monte_carlo_error(const NestedTest& test) {
  return std::sqrt(test.p_value * (1 - test.p_value) / static_cast<double>(test.trees));
}

class Rows {
 public:
  Rows(const FittedDatum& datum, Table& table) : datum_(datum), table_(table) {}

  void add(const FamilyFit& fit, std::size_t rank) {
    if (fit.parameters.empty()) {
      Row row = begun(fit);
      row.nothing().nothing().nothing().nothing().nothing();
      finish(row, fit, rank, 0);
    }
    for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
      Row row = begun(fit);
      add_estimate(row, fit, fit.parameters[i]);
      finish(row, fit, rank, i);
    }
    if (fit.horton_ratio) {
      Row row = begun(fit);
      add_estimate(row, fit, *fit.horton_ratio);
      finish(row, fit, rank, fit.parameters.size());
    }
    for (const NestedTest& test : fit.simpler) add_test(fit, rank, test);
  }

 private:
  void add_test(const FamilyFit& fit, std::size_t rank, const NestedTest& test) {
    Row row = begun(fit);
    row.text(suffices(test)).significant(test.p_value, table_digits);
    row.significant(monte_carlo_error(test), table_digits).nothing().nothing();
    finish(row, fit, rank, fit.parameters.size(), test.likelihood_ratio);
  }

  Row begun(const FamilyFit& fit) const {
    Row row;
    row.text(datum_.data).text(fit.family->name);
    return row;
  }

  void finish(Row& row, const FamilyFit& fit, std::size_t rank, std::size_t parameter,
              double likelihood_ratio = std::numeric_limits<double>::quiet_NaN()) {
    row.text(datum_.observable).whole(datum_.n).whole(rank);
    row.fixed(fit.log_likelihood, 4).fixed(fit.aic(), 4).fixed(fit.bic(), 4);
    row.fixed(fit.aic() - datum_.fits.front().aic(), 4);
    row.significant(fit.goodness.statistic, table_digits).significant(fit.goodness.p_value, table_digits);
    row.significant(likelihood_ratio, table_digits);
    add_bootstrap(row, fit, parameter);
    table_.add(row.text(status_of(fit)).text(note_of(fit, datum_)));
  }

  const FittedDatum& datum_;
  Table& table_;
};

}  // namespace

Table model_fit_table(std::span<const FittedDatum> data) {
  Table table({"data",
               "model",
               "parameter",
               "estimate",
               "standard_error",
               "lower",
               "upper",
               "observable",
               "n",
               "rank",
               "log_likelihood",
               "aic",
               "bic",
               "delta_aic",
               "misfit",
               "misfit_p",
               "likelihood_ratio",
               "bootstrap_trees",
               "bootstrap_lower",
               "bootstrap_upper",
               "bootstrap_bias",
               "status",
               "note"});
  for (const FittedDatum& datum : data) {
    Rows rows(datum, table);
    for (std::size_t i = 0; i < datum.fits.size(); ++i) rows.add(datum.fits[i], i + 1);
  }
  return table;
}

namespace {

/// As many decimals as the error has, with two digits of it.
std::string decimal_text(double value, double error) {
  if (!(error > 0)) return fmt::format("{:.4g}", value);
  return fmt::format("{:.{}f}", value, std::max(0, 1 - static_cast<int>(std::floor(std::log10(error)))));
}

}  // namespace

std::string estimate_text(const FittedParameter& parameter) {
  const std::string estimate = decimal_text(parameter.estimate, parameter.standard_error);
  return std::isnan(parameter.standard_error)
             ? estimate
             : fmt::format("{} +- {:.2g}", estimate, parameter.standard_error);
}

std::string interval_text(const FittedParameter& parameter) {
  if (std::isnan(parameter.lower)) return {};
  return fmt::format("{}{} .. {}{}", parameter.lower_open ? "open " : "",
                     decimal_text(parameter.lower, parameter.standard_error),
                     decimal_text(parameter.upper, parameter.standard_error),
                     parameter.upper_open ? " open" : "");
}

namespace {

/// One row a parameter; those of the whole fit stand in its first.
void add_lines(const FamilyFit& fit, double least_aic, Table& table) {
  std::vector<FittedParameter> shown = fit.parameters;
  if (fit.horton_ratio) shown.push_back(*fit.horton_ratio);
  for (std::size_t i = 0; i < std::max<std::size_t>(1, shown.size()); ++i) {
    Row row;
    row.text(i == 0 ? fit.family->name : "");
    if (shown.empty()) {
      row.nothing().nothing().nothing();
    } else {
      row.text(shown[i].name);
      row.text(estimate_text(shown[i]));
      row.text(fit.converged ? interval_text(shown[i]) : "");
    }
    if (i == 0)
      row.fixed(fit.aic() - least_aic, 1).significant(fit.goodness.p_value, 2).text(status_of(fit));
    else
      row.nothing().nothing().nothing();
    table.add(std::move(row));
  }
  for (const NestedTest& test : fit.simpler) {
    Row row;
    row.text("").text(suffices(test));
    row.text(fmt::format("P {:.2g}, likelihood ratio {:.3g}", test.p_value, test.likelihood_ratio));
    table.add(std::move(row.nothing().nothing().nothing().nothing()));
  }
}

}  // namespace

Table model_fit_lines(const FittedDatum& datum) {
  Table table({"model", "parameter", "estimate", "95 % interval", "AIC - best", "misfit p", "status"});
  for (const FamilyFit& fit : datum.fits) add_lines(fit, datum.fits.front().aic(), table);
  return table;
}

std::string model_fit_text(std::span<const FittedDatum> data) {
  std::string text;
  for (const FittedDatum& datum : data) {
    text += fmt::format("{}{}, n {}, from {}\n", text.empty() ? "" : "\n", datum.data, datum.n, datum.used);
    if (datum.given == Given::order)
      text +=
          "Given the order of the root, so that AIC is not to be compared with that of families given n.\n";
    text += write_text(model_fit_lines(datum));
    for (const FamilyFit& fit : datum.fits) {
      std::string note = fit.note;
      add_other_optima(note, fit);
      if (!note.empty()) text += fmt::format("  {}: {}\n", fit.family->name, note);
    }
  }
  return text;
}

bool any_not_converged(std::span<const FittedDatum> data) {
  return std::ranges::any_of(data, [](const FittedDatum& datum) {
    return std::ranges::any_of(
        datum.fits, [](const FamilyFit& fit) { return !fit.converged && !std::isnan(fit.log_likelihood); });
  });
}

}  // namespace ramify
