#include "ramify/tabulate/tree_batch.hpp"

#include <memory>
#include <vector>

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/core/number.hpp"
#include "ramify/core/parallel.hpp"
#include "ramify/format/write_trees.hpp"
#include "ramify/io/csv_writer.hpp"
#include "ramify/model/split_tree.hpp"
#include "ramify/random/stream.hpp"
#include "ramify/sample/tree_sampler.hpp"
#include "ramify/tree/store.hpp"

namespace ramify {
namespace {

std::vector<std::string> format_row(const TreeBatch& batch, std::uint64_t replicate,
                                    const std::vector<StatisticSet::Column>& columns,
                                    const std::vector<StatisticValue>& values) {
  std::vector<std::string> row{batch.model.text(), std::to_string(batch.n), std::to_string(batch.seed),
                               std::to_string(replicate)};
  for (std::size_t i = 0; i < columns.size(); ++i)
    row.push_back(columns[i].statistic->real ? format_summary(values[i].real)
                                             : std::to_string(values[i].whole));
  return row;
}

}  // namespace

std::string TreeBatch::table(const StatisticSet& statistics, std::uint64_t first, std::uint64_t last,
                             const Cancellation& cancellation) const {
  const StreamKey key{seed, model.stream_cell(n)};
  const auto prototype = make_tree_sampler({model, sampling_method(statistics, graft), n, &cancellation});
  struct Worker {
    std::unique_ptr<TreeSampler> sampler;
    TreeMeasures measures;
    std::vector<StatisticValue> values;
  };
  const auto columns = statistics.columns(model.largest_order(n));
  std::vector<Worker> workers(threads);
  for (auto& worker : workers) worker.sampler = prototype->clone();
  std::vector<std::vector<std::string>> rows(last - first);
  parallel_for(rows.size(), threads, [&](std::size_t item, unsigned index) {
    if (cancellation.requested()) throw Interrupted();
    auto& [sampler, measures, values] = workers[index];
    sampler->sample(n, key, first + item, measures);
    write_statistics(columns, measures, values);
    rows[item] = format_row(*this, first + item, columns, values);
  });
  std::vector<std::string> header{"model", "n", "seed", "replicate"};
  for (const auto& column : columns) header.push_back(column.name);
  CsvTable table(std::move(header));
  for (auto& row : rows) table.add(std::move(row));
  return table.text();
}

std::string TreeBatch::trees(TreeFormat format, std::uint64_t first, std::uint64_t last,
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
  return write_trees(trees, format);
}

}  // namespace ramify
