#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ramify/core/cancellation.hpp"
#include "ramify/model/registry.hpp"
#include "ramify/statistic/statistic_info.hpp"
#include "ramify/tree/tree.hpp"

namespace ramify {

/// One statistic of a tree beside what trees of a model have at its size.
struct ComparedStatistic {
  StatisticColumn column;
  double observed;
  double expected;    ///< exact mean where it is known, else that of the simulated trees
  double deviation;   ///< standard deviation of one tree, likewise: its standard error under the model
  double p_value;     ///< two-sided: twice the smaller of P(X <= observed) and P(X >= observed), at most 1
  double adjusted_p;  ///< for the number of statistics (Holm 1979)
  bool exact;         ///< the p-value is that of the exact law, else of the simulated trees
  bool is_bound;      ///< the p-value is at most p_value: the law, or the sample, says no more

  /// Standard deviations off the mean; 0 where all trees have the same value and so has this one, infinite
  /// where not.
  double effect() const;
};

/// How trees of the model are simulated for what has no exact law. The smallest p-value is 2/(trees + 1).
struct Simulation {
  std::uint64_t seed = 1996;
  std::uint64_t trees = 1999;
  unsigned threads = 1;  ///< decides the time alone
};

/// Is a tree like trees of the model? Compares order, height, width, fill level, balance, cherries, Sackin
/// and Colless index and the mean ratios of nodes and streams with those of model trees of the same size.
///
/// What it computes and simulates of a size it keeps for the next tree of that size. For use by one thread.
class TreeComparison {
 public:
  /// @param cancellation  looked at between simulated trees; must outlive the object
  TreeComparison(Model model, const Simulation& simulation, const Cancellation& cancellation);
  TreeComparison(const TreeComparison&) = delete;
  TreeComparison(TreeComparison&&) = delete;
  TreeComparison& operator=(const TreeComparison&) = delete;
  TreeComparison& operator=(TreeComparison&&) = delete;
  ~TreeComparison();

  /// Throws Error for a tree of fewer than two internal nodes, one with other than two children where the
  /// model has two, and a model whose n does not count internal nodes. Throws Interrupted. Cost, of a new
  /// size: `trees` trees of it, some 40 ns a node, and the exact laws of the model, at most some seconds.
  /// @param where  names the tree in messages
  std::vector<ComparedStatistic> operator()(const Tree& tree, std::string_view where);

 private:
  struct Reference;
  const Reference& reference(Size n);

  Model model_;
  Simulation simulation_;
  const Cancellation& cancellation_;
  std::map<Size, std::unique_ptr<const Reference>> references_;
};

}  // namespace ramify
