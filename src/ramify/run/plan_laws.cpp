#include "ramify/run/plan_laws.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

#include <nlohmann/json.hpp>

#include "ramify/core/error.hpp"
#include "ramify/large/finite_means.hpp"

namespace ramify {
namespace {

using nlohmann::json;

/// Mean and variance of every answer, NaN where there is none: how they go between processes.
using Numbers = std::vector<double>;

/// A model of the plan with its questions.
struct Enquiry {
  const Model* model;
  std::vector<Size> sizes;  ///< of its cells
  const std::vector<LawQuestion>* questions;
  LawAnswers* answers;
  double seconds;
};

/// Those that take longest first, so that none is begun last.
std::vector<Enquiry> enquiries(const Plan& plan, const PlanQuestions& questions, PlanLaws& laws) {
  std::vector<Enquiry> all;
  for (const auto& [name, asked] : questions) {
    Enquiry enquiry{nullptr, {}, &asked, &laws[name], 0};
    for (const Cell& cell : plan.cells) {
      if (cell.model.text() != name) continue;
      enquiry.model = &cell.model;
      enquiry.sizes.push_back(cell.n);
    }
    enquiry.seconds = FiniteMeans::cost(*enquiry.model, enquiry.sizes, plan.statistics).seconds;
    all.push_back(std::move(enquiry));
  }
  std::ranges::stable_sort(all, std::ranges::greater(), &Enquiry::seconds);
  return all;
}

Numbers numbers_of(const Enquiry& enquiry, const Cancellation& cancellation) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const FiniteMeans laws(*enquiry.model, enquiry.sizes);
  Numbers numbers;
  for (const auto& [column, n] : *enquiry.questions) {
    if (cancellation.requested()) throw Interrupted();
    const Moments moments = laws.moments(column, n).value_or(Moments{none, none});
    numbers.insert(numbers.end(), {moments.mean, moments.variance});
  }
  return numbers;
}

void keep(const Numbers& numbers, const Enquiry& enquiry) {
  for (std::size_t q = 0; q < enquiry.questions->size(); ++q)
    enquiry.answers->add((*enquiry.questions)[q], {numbers.at(2 * q), numbers.at(2 * q + 1)});
}

}  // namespace

std::optional<Moments> LawAnswers::moments(const StatisticColumn& column, Size n) const {
  const auto found = answers_.find(key(column, n));
  return found == answers_.end() ? std::nullopt : std::optional(found->second);
}

void LawAnswers::add(const LawQuestion& question, const Moments& answer) {
  if (answer.mean == answer.mean) answers_.insert_or_assign(key(question.column, question.n), answer);
}

LawAnswers::Key LawAnswers::key(const StatisticColumn& column, Size n) {
  return {column.statistic, column.place.high, column.place.low, n};
}

PlanLaws ask_laws(const Plan& plan, const PlanQuestions& questions, const Workforce& workforce,
                  const Cancellation& cancellation) {
  PlanLaws laws;
  const std::vector<Enquiry> all = enquiries(plan, questions, laws);
  const auto numbers = [&](std::size_t item) { return numbers_of(all[item], cancellation); };
  SharedWork work;
  work.identity = "laws of " + identity_of(plan);
  for (std::size_t item = 0; item < all.size(); ++item) work.items.push_back(item);
  work.keep = [&](std::size_t item, unsigned) { keep(numbers(item), all[item]); };
  work.send = [&](std::size_t item, unsigned) { return json::to_cbor(numbers(item)); };
  work.take = [&](std::size_t item, const Bytes& outcome) {
    keep(json::from_cbor(outcome).get<Numbers>(), all[item]);
  };
  share(work, workforce, cancellation);
  return laws;
}

}  // namespace ramify
