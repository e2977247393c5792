#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "ramify/core/cancellation.hpp"
#include "ramify/core/workforce.hpp"
#include "ramify/law/moments.hpp"
#include "ramify/run/plan.hpp"

namespace ramify {

/// What is asked of the laws of a model: the moments of a column at a size.
struct LawQuestion {
  StatisticColumn column;
  Size n;
};

/// What the laws of a model (large/finite_means.hpp) answered.
class LawAnswers {
 public:
  /// Nothing where no law is in reach, or where it was not asked.
  std::optional<Moments> moments(const StatisticColumn& column, Size n) const;

  void add(const LawQuestion& question, const Moments& answer);

 private:
  using Key = std::tuple<const StatisticInfo*, std::size_t, std::size_t, Size>;
  static Key key(const StatisticColumn& column, Size n);

  std::map<Key, Moments> answers_;
};

/// By model, all of them split models.
using PlanQuestions = std::map<std::string, std::vector<LawQuestion>>;
using PlanLaws = std::map<std::string, LawAnswers>;

/// The laws of one model are computed once, by one thread of any process of the workforce: what takes longest
/// first; the answers do not depend on who gives them. A process that only helps has none of them. Throws
/// Interrupted when cancelled, which is looked at before each question.
PlanLaws ask_laws(const Plan& plan, const PlanQuestions& questions, const Workforce& workforce,
                  const Cancellation& cancellation);

}  // namespace ramify
