#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ramify/statistic/tree_measures.hpp"
#include "ramify/tree/grammar.hpp"

namespace ramify {

/// A value of a statistic: a whole number or a real one, as StatisticInfo::real says.
union StatisticValue {
  std::int64_t whole;
  double real;
};

/// What must be known of a tree for a statistic to be read off.
enum class Measure { size, strahler, height, counts, depth, fill_level, balance };

/// What `ramify list statistics` says of a statistic, and how it is read off a measured tree.
struct StatisticInfo {
  std::string_view name;
  std::string_view convention;  ///< base, what is counted
  std::string_view description;
  std::string_view source;
  bool real;        ///< a real number; else a whole number, summed exactly
  bool per_order;   ///< one column for each order 0..K
  Measure measure;  ///< what it is read off
  StatisticValue (*value)(const TreeMeasures&, std::size_t order);

  /// "strahler", or "nodes_0..nodes_K".
  std::string columns() const;
};

/// All statistics, in the order they are listed.
const std::vector<StatisticInfo>& statistics();

/// A choice of statistics, each once, in the order given.
class StatisticSet {
 public:
  /// Throws Error for an unknown name (nearest names given) or one given twice.
  static StatisticSet parse(std::span<const std::string> names);

  const std::vector<const StatisticInfo*>& chosen() const { return chosen_; }
  bool contains(std::string_view name) const;
  /// Nothing but sizes and this is read.
  bool reads_only(Measure measure) const;
  bool reads(Measure measure) const;

  /// Column names for trees of size n: one a statistic, and nodes_0..nodes_K, streams_0..streams_K with K =
  /// floor(log2(n+1)), the largest order a tree of that size can have, so that a table's columns never depend
  /// on what was drawn.
  std::vector<std::string> columns(Size n) const;

 private:
  std::vector<const StatisticInfo*> chosen_;
};

/// The chosen statistics of a measured tree, in the order of StatisticSet::columns(measures.size).
void write_statistics(const StatisticSet& statistics, const TreeMeasures& measures,
                      std::vector<StatisticValue>& row);

}  // namespace ramify
