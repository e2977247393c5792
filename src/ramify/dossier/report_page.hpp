#pragma once

#include <string>
#include <vector>

#include "ramify/core/cancellation.hpp"
#include "ramify/dossier/subject.hpp"
#include "ramify/page/page.hpp"

namespace ramify {

/// A report, and what is to be said of its making.
struct Report {
  Page page;
  std::vector<std::string> warnings;  ///< pictures that are missing, and why
  bool converged;                     ///< the best fit of every subject that was fitted
};

/// One page about trees and tables of counts: picture, orders, ratios, families ranked, where the tree
/// departs from the best, in plain words; with the commands that repeat each number. The same page for the
/// same files, request and gnuplot, whatever the threads. Throws Interrupted. Cost: find_out of every
/// subject.
Report report_page(const std::vector<Subject>& subjects, const ReportRequest& request,
                   const Cancellation& cancellation);

}  // namespace ramify
