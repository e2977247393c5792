#include "ramify/measure/measure_files.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/core/error.hpp"
#include "ramify/core/nearest_name.hpp"
#include "ramify/io/csv_writer.hpp"
#include "ramify/measure/measure_json.hpp"
#include "ramify/measure/measure_tables.hpp"
#include "ramify/measure/norms_table.hpp"
#include "ramify/tree/contract_unary.hpp"

namespace ramify {
namespace {

using Output = MeasureRequest::Output;

constexpr std::array<std::pair<const char*, Output>, 6> outputs{{{"orders", Output::orders},
                                                                 {"summary", Output::summary},
                                                                 {"norms", Output::norms},
                                                                 {"levels", Output::levels},
                                                                 {"nodes", Output::nodes},
                                                                 {"json", Output::json}}};

/// Every tree of a file has a stream of its own.
constexpr std::uint64_t resolution_seed = 1996;

/// Trees of a file with forks of three or more.
struct WideTrees {
  std::size_t count = 0;
  std::string first;

  void see(const RecordedTree& tree) {
    if (wide_forks(tree.tree) == 0) return;
    if (count++ == 0) first = tree.name;
  }

  std::string said(std::string_view file, std::size_t trees) const {
    return fmt::format(
        "{}: {} of {} trees have forks of three or more, {} first, and no norms, which are those of binary "
        "trees: resolve them with --resolve ladder or random",
        file, count, trees, first);
  }
};

/// What the files hold, as far as the output asks for it.
class Measured {
 public:
  explicit Measured(const MeasureRequest& request) : request_(request) {}

  void add(const OrderCounts& counts) {
    if (request_.output == Output::nodes || request_.output == Output::levels)
      throw Error(
          fmt::format("{}: --output {}", counts.name, request_.output == Output::nodes ? "nodes" : "levels"),
          "a table of counts has no nodes", "take orders, summary or json");
    MeasuredOrders orders = measure_orders(counts);
    if (request_.output == Output::orders) {
      orders_.push_back(std::move(orders));
    } else {
      all_.push_back({std::move(orders), std::nullopt, {}});
    }
  }

  void add(const RecordedTree& tree) {
    switch (request_.output) {
      case Output::orders:
        return orders_.push_back(measure_orders(tree));
      case Output::levels:
        return add_levels(levels_, tree);
      case Output::nodes:
        return add_nodes(nodes_, tree, request_.leaf_order);
      case Output::summary:
      case Output::norms:
      case Output::json:
        all_.push_back(measure_all(tree));
    }
  }

  std::vector<MeasuredOrders> orders() const {
    std::vector<MeasuredOrders> orders = orders_;
    for (const TreeMeasurement& tree : all_) orders.push_back(tree.orders);
    return orders;
  }

  std::string text() const {
    switch (request_.output) {
      case Output::orders:
        return write_csv(orders_table(orders_, request_.leaf_order));
      case Output::summary:
        return write_csv(summary_table(all_, request_.leaf_order));
      case Output::norms:
        return write_csv(norms_table(all_));
      case Output::json:
        return measurement_json(all_, request_.leaf_order);
      case Output::levels:
        return write_csv(levels_);
      case Output::nodes:
        break;
    }
    return write_csv(nodes_);
  }

 private:
  const MeasureRequest& request_;
  std::vector<MeasuredOrders> orders_;
  std::vector<TreeMeasurement> all_;
  Table levels_ = level_table(), nodes_ = node_table();
};

}  // namespace

MeasureRequest::Output parse_measure_output(const std::string& name) {
  std::vector<std::string> names;
  for (const auto& [known, output] : outputs) {
    if (name == known) return output;
    names.emplace_back(known);
  }
  throw Error(fmt::format("--output {}", name), "no such table",
              fmt::format("{}take {}", did_you_mean(name, names), fmt::join(names, ", ")));
}

MeasuredFiles measure_files(const MeasureRequest& request, const Cancellation& cancellation,
                            const std::function<void(const std::string&)>& warn) {
  Measured measured(request);
  for (const auto& file : request.files) {
    const std::string text = read_tree_file(file);
    if (!request.format && is_order_table(text)) {
      for (const OrderCounts& counts : read_order_counts(SourceText(text, file))) {
        for (const auto& warning : counts.warnings) warn(warning);
        measured.add(counts);
      }
      continue;
    }
    Remarks remarks;
    auto trees = read_trees(text, file, request.format, request.reading, remarks);
    for (const auto& line : remarks.lines(file)) warn(line);
    WideTrees wide;
    for (std::size_t i = 0; i < trees.size(); ++i) {
      RecordedTree& tree = trees[i];
      if (cancellation.requested()) throw Interrupted();
      if (!request.keep_unary) tree = contract_unary(std::move(tree));
      if (request.resolve) {
        Stream stream({resolution_seed, 0}, i);
        tree = resolve_forks(std::move(tree), *request.resolve, stream);
      }
      wide.see(tree);
      measured.add(tree);
    }
    if (request.output == Output::norms && wide.count > 0) warn(wide.said(file, trees.size()));
  }
  return {measured.text(), measured.orders()};
}

}  // namespace ramify
