#pragma once

#include <filesystem>
#include <optional>

#include "ramify/run/cell_result.hpp"
#include "ramify/run/plan.hpp"

namespace ramify {

/// Finished cells on disk, one JSON file each: what --resume and the verdicts read.
///
/// A file's name is a hash of all that its content depends on (version, seed, statistics, model, n,
/// replicates), so a stored cell is either exactly the one wanted or not found.
class CellStore {
 public:
  CellStore(std::filesystem::path folder, const Plan& plan) : folder_(std::move(folder)), plan_(&plan) {}

  /// The stored result of cell `index`; nothing where there is none, or none that can be read.
  std::optional<CellResult> load(std::size_t index) const;

  /// Writes it atomically. Throws Error where the disk refuses.
  void save(std::size_t index, const CellResult& result) const;

 private:
  std::filesystem::path file_of(std::size_t index) const;

  std::filesystem::path folder_;
  const Plan* plan_;
};

}  // namespace ramify
