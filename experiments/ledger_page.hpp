#pragma once

#include <string>
#include <vector>

#include "claim.hpp"
#include "claim_section.hpp"
#include "ledger.hpp"
#include "sample_trees.hpp"

#include "ramify/config/run_config.hpp"

namespace ramify {

/// What was reproduced, and by which command.
struct Reproduction {
  std::string scale;    ///< "quick"
  std::string asked;    ///< of --claim: "C20"; nothing for all
  std::string options;  ///< of the command beside --scale and --claim: " --seed 7"; or nothing
  std::vector<RunConfig> configs;
  std::vector<const Claim*> claims;  ///< that were asked for
  Ledger::Judged judged;
  // NOLINTNEXTLINE(readability-redundant-member-init): -Wextra wants it where an aggregate leaves it out
  std::vector<SampleTree> trees = {};  ///< of the models that the claims take trees of
};

/// The claims with their verdicts and pictures. A plot is of the claim whose number its name begins with.
std::vector<ClaimOnPage> claims_on_page(const Reproduction& reproduction,
                                        const std::vector<FiledPlot>& plots);

/// The ledger for reading, report.html: at a glance, with filters; how to read it; claim by claim; what it is
/// made from. Where, when, by which commit and on how many threads stand in every run's provenance.json
/// alone: the page is the same bytes everywhere, but for what gnuplot makes of the pictures.
Page ledger_page(const Reproduction& reproduction, const std::vector<ClaimOnPage>& claims);

}  // namespace ramify
