#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "claim.hpp"

#include "ramify/run/model_looks.hpp"

namespace ramify {

/// The finished cells that bear on every claim, claim by claim.
class Evidence {
 public:
  /// @param looks  of the models in plots; those of models that come later are added
  explicit Evidence(ModelLooks looks = {}) : looks_(std::move(looks)) {}

  /// Adds the cells and curves of a config to the claims it serves. Throws Error as served_claims does.
  void add(const RunConfig& config, const CheckedRun& run);

  /// Verdicts of all claims with evidence, in the order of the catalogue.
  std::vector<Verdict> verdicts() const;

  /// Their plots.
  std::vector<NamedPlot> plots() const;

  /// The largest |z| of any sampled mean against its exact value, and where.
  struct WorstCheck {
    double z;
    std::string where;
    std::size_t checks;

    /// No sampler that follows its law lies so far off: some thousand means are checked in a full
    /// reproduction, and six standard errors are one false alarm in half a million of them.
    bool is_alarming() const { return z >= alarming; }
    static constexpr double alarming = 6;
  };
  /// Nothing where no law was in reach.
  std::optional<WorstCheck> worst_check() const;

 private:
  ModelLooks looks_;
  std::map<std::string_view, std::vector<ModelCells>> models_;  // by claim
  std::vector<CheckedCell> all_;
};

}  // namespace ramify
