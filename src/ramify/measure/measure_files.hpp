#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "ramify/core/cancellation.hpp"
#include "ramify/format/read_trees.hpp"
#include "ramify/io/table.hpp"
#include "ramify/measure/tree_measurement.hpp"
#include "ramify/statistic/statistic_set.hpp"
#include "ramify/tree/resolve_forks.hpp"

namespace ramify {

/// What `ramify measure` is asked for.
struct MeasureRequest {
  enum class Output { orders, summary, norms, levels, nodes, json };

  std::vector<std::string> files;    ///< of trees, or of counts of streams; "-" is standard input
  std::optional<TreeFormat> format;  ///< found by content where none is given
  ReadOptions reading;
  unsigned leaf_order = 1;  ///< 0 or 1: order of the external nodes in the tables
  bool keep_unary = false;  ///< count one-child nodes instead of contracting them
  std::optional<ForkResolution>
      resolve;  ///< of forks of three and more; left as they are where it is not given
  Output output = Output::orders;
  std::optional<StatisticSet> statistics;  ///< of the summary; all, and what else there is, where not given
};

/// What the files hold.
struct MeasuredFiles {
  std::variant<Table, std::string> content;  ///< the table, or the text of the JSON
  std::vector<MeasuredOrders> orders;  ///< of every tree and table of counts; empty for nodes and levels
};

/// There is an output of that name.
bool is_measure_output(std::string_view name);

/// The output of that name; throws Error for another (nearest names given).
MeasureRequest::Output parse_measure_output(const std::string& name);

/// Reads the files and measures all that they hold. Throws Error for a file that
/// cannot be read and for nodes or levels of a table of counts, Interrupted when cancelled.
/// @param warn  is told what is not read of a file, and what is doubtful in it, in one line each
MeasuredFiles measure_files(const MeasureRequest& request, const Cancellation& cancellation,
                            const std::function<void(const std::string&)>& warn);

}  // namespace ramify
