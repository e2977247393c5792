#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "claim.hpp"

#include "ramify/io/table.hpp"

namespace ramify {

/// The finished cells that bear on every claim, claim by claim.
class Evidence {
 public:
  /// Adds the cells of a config to the claims it names.
  void add(const std::vector<const Claim*>& served, const std::vector<CheckedCell>& cells);

  /// Verdicts of all claims with evidence, in the order of the catalogue.
  std::vector<Verdict> verdicts() const;

  /// Their plots.
  std::vector<NamedPlot> plots() const;

  /// The largest |z| of any sampled mean against its exact value, and where; nothing where no law was in
  /// reach.
  struct WorstCheck {
    double z;
    std::string where;
    std::size_t checks;
  };
  std::optional<WorstCheck> worst_check() const;

 private:
  std::map<std::string_view, std::vector<CheckedCell>> cells_;
  std::vector<CheckedCell> all_;
};

/// verdicts.csv (INTERFACE: reproduce).
Table verdict_table(const std::vector<Verdict>& verdicts);

/// The same for a terminal: claim, statement, theory, estimate with its interval, largest n, verdict.
std::string verdict_text(const std::vector<Verdict>& verdicts);

/// Claims whose verdict differs from the one in a committed verdicts.csv, "C20.2: refuted, was inconclusive";
/// claims that only one of the two has are passed over. Throws Error where the file cannot be read.
std::vector<std::string> changed_verdicts(const std::vector<Verdict>& verdicts,
                                          const std::filesystem::path& reference);

/// verdict.json of one run folder.
std::string verdict_json(const std::vector<Verdict>& verdicts);

}  // namespace ramify
