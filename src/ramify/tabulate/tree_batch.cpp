#include "ramify/tabulate/tree_batch.hpp"

#include <vector>

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/core/parallel.hpp"
#include "ramify/format/write_trees.hpp"
#include "ramify/model/split_tree.hpp"
#include "ramify/random/stream.hpp"
#include "ramify/sample/grow_blocks.hpp"
#include "ramify/tree/store.hpp"

namespace ramify {
namespace {

/// Of a block: so that a few trees keep all threads busy.
constexpr std::uint64_t most_trees = 16;

Row row_of(const TreeBatch& batch, std::uint64_t replicate, const std::vector<StatisticColumn>& columns,
           const std::vector<StatisticValue>& values) {
  Row row;
  row.text(batch.model.text()).whole(batch.n).whole(batch.seed).whole(replicate);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].statistic->real)
      row.summary(values[i].real);
    else
      row.whole(values[i].whole);
  }
  return row;
}

}  // namespace

Table TreeBatch::table(const StatisticSet& statistics, std::uint64_t first, std::uint64_t last,
                       const Cancellation& cancellation) const {
  const auto columns = statistics.columns(model.largest_order(n));
  std::vector<Row> rows(last - first);
  const GrowingJob job{model, n, seed, sampling_method(statistics, graft), first, last, most_trees};
  grow_blocks({job}, threads, cancellation, [&](const Block&, const BlockTrees& trees) {
    std::vector<StatisticValue> values;
    trees.each([&](std::uint64_t replicate, const TreeMeasures& measures) {
      write_statistics(columns, measures, values);
      rows[replicate - first] = row_of(*this, replicate, columns, values);
    });
  });
  std::vector<std::string> header{"model", "n", "seed", "replicate"};
  for (const auto& column : columns) header.push_back(column.name());
  Table table(std::move(header));
  for (Row& row : rows) table.add(std::move(row));
  return table;
}

std::vector<RecordedTree> TreeBatch::grown(std::uint64_t first, std::uint64_t last,
                                           const Cancellation& cancellation) const {
  const StreamKey key{seed, model.stream_cell(n)};
  std::vector<RecordedTree> trees(last - first);
  const auto grow_each = [&](auto grow) {
    parallel_for(trees.size(), threads, [&](std::size_t item, unsigned) {
      if (cancellation.requested()) throw Interrupted();
      Stream stream(key, first + item);
      trees[item].tree = grow(stream);
      trees[item].name =
          fmt::format("{}, n = {}, seed {}, replicate {}", model.text(), n, seed, first + item);
    });
  };
  if (model.is_split()) {
    std::visit(
        [&]<class Law>(const Law& law) {
          const SplitTree<Law> grammar(law);
          grow_each([&](Stream& stream) { return grow_tree(grammar, n, stream); });
        },
        model.law());
  } else {
    grow_each([&](Stream& stream) { return model.grown().grow(n, stream, cancellation); });
  }
  return trees;
}

std::string TreeBatch::trees(TreeFormat format, std::uint64_t first, std::uint64_t last,
                             const Cancellation& cancellation) const {
  return write_trees(grown(first, last, cancellation), format);
}

}  // namespace ramify
