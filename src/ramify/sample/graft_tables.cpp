#include "ramify/sample/graft_tables.hpp"

#include "ramify/law/build_law.hpp"
#include "ramify/law/statistic_law.hpp"

namespace ramify {
namespace {

/// A fold whose whole law has a recurrence.
template <class F>
concept HasLaw = std::same_as<decltype(F::recurrence), const BoundedJoin> ||
                 std::same_as<decltype(F::recurrence), const LongestPath>;

template <class F>
OutcomesOf<F> outcomes(const FiniteLaw& law) {
  OutcomesOf<F> possible;
  auto value = static_cast<typename F::Value>(law.first);
  for (const double probability : law.probabilities) {
    if (probability > 0) possible.push_back({value, {}, probability});
    ++value;
  }
  return possible;
}

template <HasLaw F>
GraftTableOf<F> tabulate(const Model& model, Size largest, const Cancellation& cancellation) {
  const auto law = build_law(model, largest, StatisticLaw(F::recurrence, largest), cancellation);
  GraftTableOf<F> table;
  for (Size n = 0; n <= largest; ++n) table.append(outcomes<F>(*law.law(n)));
  return table;
}

template <std::same_as<MeanCounts> F>
GraftTableOf<F> tabulate(const Model& model, Size largest, const Cancellation& cancellation) {
  return MeanCountsTable(model, largest, cancellation);
}

template <class F>
GraftTableOf<F> tabulate(const Model& model, Size largest, const Cancellation& cancellation) {
  GraftTableOf<F> table;
  const auto make = [](ChoicePath& path) {
    using Enumerated =
        std::conditional_t<std::is_same_v<F, OrdersAndPaths>, OrdersAndPathsOf<EnumeratedWalk>, F>;
    return make_fold<Enumerated>(EnumeratedWalk(path));
  };
  for (const auto& law : outcome_laws(model, largest, make, cancellation)) table.append(law);
  return table;
}

}  // namespace

template <class F>
std::shared_ptr<const GraftTableOf<F>> make_graft_table(const Model& model, Size largest,
                                                        const Cancellation& cancellation) {
  return std::make_shared<const GraftTableOf<F>>(tabulate<F>(model, largest, cancellation));
}

template std::shared_ptr<const GraftTableOf<Strahler>> make_graft_table<Strahler>(const Model&, Size,
                                                                                  const Cancellation&);
template std::shared_ptr<const GraftTableOf<Height>> make_graft_table<Height>(const Model&, Size,
                                                                              const Cancellation&);
template std::shared_ptr<const GraftTableOf<FillLevel>> make_graft_table<FillLevel>(const Model&, Size,
                                                                                    const Cancellation&);
template std::shared_ptr<const GraftTableOf<Balance>> make_graft_table<Balance>(const Model&, Size,
                                                                                const Cancellation&);
template std::shared_ptr<const GraftTableOf<MeanCounts>> make_graft_table<MeanCounts>(const Model&, Size,
                                                                                      const Cancellation&);
template std::shared_ptr<const GraftTableOf<OrdersAndHeight>> make_graft_table<OrdersAndHeight>(
    const Model&, Size, const Cancellation&);
template std::shared_ptr<const GraftTableOf<OrdersAndPaths>> make_graft_table<OrdersAndPaths>(
    const Model&, Size, const Cancellation&);

}  // namespace ramify
