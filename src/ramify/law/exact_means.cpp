#include "ramify/law/exact_means.hpp"

#include <algorithm>
#include <concepts>
#include <limits>

#include "ramify/core/number.hpp"
#include "ramify/law/law_limit.hpp"

namespace ramify {
namespace {

/// k of "nodes_k"; nothing where the column is no such thing.
std::optional<Size> order_of(std::string_view column, std::string_view prefix) {
  if (!column.starts_with(prefix)) return std::nullopt;
  return parse_count(column.substr(prefix.size()));
}

/// The law of size n, of the value plus `more`.
template <class Law>
FiniteLaw finite(const Law& law, Size n, double more = 0) {
  return {static_cast<double>(law.lowest(n)) + more, law.pmf(n)};
}

Moments one_more(const Moments& moments) {
  return {moments.mean + 1, moments.variance};
}

}  // namespace

ExactMeans::ExactMeans(const Model& model, Size largest_n)
    : largest_n_(std::min(largest_n, law_limit(model))),
      largest_n_with_variances_(std::min(largest_n, order_moments_limit(model))),
      rows_(model) {}

/// The law with every size up to n.
template <class Law>
const Law& ExactMeans::extended(Law& law, Size n) const {
  while (law.sizes() <= n) law.extend(rows_.row(law.sizes()));
  return law;
}

template <class Law, class... Of>
const Law& ExactMeans::known(std::optional<Law>& law, Size n, Of... of) const {
  if (!law) {
    if constexpr (sizeof...(Of) == 0 && std::constructible_from<Law, Size>)
      law.emplace(largest_n_);
    else
      law.emplace(of...);
  }
  return extended(*law, n);
}

Moments ExactMeans::of_count(Size n, OrderCount count) const {
  const double mean = known(orders_, n).mean(n, count);
  if (n > largest_n_with_variances_) return {mean, std::numeric_limits<double>::quiet_NaN()};
  if (!order_moments_)
    order_moments_.emplace(known(orders_, largest_n_with_variances_), largest_n_with_variances_);
  return {mean, extended(*order_moments_, n).variance(n, count)};
}

std::optional<Moments> ExactMeans::moments(std::string_view column, Size n) const {
  if (n > largest_n_) return std::nullopt;
  if (column == "size") return Moments{static_cast<double>(n), 0};
  if (column == "magnitude") return Moments{static_cast<double>(n + 1), 0};
  if (column == "strahler") return known(strahler_, n).moments(n);
  if (column == "registers") return one_more(known(strahler_, n).moments(n));
  if (column == "height") return known(height_, n).moments(n);
  if (column == "depth") return known(depth_, n).moments(n);
  if (column == "external_depth") return known(external_depth_, n, DepthLaw::Of::external_node).moments(n);
  if (column == "path_length") return known(path_length_, n, NodeSumLaw::Of::path_length).moments(n);
  if (column == "sackin") return known(sackin_, n, NodeSumLaw::Of::sackin).moments(n);
  if (column == "colless") return known(colless_, n, NodeSumLaw::Of::colless).moments(n);
  if (column == "cherries") return of_count(n, {OrderCount::Of::streams, 1});
  if (column == "fill_level") return known(fill_level_, n).moments(n);
  if (column == "balance") return known(balance_, n).moments(n);
  if (column == "alternate_balance") return one_more(known(balance_, n).moments(n));
  if (const auto k = order_of(column, "nodes_")) return of_count(n, {OrderCount::Of::nodes, *k});
  if (const auto k = order_of(column, "streams_")) return of_count(n, {OrderCount::Of::streams, *k});
  return std::nullopt;
}

std::optional<FiniteLaw> ExactMeans::law(std::string_view column, Size n) const {
  if (n > largest_n_) return std::nullopt;
  if (column == "strahler") return finite(known(strahler_, n), n);
  if (column == "registers") return finite(known(strahler_, n), n, 1);
  if (column == "height") return finite(known(height_, n), n);
  if (column == "depth") return finite(known(depth_, n), n);
  if (column == "external_depth") return finite(known(external_depth_, n, DepthLaw::Of::external_node), n);
  if (column == "fill_level") return finite(known(fill_level_, n), n);
  if (column == "balance") return finite(known(balance_, n), n);
  if (column == "alternate_balance") return finite(known(balance_, n), n, 1);
  return std::nullopt;
}

}  // namespace ramify
