#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "ramify/family/family.hpp"

namespace ramify {

/// What `ramify report` is asked for.
struct ReportRequest {
  std::vector<std::string> files;  ///< of trees, or of counts of streams; "-" is standard input
  std::string root;                ///< of a table of nodes, as of `measure`
  std::string resolve;             ///< "ladder", "random", or empty: forks of three stay, and are not fitted
  std::vector<const Family*> families;  ///< none: those that are quick (quick_families)
  std::uint64_t replicates = 999;       ///< trees of the best model that a tree is compared with
  std::uint64_t bootstrap = 99;  ///< trees that say how well the best model fits a tree; none: no such p
  std::uint64_t seed = 1996;
  unsigned threads = 1;  ///< decides the time alone
  // NOLINTNEXTLINE(readability-redundant-member-init): -Wextra wants it where an aggregate leaves it out
  std::function<void(double done, double total)> progress = {};  ///< in trees and tables; may be empty
};

}  // namespace ramify
