#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "support/sanitized.hpp"

#include "ramify/core/cancellation.hpp"
#include "ramify/model/registry.hpp"
#include "ramify/model/split_tree.hpp"
#include "ramify/random/stream.hpp"
#include "ramify/statistic/balance.hpp"
#include "ramify/statistic/fill_level.hpp"
#include "ramify/statistic/height.hpp"
#include "ramify/statistic/horton_strahler.hpp"
#include "ramify/statistic/joint.hpp"
#include "ramify/statistic/last_node_depth.hpp"
#include "ramify/statistic/tree_measures.hpp"
#include "ramify/tree/grow.hpp"
#include "ramify/tree/tree.hpp"

namespace ramify::test {

/// The table sizes under test: every size from the law itself, and the default (small sizes from tables).
inline constexpr Size no_tables = 0;
inline constexpr Size default_tables = 128;

/// Every model once, with the parameters that the tests of agreement use.
const std::vector<std::string>& all_models();

/// Stored trees of a model: source(n, replicate).
using TreeSource = std::function<Tree(Size n, std::uint64_t replicate)>;
TreeSource tree_source(std::string_view model, StreamKey key, Size table_size);

/// One stored tree of any model.
Tree grown_tree(const Model& model, Size n, StreamKey key, std::uint64_t replicate);

/// How often each left size 0..n-1 came in so many draws (sanitized.hpp) of the split of a tree of size n.
std::vector<std::uint64_t> count_splits(std::string_view model, Size n, std::uint64_t draws,
                                        std::uint64_t seed, Size table_size);

/// What looks at each tree that was measured.
using Look = std::function<void(const TreeMeasures&)>;

/// Grows so many trees (sanitized.hpp) of a split law that need not be a registered model, replicates 0, 1,
/// ..., and hands over what was measured.
template <class Law>
void grow_and_measure(const Law& law, Size n, std::uint64_t trees, std::uint64_t seed, const Look& look) {
  using Everything = Joint<LastNodeDepth, Height, HortonStrahler, FillLevel, Balance>;
  const SplitTree<Law> grammar(law);
  const Cancellation never;
  const StreamKey key{seed, n};
  Grower<SplitTree<Law>, Everything, Stream> grower(never);
  for (std::uint64_t replicate = 0; replicate < replicates(trees); ++replicate) {
    Stream stream(key, replicate);
    const RandomWalk walk(Stream(key, replicate, Lane::walk));
    Everything fold{LastNodeDepth(walk), Height(), HortonStrahler(), FillLevel(), Balance()};
    const auto root = grower(grammar, n, stream, fold);
    TreeMeasures measures;
    measures.size = n;
    measures.depth = get<0>(root);
    measures.height = get<1>(root);
    measures.strahler = get<2>(root);
    measures.fill_level = get<3>(root);
    measures.balance = get<4>(root);
    measures.nodes = fold.template get<HortonStrahler>().nodes();
    measures.streams = fold.template get<HortonStrahler>().streams();
    look(measures);
  }
}

/// The same of a registered model with a split law. Here once, for the loops of all laws take long to
/// compile.
void grow_and_measure(const Model& model, Size n, std::uint64_t trees, std::uint64_t seed, const Look& look);

}  // namespace ramify::test
