// Grows one tree and prints its Horton-Strahler order and its streams: what docs/design.md calls the one
// idea, from outside. The tree is measured twice, as it grows and as it is stored; the two must agree.
#include <cstdlib>
#include <iostream>

#include "ramify/core/cancellation.hpp"
#include "ramify/model/fixed_split.hpp"
#include "ramify/model/registry.hpp"
#include "ramify/model/split_tree.hpp"
#include "ramify/random/stream.hpp"
#include "ramify/sample/tree_sampler.hpp"
#include "ramify/statistic/horton_strahler.hpp"
#include "ramify/tree/measure.hpp"
#include "ramify/tree/store.hpp"

int main() {
  const ramify::Size n = 579;
  const auto model = ramify::Model::parse("split(1/4.35)");
  const ramify::StreamKey key{1996, model.stream_cell(n)};

  const ramify::Cancellation never;
  ramify::TreeMeasures grown;
  ramify::make_tree_sampler({model, ramify::whole_trees(ramify::orders_and_height), ramify::max_size, &never})
      ->sample(n, key, 0, grown);

  ramify::Stream stream(key, 0);
  const ramify::SplitTree<ramify::FixedSplit> grammar(ramify::FixedSplit(1 / 4.35));
  const ramify::Tree tree = ramify::grow_tree(grammar, n, stream);
  ramify::HortonStrahler orders;
  if (ramify::measure(tree, orders) != grown.strahler || orders.streams() != grown.streams) {
    std::cerr << "the stored tree and the grown one differ\n";
    return EXIT_FAILURE;
  }

  std::cout << model.text() << ", n = " << n << ": order " << grown.strahler << ", streams";
  for (std::size_t k = 0; k <= grown.strahler; ++k) std::cout << ' ' << grown.streams[k];
  std::cout << '\n';
}
