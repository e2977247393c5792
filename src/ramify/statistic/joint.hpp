#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "ramify/tree/grammar.hpp"
#include "ramify/tree/tally.hpp"

namespace ramify {

/// The values of several folds at one node. std::tuple would do, were it trivially copyable.
template <class First, class... Rest>
struct ValuePack {
  First first;
  ValuePack<Rest...> rest;
  friend auto operator<=>(const ValuePack&, const ValuePack&) = default;
};
template <class First>
struct ValuePack<First> {
  First first;
  friend auto operator<=>(const ValuePack&, const ValuePack&) = default;
};

template <std::size_t I, class... Values>
auto get(const ValuePack<Values...>& pack) {
  if constexpr (I == 0) {
    return pack.first;
  } else {
    return get<I - 1>(pack.rest);
  }
}

/// The tallies of several folds; NoTally for those that have none.
template <class... Tallies>
struct TallyPack {
  std::tuple<Tallies...> parts;

  TallyPack& operator+=(const TallyPack& other) {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      ((std::get<I>(parts) += std::get<I>(other.parts)), ...);
    }(std::index_sequence_for<Tallies...>{});
    return *this;
  }
  friend auto operator<=>(const TallyPack&, const TallyPack&) = default;
};

/// The values of two children, side by side in memory.
template <class Value>
struct TwoValues {
  const Value* left;
  const Value& operator[](std::size_t i) const { return left[i]; }
};

/// Several folds in one pass over one tree: values, joins and tallies side by side. List folds with larger
/// values first: the pack of values is then the smallest.
template <class... Folds>
class Joint {
 public:
  using Value = ValuePack<typename Folds::Value...>;

  Joint() = default;
  explicit Joint(Folds... folds) : folds_(std::move(folds)...) {}

  Value external() {
    return std::apply([](auto&... fold) { return pack(fold.external()...); }, folds_);
  }

  template <class Label, class Labels, class Values>
  [[gnu::always_inline]] Value join(const Label& label, const Labels& labels, const Values& values) {
    return join_each(label, labels, values, std::index_sequence_for<Folds...>{});
  }

  using Tally = TallyPack<TallyOf<Folds>...>;
  static constexpr Size largest_tallied = std::min({ramify::largest_tallied<Folds>()...});

  Tally take_tally() {
    return std::apply([](auto&... fold) { return Tally{std::tuple(ramify::take_tally(fold)...)}; }, folds_);
  }

  void add_tally(Size n, const Tally& tally) {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      (ramify::add_tally(std::get<I>(folds_), n, std::get<I>(tally.parts)), ...);
    }(std::index_sequence_for<Folds...>{});
  }

  template <class F>
  const F& get() const {
    return std::get<F>(folds_);
  }

 private:
  template <std::size_t I>
  using FoldValue = typename std::tuple_element_t<I, std::tuple<Folds...>>::Value;

  template <class First, class... Rest>
  static ValuePack<First, Rest...> pack(First first, Rest... rest) {
    if constexpr (sizeof...(Rest) == 0) {
      return {first};
    } else {
      return {first, pack(rest...)};
    }
  }

  template <class Label, class Labels, class Values, std::size_t... I>
  [[gnu::always_inline]] Value join_each(const Label& label, const Labels& labels, const Values& values,
                                         std::index_sequence<I...>) {
    return pack(std::get<I>(folds_).join(label, labels, column<I>(values))...);
  }

  // The I-th fold's values, as an array for two children and a vector for any other number.
  template <std::size_t I, class Two>
  static auto column(const Two& values) {
    return Pair<FoldValue<I>>{ramify::get<I>(values[0]), ramify::get<I>(values[1])};
  }

  template <std::size_t I>
  static auto column(std::span<const Value> values) {
    std::vector<FoldValue<I>> column;
    column.reserve(values.size());
    for (const Value& value : values) column.push_back(ramify::get<I>(value));
    return column;
  }

  std::tuple<Folds...> folds_;
};

}  // namespace ramify
