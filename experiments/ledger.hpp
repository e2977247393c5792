#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "claim.hpp"

#include "ramify/compare/verdict.hpp"
#include "ramify/run/model_looks.hpp"

namespace ramify {

/// The finished cells that bear on every claim, and the verdicts on its parts.
class Ledger {
 public:
  /// @param looks  of the models in plots; those of models that come later are added
  explicit Ledger(ModelLooks looks = {}) : looks_(std::move(looks)) {}

  /// Adds the cells and curves of a config to the claims it serves. Throws Error as served_claims does.
  void add(const RunConfig& config, const CheckedRun& run);

  /// The claims that have cells, in the order of the catalogue.
  std::vector<const Claim*> served() const;

  /// Verdicts on the parts of the claims, in their order, and the parts that could not be judged, each with
  /// what was wrong.
  struct Judged {
    std::vector<Verdict> verdicts;
    std::vector<std::string> failures;
  };
  /// Parts are judged on so many threads; no verdict depends on that. Throws Interrupted.
  Judged judged(const std::vector<const Claim*>& claims, GrowthLimits& limits, unsigned threads,
                const Cancellation& cancellation) const;

  /// Plots of the claims that have cells.
  std::vector<NamedPlot> plots() const;

  /// The largest |z| of any sampled mean against its exact value, and where.
  struct WorstCheck {
    SamplerCheck check;
    std::string where;
  };
  WorstCheck worst_check() const;

 private:
  SamplerCheck sampler_check(const Claim& claim, const ClaimPart& part) const;

  ModelLooks looks_;
  std::map<std::string_view, std::vector<ModelCells>> models_;  // by claim
  std::vector<CheckedCell> all_;
  std::size_t means_ = 0;  ///< of all cells, that were held against exact ones
};

}  // namespace ramify
