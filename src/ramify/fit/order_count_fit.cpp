#include "ramify/fit/order_count_fit.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include <boost/math/special_functions/gamma.hpp>
#include <fmt/format.h>

#include "ramify/family/jet_likelihood.hpp"
#include "ramify/fit/note.hpp"
#include "ramify/measure/tree_measurement.hpp"
#include "ramify/model/ramification.hpp"

namespace ramify {
namespace {

constexpr std::size_t enough_orders = 6;  // docs/validation.md

/// What is new at the orders, from the highest down, whitened: row by row of Cholesky's factor of its
/// covariances.
template <class T>
class NewStreams {
 public:
  NewStreams(const ObservedCounts& counts, const T& a, const T& c) : counts_(&counts), sides_{a} {
    while (sides_.size() < counts.top()) sides_.push_back(sides_.back() * c);
    for (std::size_t k = counts.top(); k-- > 0;) add_order(k);
  }

  /// -log of the density of order k given those above, without its constant.
  T minus_log_density(std::size_t k) const {
    using std::log;
    return log(factor_[place(k)].back()) + misfit(k) / 2.0;
  }
  T misfit(std::size_t k) const { return whitened_[place(k)] * whitened_[place(k)]; }

 private:
  std::size_t place(std::size_t k) const { return counts_->top() - 1 - k; }
  double streams(std::size_t k) const { return static_cast<double>(counts_->streams[k]); }
  const T& side(std::size_t difference) const { return sides_[difference - 1]; }

  T covariance(std::size_t k, std::size_t above) const {
    T sum(k == above ? rounding_variance : 0.0);
    for (std::size_t j = above + 1; j <= counts_->top(); ++j)
      sum += streams(j) * side(j - k) * (side(j - above) + (k == above ? 1.0 : 0.0));
    return sum;
  }

  void add_order(std::size_t k) {
    using std::sqrt;
    std::vector<T> row;
    T rest(streams(k) - 2 * streams(k + 1));
    for (std::size_t j = k + 1; j <= counts_->top(); ++j) rest -= side(j - k) * streams(j);
    for (std::size_t above = counts_->top(); above-- > k;) {
      T left = covariance(k, above);
      const std::size_t column = row.size();
      for (std::size_t i = 0; i < column; ++i) left -= row[i] * (above == k ? row[i] : factor_[column][i]);
      if (above > k) {
        row.push_back(left / factor_[column].back());
        rest -= row.back() * whitened_[column];
      } else {
        row.push_back(sqrt(left));
      }
    }
    whitened_.push_back(rest / row.back());
    factor_.push_back(std::move(row));
  }

  const ObservedCounts* counts_;
  std::vector<T> sides_;  ///< T_1, T_2, ...
  std::vector<std::vector<T>> factor_;
  std::vector<T> whitened_;
};

/// @param ratio_and_share  R and x
template <class T>
NewStreams<T> new_streams(const ObservedCounts& counts, const std::array<T, 2>& ratio_and_share) {
  const auto& [ratio, share] = ratio_and_share;
  return {counts, (ratio - 2.0) * (1.0 - share), share * ratio};
}

double misfit_of(const ObservedCounts& counts, std::span<const double> values) {
  const auto found = new_streams<double>(counts, {values[0], values[1]});
  double sum = 0;
  for (std::size_t k = 0; k < orders_given_above(counts); ++k) sum += found.misfit(k);
  return sum;
}

}  // namespace

const Family& tokunaga_by_ratio() {
  using Kind = SearchScale::Kind;
  static const Family family{
      .name = "tokunaga",
      .model = &tokunaga_info(),
      .fixed = {},
      .parameters = {{"horton_ratio", {Kind::log_above, 2, 0}, 2.01, 100, {2.5, 4, 8}},
                     {"c/R", {Kind::logit, 0, 1}, 0.005, 0.995, {0.1, 0.5, 0.9}}},
      .mirror = Mirror::none,
      .alike = "of R, the horton_ratio, and x = c/R: a = (R-2)(1-x), c = x R; counts fix R and hardly x",
      .given = Given::order};
  return family;
}

std::vector<double> tokunaga_of_ratio(std::span<const double> ratio_and_share) {
  const double ratio = ratio_and_share[0], share = ratio_and_share[1];
  return {(ratio - 2) * (1 - share), share * ratio};
}

std::size_t orders_given_above(const ObservedCounts& counts) {
  std::size_t orders = 0;
  while (orders < counts.top() && counts.streams[orders + 1] >= ObservedCounts::enough) ++orders;
  return orders;
}

Objective order_count_objective(const ObservedCounts& counts) {
  const auto formula = [counts](const auto& values) {
    const auto found = new_streams(counts, values);
    auto minus_log = 0.0 * values[0];
    for (std::size_t k = 0; k < orders_given_above(counts); ++k)
      minus_log += found.minus_log_density(k) + std::log(2 * std::numbers::pi) / 2;
    return minus_log;
  };
  SearchBox box = search_box(tokunaga_by_ratio());
  return {jet_likelihood<2>(tokunaga_by_ratio(), formula), std::move(box.low), std::move(box.high)};
}

FamilyFit fit_counts_given_order(const ObservedCounts& counts) {
  const Family& family = tokunaga_by_ratio();
  const auto n = static_cast<double>(counts.n());
  const std::size_t used = orders_given_above(counts);
  if (used < family.parameters.size()) {
    FamilyFit none = without_fit(family, n);
    none.note = fmt::format("{} orders have an order above of {} streams or more; {} are needed", used,
                            ObservedCounts::enough, family.parameters.size());
    return none;
  }
  FamilyFit fit = fit_family(family, order_count_objective(counts), n);
  if (!fit.converged) return fit;
  if (used < enough_orders)
    add_note(fit.note,
             fmt::format("fewer than {} orders: R is too large by some half of its error, and its interval "
                         "holds it nine times of ten",
                         enough_orders));
  const double degrees = static_cast<double>(used) - static_cast<double>(family.parameters.size());
  const double misfit = misfit_of(counts, fit.estimates());
  fit.goodness = {misfit, degrees > 0 ? boost::math::gamma_q(degrees / 2, misfit / 2) : std::nan(""), 0,
                  degrees};
  return fit;
}

void bootstrap_counts_given_order(FamilyFit& fit, const ObservedCounts& counts, const BootstrapPlan& plan,
                                  const Workforce& workforce, const Cancellation& cancellation) {
  const Model model = Model::make(*fit.family->model, tokunaga_of_ratio(fit.estimates()));
  const Size order = counts.top();
  model.require_size(order);
  const Point at = fit.family->searched(fit.estimates());
  Refits refits =
      refitted_trees(model, {&order, 1}, static_cast<double>(counts.n()), plan, workforce, cancellation,
                     [&](std::span<const RecordedTree* const> trees) -> std::vector<double> {
                       const ObservedCounts grown{measure_orders(*trees[0]).streams};
                       if (orders_given_above(grown) < fit.parameters.size()) return {};
                       const std::vector<double> values =
                           fit.family->values(best_place(*fit.family, order_count_objective(grown), at));
                       return with_misfit(values, misfit_of(grown, values));
                     });
  const std::vector<double> misfits = take_misfits(refits, plan, fit);
  if (misfits.empty()) return;
  summarise_bootstrap(refits, fit);
  fit.goodness.p_value = bootstrap_p_value(misfits, plan.seed);
}

}  // namespace ramify
