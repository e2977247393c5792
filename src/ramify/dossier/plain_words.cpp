#include "ramify/dossier/plain_words.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include <fmt/format.h>

#include "ramify/fit/model_fit_table.hpp"
#include "ramify/statistic/order_ratios.hpp"
#include "ramify/text/remarks.hpp"

namespace ramify {
namespace {

constexpr double level = 0.05;     // of what is said to depart
constexpr double rejected = 0.01;  // of a family that is said not to describe the tree

std::string branching_sentence(const Subject& subject) {
  const auto& streams = subject.measured.orders.streams;
  const std::string what =
      fmt::format("{} has {} and {} of Horton-Strahler", subject.tree ? "The tree" : "The table",
                  counted(streams.front(), "tip"), counted(streams.size(), "order"));
  if (streams.size() < 2) return what + "; with one order there is no ratio.";
  const OrderRatios ratios = order_ratios(streams);
  return what + fmt::format(
                    ". From order to order the number of streams falls by a factor of {:.3g} "
                    "(mean of the ratios; by regression {:.3g}).",
                    ratios.mean_ratio, ratios.regression);
}

std::string described(const FamilyFit& fit) {
  std::vector<std::string> parts;
  for (const FittedParameter& parameter : fit.parameters) {
    const std::string interval = interval_text(parameter);
    parts.push_back(fmt::format("{} = {}{}", parameter.name, estimate_text(parameter),
                                interval.empty() ? "" : fmt::format(" (95 % interval {})", interval)));
  }
  return parts.empty() ? fmt::format("{} (no parameter)", fit.family->name)
                       : fmt::format("{} with {}", fit.family->name, listed(parts));
}

/// Families that converged and whose AIC lies above the best's by more than one bound and at most the other.
std::vector<std::string> families_within(const FittedDatum& datum, double above, double most) {
  std::vector<std::string> names;
  for (std::size_t i = 1; i < datum.fits.size(); ++i) {
    const double worse = datum.fits[i].aic() - datum.fits.front().aic();
    if (datum.fits[i].converged && worse > above && worse <= most)
      names.emplace_back(datum.fits[i].family->name);
  }
  return names;
}

std::vector<std::string> unconverged(const FittedDatum& datum) {
  std::vector<std::string> names;
  for (const FamilyFit& fit : datum.fits)
    if (!fit.converged && !std::isnan(fit.log_likelihood)) names.emplace_back(fit.family->name);
  return names;
}

std::string best_sentence(const FittedDatum& datum) {
  const auto is_fitted = [](const FamilyFit& fit) { return !std::isnan(fit.aic()); };
  const auto fitted = std::ranges::count_if(datum.fits, is_fitted);
  return fmt::format("Of {} {} of models that {} fitted the best, by AIC, is {}.", fitted,
                     fitted == 1 ? "family" : "families", fitted == 1 ? "was" : "were",
                     described(datum.fits.front()));
}

std::string rivals_sentence(const FittedDatum& datum) {
  const auto rivals = families_within(datum, -1, as_good), behind = families_within(datum, as_good, is_out),
             out = families_within(datum, is_out, INFINITY);
  std::string text;
  if (!rivals.empty())
    text += fmt::format("These data cannot tell it from {}, whose AIC is within {:g} of its. ",
                        listed(rivals), as_good);
  if (!behind.empty()) text += fmt::format("Behind, but not out: {}. ", listed(behind));
  if (!out.empty())
    text += fmt::format("Out, with an AIC worse by more than {:g}: {}. ", is_out, listed(out));
  if (const auto open = unconverged(datum); !open.empty())
    text += fmt::format("Not judged, for their fits did not converge: {}. ", listed(open));
  if (!text.empty()) text.pop_back();
  return text;
}

std::string goodness_sentence(const FittedDatum& datum) {
  const FamilyFit& best = datum.fits.front();
  const double p = best.goodness.p_value;
  if (std::isnan(p)) return "How well the best fits by itself was not tested.";
  const std::string by =
      best.goodness.trees > 0 ? fmt::format("by {} of its trees", best.goodness.trees) : "by chi-square";
  if (p < level)
    return fmt::format("But of the trees of {} few are as far from it as this one (p = {:.2g}, {}): {}.",
                       best.family->name, p, by,
                       p < rejected ? "none of these families describes it"
                                    : "that any of these families describes it is in doubt");
  return fmt::format("As trees of {} go, this is an ordinary one in what was fitted (p = {:.2g}, {}).",
                     best.family->name, p, by);
}

std::string departure_sentence(const Findings& findings) {
  std::vector<ComparedStatistic> off;
  std::ranges::copy_if(findings.compared, std::back_inserter(off),
                       [](const ComparedStatistic& of) { return of.adjusted_p < level; });
  if (off.empty())
    return fmt::format("In none of {} does it depart from trees of {} (5 % level, Holm).",
                       counted(findings.compared.size(), "statistic"), findings.best->text());
  std::ranges::stable_sort(off, std::ranges::greater(),
                           [](const auto& of) { return std::fabs(of.effect()); });
  std::vector<std::string> named;
  for (const ComparedStatistic& of : off)
    named.push_back(fmt::format("{} ({:.1f} standard deviations {})", of.column.name(),
                                std::fabs(of.effect()), of.effect() > 0 ? "above" : "below"));
  return fmt::format("Beside trees of {} it departs in {} (5 % level, Holm).", findings.best->text(),
                     listed(named));
}

std::string limits_sentence(const FittedDatum& datum) {
  std::string text;
  if (datum.observable == "orders")
    text =
        "What cannot be told: counts of streams fix the ratio and little more; where in a tree its forks lie "
        "only "
        "the tree itself says.";
  const std::string_view alike = datum.fits.front().family->alike;
  if (alike.empty()) return text;
  return text + fmt::format("{}{}", text.empty() ? "What cannot be told: " : " Nor of the best: ", alike) +
         ".";
}

}  // namespace

std::string listed(const std::vector<std::string>& items) {
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i)
    text += (i == 0 ? "" : i + 1 == items.size() ? " and " : ", ") + items[i];
  return text;
}

std::vector<std::string> plain_words(const Subject& subject, const Findings& findings) {
  std::vector<std::string> sentences{branching_sentence(subject)};
  if (!findings.fit || !findings.best) {
    sentences.push_back(findings.fit ? "No family could be fitted." : findings.why_no_fit);
    return sentences;
  }
  sentences.push_back(best_sentence(*findings.fit));
  sentences.push_back(rivals_sentence(*findings.fit));
  sentences.push_back(goodness_sentence(*findings.fit));
  if (!findings.compared.empty()) sentences.push_back(departure_sentence(findings));
  sentences.push_back(limits_sentence(*findings.fit));
  std::erase(sentences, "");
  return sentences;
}

}  // namespace ramify
