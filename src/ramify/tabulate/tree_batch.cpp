#include "ramify/tabulate/tree_batch.hpp"

#include <algorithm>
#include <atomic>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/core/memory.hpp"
#include "ramify/core/parallel.hpp"
#include "ramify/format/write_trees.hpp"
#include "ramify/model/split_tree.hpp"
#include "ramify/random/stream.hpp"
#include "ramify/sample/grow_blocks.hpp"
#include "ramify/sample/open_levels.hpp"
#include "ramify/tree/store.hpp"

namespace ramify {
namespace {

/// Of a block: so that a few trees keep all threads busy.
constexpr std::uint64_t most_trees = 16;

/// Tells how many trees are done; any thread.
class Count {
 public:
  Count(const TreeBatch& batch, std::uint64_t total) : batch_(batch), total_(static_cast<double>(total)) {}

  void one_more() {
    const std::uint64_t done = ++done_;
    if (batch_.progress) batch_.progress(static_cast<double>(done), total_);
  }

 private:
  const TreeBatch& batch_;
  const double total_;
  std::atomic<std::uint64_t> done_ = 0;
};

Row row_of(const TreeBatch& batch, std::uint64_t replicate, const std::vector<StatisticColumn>& columns,
           const std::vector<StatisticValue>& values) {
  Row row;
  row.text(batch.model.text()).whole(batch.n).whole(batch.seed).whole(replicate);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (!columns[i].has(values[i]))
      row.nothing();
    else if (columns[i].statistic->real)
      row.summary(values[i].real);
    else
      row.whole(values[i].whole);
  }
  return row;
}

/// Of a node of a written tree, at the most: the tree, the text, and what the writer holds. Measured at 10^7
/// nodes.
double node_bytes(TreeFormat format) {
  switch (format) {
    case TreeFormat::parens:
      return 18;
    case TreeFormat::newick:
      return 36;
    case TreeFormat::swc:
      return 150;
    default:
      return 60;
  }
}

/// Looks for cancellation now and then while a tree is grown node by node.
class Watch {
 public:
  explicit Watch(const Cancellation& cancellation) : cancellation_(&cancellation) {}

  void operator()(Size) {
    if (++nodes_ % (1 << 20) == 0 && cancellation_->requested()) throw Interrupted();
  }

 private:
  const Cancellation* cancellation_;
  std::uint64_t nodes_ = 0;
};

}  // namespace

double expected_nodes(const Model& model, Size n) {
  return model.is_split() ? 2 * static_cast<double>(n) + 1 : model.grown().expected_nodes(n);
}

void TreeBatch::require_memory(const StatisticSet& statistics, std::uint64_t count) const {
  const FoldSet pass = sampling_method(statistics, graft).pass;
  ramify::require_memory("growing the trees", "--n", n, [&](Size size) {
    return growing_bytes(model, size, pass) * static_cast<double>(std::min<std::uint64_t>(threads, count));
  });
  ramify::require_memory("the table", "--replicates", count, [&](std::uint64_t trees) {
    constexpr double field_bytes = 130;  // of a row, of the table, of the text
    constexpr std::size_t first_columns = 4;
    const auto columns = first_columns + statistics.columns(model.largest_order(n)).size();
    return static_cast<double>(trees) * static_cast<double>(columns) * field_bytes;
  });
}

void TreeBatch::require_memory(TreeFormat format, std::uint64_t count) const {
  const auto tree_bytes = [&](Size size) { return expected_nodes(model, size) * node_bytes(format); };
  ramify::require_memory(fmt::format("a tree as {}", name_of(format)), "--n", n, tree_bytes);
  ramify::require_memory(fmt::format("the trees as {}", name_of(format)), "--replicates", count,
                         [&](std::uint64_t trees) {
                           constexpr double empty_tree = 200;
                           return static_cast<double>(trees) * (empty_tree + tree_bytes(n));
                         });
}

Table TreeBatch::table(const StatisticSet& statistics, std::uint64_t first, std::uint64_t last,
                       const Cancellation& cancellation) const {
  const auto columns = statistics.columns(model.largest_order(n));
  std::vector<Row> rows(last - first);
  Count count(*this, last - first);
  const GrowingJob job{model, n, seed, sampling_method(statistics, graft), first, last, most_trees};
  grow_blocks({job}, threads, cancellation, [&](const Block&, const BlockTrees& trees) {
    std::vector<StatisticValue> values;
    trees.each([&](std::uint64_t replicate, const TreeMeasures& measures) {
      write_statistics(columns, measures, values);
      rows[replicate - first] = row_of(*this, replicate, columns, values);
      count.one_more();
    });
  });
  std::vector<std::string> header{"model", "n", "seed", "replicate"};
  for (const auto& column : columns) header.push_back(column.name());
  Table table(std::move(header));
  table.reserve(rows.size());
  for (Row& row : rows) table.add(std::exchange(row, {}));
  return table;
}

std::vector<RecordedTree> TreeBatch::grown(std::uint64_t first, std::uint64_t last,
                                           const Cancellation& cancellation) const {
  const StreamKey key{seed, model.stream_cell(n)};
  std::vector<RecordedTree> trees(last - first);
  Count count(*this, last - first);
  const auto grow_each = [&](auto grow) {
    parallel_for(trees.size(), threads, [&](std::size_t item, unsigned) {
      if (cancellation.requested()) throw Interrupted();
      Stream stream(key, first + item);
      trees[item].tree = grow(stream);
      trees[item].name =
          fmt::format("{}, n = {}, seed {}, replicate {}", model.text(), n, seed, first + item);
      count.one_more();
    });
  };
  if (model.is_split()) {
    std::visit(
        [&]<class Law>(const Law& law) {
          const SplitTree<Law> grammar(law);
          grow_each([&](Stream& stream) { return grow_tree(grammar, n, stream, Watch(cancellation)); });
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
