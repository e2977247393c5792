#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ramify/dossier/report_request.hpp"
#include "ramify/format/order_counts.hpp"
#include "ramify/measure/tree_measurement.hpp"
#include "ramify/tree/recorded_tree.hpp"

namespace ramify {

/// One tree, or one table of counts, that a report is about.
struct Subject {
  std::string file;                  ///< as it was named
  std::string name;                  ///< the file, and the place in it where it holds several
  std::size_t place;                 ///< in the file, from 1
  std::size_t of;                    ///< trees or tables in the file
  std::optional<RecordedTree> tree;  ///< without one-child nodes; forks resolved where that is asked for
  std::optional<RecordedTree> as_recorded;  ///< forks and all, where the tree's were resolved
  std::optional<OrderCounts> counts;        ///< where it is a table
  TreeMeasurement measured;
  std::vector<std::string> remarks;  ///< of the reader, one line each; those of a file with its first subject
};

/// Reads and measures what the files hold. Throws Error for a file that cannot be read, and for more than
/// most_subjects trees together.
std::vector<Subject> read_subjects(const ReportRequest& request);

inline constexpr std::size_t most_subjects = 20;

}  // namespace ramify
