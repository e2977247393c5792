#include "ramify/measure/measure_files.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/core/error.hpp"
#include "ramify/core/nearest_name.hpp"
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

  /// @param lacking  what they do not have: "no norms"
  std::string said(std::string_view file, std::size_t trees, std::string_view lacking) const {
    return fmt::format(
        "{}: {} of {} trees have forks of three or more, {} first, and {}, which are those of binary trees: "
        "resolve them with --resolve ladder or random",
        file, count, trees, first, lacking);
  }
};

/// What trees with forks of three lack of what is asked for, in words; nothing where they have all.
std::string lacking_of_wide_trees(const MeasureRequest& request) {
  if (request.output == Output::norms) return "no norms";
  if (request.output != Output::summary && request.output != Output::json) return "";
  std::vector<std::string_view> undefined;
  const StatisticSet asked_for = request.statistics.value_or(StatisticSet::all());
  for (const StatisticInfo* info : asked_for.chosen())
    if (info->needs_binary) undefined.push_back(info->name);
  return undefined.empty() ? "" : fmt::format("no {}", fmt::join(undefined, ", "));
}

/// What the files hold, as far as the output asks for it.
class Measured {
 public:
  explicit Measured(const MeasureRequest& request) : request_(request) {}

  void add(const OrderCounts& counts) {
    if (request_.output == Output::nodes || request_.output == Output::levels)
      throw Error(
          fmt::format("{}: --table {}", counts.name, request_.output == Output::nodes ? "nodes" : "levels"),
          "a table of counts has no nodes", "take orders, summary or json");
    MeasuredOrders orders = measure_orders(counts);
    if (request_.output == Output::orders) {
      orders_.push_back(std::move(orders));
    } else {
      all_.push_back({std::move(orders), std::nullopt});
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

  std::variant<Table, std::string> content() const {
    switch (request_.output) {
      case Output::orders:
        return orders_table(orders_, request_.leaf_order);
      case Output::summary:
        return summary_table(all_, request_.leaf_order, request_.statistics);
      case Output::norms:
        return norms_table(all_);
      case Output::json:
        return measurement_json(all_, request_.leaf_order);
      case Output::levels:
        return levels_;
      case Output::nodes:
        break;
    }
    return nodes_;
  }

 private:
  const MeasureRequest& request_;
  std::vector<MeasuredOrders> orders_;
  std::vector<TreeMeasurement> all_;
  Table levels_ = level_table(), nodes_ = node_table();
};

}  // namespace

bool is_measure_output(std::string_view name) {
  return std::ranges::any_of(outputs, [&](const auto& output) { return output.first == name; });
}

MeasureRequest::Output parse_measure_output(const std::string& name) {
  std::vector<std::string> names;
  for (const auto& [known, output] : outputs) {
    if (name == known) return output;
    names.emplace_back(known);
  }
  throw Error(fmt::format("--table {}", name), "no such table",
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
    const std::string lacking = wide.count > 0 ? lacking_of_wide_trees(request) : "";
    if (!lacking.empty()) warn(wide.said(file, trees.size(), lacking));
  }
  return {measured.content(), measured.orders()};
}

}  // namespace ramify
