#include "ramify/sample/graft_tables.hpp"

#include "ramify/law/balance_law.hpp"
#include "ramify/law/build_law.hpp"
#include "ramify/law/conditional_order_means.hpp"
#include "ramify/law/fill_level_law.hpp"
#include "ramify/law/height_law.hpp"
#include "ramify/law/strahler_law.hpp"

namespace ramify {
namespace {

/// The law of the statistic that a fold computes.
template <class F>
struct LawOf;
template <>
struct LawOf<Strahler> {
  using type = StrahlerLaw;
};
template <>
struct LawOf<FillLevel> {
  using type = FillLevelLaw;
};
template <>
struct LawOf<Balance> {
  using type = BalanceLaw;
};
template <>
struct LawOf<Height> {
  using type = HeightLaw;
};

template <class F>
concept HasLaw = requires { typename LawOf<F>::type; };

template <class F, class Law>
OutcomesOf<F> outcomes(const Law& law, Size n) {
  OutcomesOf<F> possible;
  const auto pmf = law.pmf(n);
  for (std::size_t i = 0; i < pmf.size(); ++i)
    if (pmf[i] > 0) possible.push_back({static_cast<typename F::Value>(law.lowest(n) + i), {}, pmf[i]});
  return possible;
}

template <HasLaw F>
GraftTableOf<F> tabulate(const Model& model, Size largest, const Cancellation& cancellation) {
  using Law = typename LawOf<F>::type;
  const auto law = build_law(model, largest, empty_law<Law>(largest), cancellation);
  GraftTableOf<F> table;
  for (Size n = 0; n <= largest; ++n) table.append(outcomes<F>(law, n));
  return table;
}

MeanCounts::Tally mean_tally(const ConditionalOrderMeans& law, Size n, std::size_t order) {
  std::vector<double> nodes, streams;
  for (std::size_t k = 1; k <= order; ++k) {
    nodes.push_back(law.mean(n, {OrderCount::Of::nodes, k}, order));
    streams.push_back(law.mean(n, {OrderCount::Of::streams, k}, order));
  }
  return MeanCounts::Tally::of(nodes, streams);
}

template <std::same_as<MeanCounts> F>
GraftTableOf<F> tabulate(const Model& model, Size largest, const Cancellation& cancellation) {
  const auto means = build_law(model, largest, OrderMeans(largest), cancellation);
  const auto given_order = build_law(model, largest, ConditionalOrderMeans(means, largest), cancellation);
  GraftTableOf<F> table;
  for (Size n = 0; n <= largest; ++n) {
    OutcomesOf<F> possible;
    for (const auto& order : outcomes<Strahler>(means.strahler(), n))
      possible.push_back({order.value, mean_tally(given_order, n, order.value), order.probability});
    table.append(std::move(possible));
  }
  return table;
}

template <class F>
GraftTableOf<F> tabulate(const Model& model, Size largest, const Cancellation& cancellation) {
  GraftTableOf<F> table;
  const auto make = [](ChoicePath& path) {
    using Enumerated = std::conditional_t<std::is_same_v<F, FullFold>, FullFoldOf<EnumeratedWalk>, F>;
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
template std::shared_ptr<const GraftTableOf<LeanFold>> make_graft_table<LeanFold>(const Model&, Size,
                                                                                  const Cancellation&);
template std::shared_ptr<const GraftTableOf<FullFold>> make_graft_table<FullFold>(const Model&, Size,
                                                                                  const Cancellation&);

}  // namespace ramify
