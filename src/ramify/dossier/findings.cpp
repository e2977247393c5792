#include "ramify/dossier/findings.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "ramify/core/number.hpp"
#include "ramify/family/observed_splits.hpp"
#include "ramify/fit/tree_bootstrap.hpp"
#include "ramify/fit/tree_fit.hpp"
#include "ramify/text/remarks.hpp"
#include "ramify/tree/resolve_forks.hpp"

namespace ramify {
namespace {

constexpr int model_digits = 6;  // of the best model's parameters: what is simulated can be typed

ModelFitOptions fit_options(const ReportRequest& request, std::vector<const Family*> families) {
  return {std::move(families), 0, request.seed, request.threads};
}

/// Families for which the tree has enough nodes that divide in more ways than one; the others are left out.
void choose_by_size(const Subject& subject, Findings& findings) {
  const ObservedSplits splits(subject.tree->tree, subject.name);
  const auto is_small = [&splits](const Family* family) { return !are_enough(splits, *family); };
  std::ranges::copy_if(findings.fitted, std::back_inserter(findings.left_out), is_small);
  std::erase_if(findings.fitted, is_small);
}

/// The p-value of the best family's fit, by trees of it.
void bootstrap_best(const Subject& subject, const ReportRequest& request, const Cancellation& cancellation,
                    FittedDatum& datum) {
  FamilyFit& best = datum.fits.front();
  if (request.bootstrap == 0 || datum.n > largest_compared || !best.converged) return;
  bootstrap_tree_fit(best, ObservedSplits(subject.tree->tree, subject.name),
                     {request.bootstrap, request.seed}, request.threads, cancellation);
}

void fit_tree(const Subject& subject, const ReportRequest& request, const Cancellation& cancellation,
              Findings& findings) {
  if (const std::size_t wide = wide_forks(subject.tree->tree); wide > 0) {
    findings.why_no_fit = fmt::format(
        "The tree has {} of three branches or more, and trees of all families are binary: --resolve ladder "
        "or "
        "--resolve random makes it so.",
        counted(wide, "fork"));
    return;
  }
  choose_by_size(subject, findings);
  if (findings.fitted.empty()) {
    findings.why_no_fit = "The tree is too small: trees of every family are alike at this size.";
    return;
  }
  const ModelFitOptions options = fit_options(request, findings.fitted);
  findings.fit = fit_whole_trees({&*subject.tree, 1}, subject.file, false, options, cancellation).front();
  bootstrap_best(subject, request, cancellation, *findings.fit);
}

void fit_table(const Subject& subject, const ReportRequest& request, const Cancellation& cancellation,
               Findings& findings) {
  if (const std::string few = too_few_to_fit(*subject.counts); !few.empty()) {
    findings.why_no_fit = fmt::format("The table is too small to fit anything to it: {}.", few);
    return;
  }
  const ModelFitOptions options = fit_options(request, findings.fitted);
  findings.fit = fit_order_counts({&*subject.counts, 1}, subject.file, options, cancellation).front();
}

std::optional<Model> model_of(const FamilyFit& fit) {
  if (!fit.converged || std::isnan(fit.log_likelihood)) return std::nullopt;
  std::vector<double> values;
  for (const double estimate : fit.estimates())
    values.push_back(*parse_real(format_significant(estimate, model_digits)));
  return fit.family->at(values);
}

void compare(const Subject& subject, const ReportRequest& request, const Cancellation& cancellation,
             Findings& findings) {
  const Size n = subject.tree->tree.size();
  if (n > largest_compared) {
    findings.why_not_compared = fmt::format(
        "Not done for trees of more than {} internal nodes, for it takes minutes; the command does it.",
        largest_compared);
    return;
  }
  TreeComparison comparison(*findings.best, {request.seed, request.replicates, request.threads},
                            cancellation);
  findings.compared = comparison(subject.tree->tree, subject.name);
}

/// Of those that were fitted the best that has one parameter or none, for two take minutes from counts; where
/// nothing was fitted, all that horton_laws takes.
std::vector<const Family*> families_of_errors(const Findings& findings) {
  if (findings.fit)
    for (const FamilyFit& fit : findings.fit->fits)
      if (fit.family->parameters.size() <= 1 && fit.family->given == Given::size &&
          !fit.family->is_simulated() && fit.converged)
        return {fit.family};
  return one_parameter_families();
}

void take_ratios(const Subject& subject, const ReportRequest& request, const Cancellation& cancellation,
                 Findings& findings) {
  HortonOptions options;
  options.families = findings.error_families = families_of_errors(findings);
  options.trees.seed = request.seed;
  options.trees.threads = request.threads;
  findings.ratios = horton_laws({&subject.measured.orders, 1}, options, cancellation).front();
}

}  // namespace

std::vector<const Family*> quick_families(const Subject& subject) {
  std::vector<const Family*> quick;
  for (const Family& family : families())
    if (subject.tree || family.parameters.size() <= 1) quick.push_back(&family);
  return quick;
}

Findings find_out(const Subject& subject, const ReportRequest& request, const Cancellation& cancellation) {
  Findings findings;
  findings.fitted = request.families.empty() ? quick_families(subject) : request.families;
  if (request.families.empty())
    for (const Family& family : families())
      if (std::ranges::find(findings.fitted, &family) == findings.fitted.end())
        findings.left_out.push_back(&family);
  if (subject.tree)
    fit_tree(subject, request, cancellation, findings);
  else
    fit_table(subject, request, cancellation, findings);
  take_ratios(subject, request, cancellation, findings);
  if (!findings.fit) return findings;
  findings.best = model_of(findings.fit->fits.front());
  if (subject.tree && findings.best) compare(subject, request, cancellation, findings);
  return findings;
}

}  // namespace ramify
