#pragma once

#include <string>
#include <vector>

#include "claim.hpp"
#include "sample_trees.hpp"

#include "ramify/compare/verdict.hpp"
#include "ramify/page/page.hpp"
#include "ramify/report/filed_plot.hpp"

namespace ramify {

/// What a page knows of one claim.
struct ClaimOnPage {
  const Claim& claim;
  std::vector<Verdict> verdicts;
  std::vector<FiledPlot> plots;
  std::vector<const SampleTree*> trees;  ///< of its models
};

/// A claim on the page of the ledger: statement and source, pictures, links to trees of its models, its
/// parts, how each verdict was reached, negative controls, the command that repeats it. Its anchor is its
/// number, those of its parts are theirs.
PageSection claim_section(const ClaimOnPage& of, const std::string& command);

/// A row for every verdict, each with a link to its part and the verdict as a badge.
PageTable verdicts_on_page(const std::vector<Verdict>& verdicts, std::string caption);

}  // namespace ramify
