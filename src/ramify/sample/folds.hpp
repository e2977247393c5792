#pragma once

#include <concepts>
#include <numeric>
#include <optional>
#include <type_traits>
#include <utility>

#include "ramify/law/choice_path.hpp"
#include "ramify/random/stream.hpp"
#include "ramify/sample/mean_counts.hpp"
#include "ramify/statistic/balance.hpp"
#include "ramify/statistic/bi_orders.hpp"
#include "ramify/statistic/external_depth.hpp"
#include "ramify/statistic/fill_level.hpp"
#include "ramify/statistic/height.hpp"
#include "ramify/statistic/horton_strahler.hpp"
#include "ramify/statistic/joint.hpp"
#include "ramify/statistic/last_node_depth.hpp"
#include "ramify/statistic/level_profile.hpp"
#include "ramify/statistic/shape_indices.hpp"
#include "ramify/statistic/stacked.hpp"
#include "ramify/statistic/strahler.hpp"
#include "ramify/statistic/toll_sums.hpp"
#include "ramify/statistic/tree_measures.hpp"

namespace ramify {

// Larger values first: the first pack is 8 bytes, the second 12.
using OrdersAndHeight = Joint<Height, HortonStrahler>;
template <class Walk>
using OrdersAndPathsOf = Joint<LastNodeDepthOf<Walk>, Height, HortonStrahler, FillLevel, Balance>;
using OrdersAndPaths = OrdersAndPathsOf<RandomWalk>;
template <class BalanceFold, class... More>
using AllFoldOf = Joint<ExternalDepth, ShapeIndices, LastNodeDepth, Height, LevelProfile, BiOrders, FillLevel,
                        BalanceFold, More...>;
template <class BalanceFold, class... Indices>
AllFoldOf<BalanceFold, TollSums, Indices...> with_indices(IndexList<Indices...>);

using AllFold = AllFoldOf<Balance>;
using IndexedFold = decltype(with_indices<Balance>(IndexFolds()));
// Of a stored tree of any arity.
using MeasuredFold = AllFoldOf<BalanceByLeaves>;
using MeasuredIndexedFold = decltype(with_indices<BalanceByLeaves>(IndexFolds()));

/// A joint fold on a stack of its own: whole trees have too many outcomes to be tabulated.
template <class F>
concept KeepsStack = requires { typename F::Pack; };
template <class F>
inline constexpr bool is_grafted = !KeepsStack<F>;

/// The fold of one tree; a walk gets its choices from `walk`.
template <class F, class Walk>
F make_fold(Walk walk) {
  if constexpr (std::is_same_v<F, OrdersAndPathsOf<Walk>>) {
    return F(LastNodeDepthOf<Walk>(walk), Height(), HortonStrahler(), FillLevel(), Balance());
  } else if constexpr (std::is_same_v<F, LastNodeDepthOf<Walk>>) {
    return F(walk);
  } else {
    return F();
  }
}

template <class BalanceFold, class... More>
void make_all(StreamKey key, std::uint64_t replicate, std::optional<AllFoldOf<BalanceFold, More...>>& made) {
  const RandomWalk walk(Stream(key, replicate, Lane::walk));
  const RandomWalk to_external(Stream(key, replicate, Lane::external_walk));
  made.emplace(ExternalDepth(to_external), ShapeIndices(), LastNodeDepth(walk), Height(), LevelProfile(),
               BiOrders(), FillLevel(), BalanceFold(), More()...);
}

/// The fold of the tree (key, replicate), with walks of their own streams.
template <class F>
F make_fold(StreamKey key, std::uint64_t replicate) {
  if constexpr (KeepsStack<F>) {
    return F(make_fold<typename F::Folds>(key, replicate));
  } else if constexpr (requires(std::optional<F>& made) { make_all(key, replicate, made); }) {
    std::optional<F> made;
    make_all(key, replicate, made);
    return std::move(*made);
  } else {
    return make_fold<F>(RandomWalk(Stream(key, replicate, Lane::walk)));
  }
}

inline void record(const Strahler&, Strahler::Value root, TreeMeasures& measures) {
  measures.strahler = root;
}
inline void record(const Height&, Height::Value root, TreeMeasures& measures) {
  measures.height = root;
}
inline void record(const FillLevel&, FillLevel::Value root, TreeMeasures& measures) {
  measures.fill_level = root;
}
inline void record(const Balance&, Balance::Value root, TreeMeasures& measures) {
  measures.balance = root;
}
inline void record(const BalanceByLeaves&, BalanceByLeaves::Value root, TreeMeasures& measures) {
  measures.balance = root.balance;
}
inline void record(const ExternalDepth&, ExternalDepth::Value root, TreeMeasures& measures) {
  measures.external_depth = root.depth;
}
inline void record(const ShapeIndices& indices, ShapeIndices::Value, TreeMeasures& measures) {
  measures.path_length = indices.path_length();
  measures.sackin = indices.sackin();
  measures.colless = indices.colless();
  measures.is_wide = indices.is_wide();
}
inline void record(const LevelProfile& profile, LevelProfile::Value root, TreeMeasures& measures) {
  measures.width = profile.width(root);
}
inline void record(const TollSums& tolls, TollSums::Value, TreeMeasures& measures) {
  measures.toll_sums = tolls.sums();
}
template <class Index>
  requires(IndexFolds::holds<Index>)
void record(const Index& fold, const typename Index::Value& root, TreeMeasures& measures) {
  measures.indices[IndexFolds::place_of<Index>] = fold.index(root);
}
template <class Walk>
void record(const LastNodeDepthOf<Walk>&, std::uint32_t root, TreeMeasures& measures) {
  measures.depth = root;
}
template <class Orders>
  requires std::same_as<Orders, HortonStrahler> || std::same_as<Orders, MeanCounts> ||
           std::same_as<Orders, BiOrders>
void record(const Orders& orders, HortonStrahler::Value root, TreeMeasures& measures) {
  measures.strahler = root;
  measures.nodes = orders.nodes();
  measures.streams = orders.streams();
  // Every node is counted once, and the external ones are the streams of order 0.
  measures.size =
      std::accumulate(measures.nodes.begin(), measures.nodes.end(), Size{0}) - measures.streams[0];
  if constexpr (std::same_as<Orders, BiOrders>) measures.bi_orders = orders.counts();
}
template <class... Folds>
void record(const Joint<Folds...>& joint, const typename Joint<Folds...>::Value& root,
            TreeMeasures& measures) {
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (record(joint.template get<Folds>(), get<I>(root), measures), ...);
  }(std::index_sequence_for<Folds...>{});
}

template <class J>
void record(const Stacked<J>& stacked, const typename Stacked<J>::Value&, TreeMeasures& measures) {
  record(stacked.fold(), stacked.root(), measures);
}

}  // namespace ramify
