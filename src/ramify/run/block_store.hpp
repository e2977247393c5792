#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ramify/run/grown_block.hpp"
#include "ramify/run/plan.hpp"

namespace ramify {

/// What a store holds.
struct KeptWork {
  std::size_t cells = 0;   ///< that are complete
  std::size_t blocks = 0;  ///< of others

  bool none() const { return cells + blocks == 0; }
};

/// "3 cells and 17 blocks"
std::string to_string(const KeptWork& kept);

/// The blocks of a run that are grown, in one SQLite file: what --resume goes on with.
///
/// A block is kept by one transaction, before the thread that grew it begins another, so that a process that
/// is killed loses no more than the blocks under way. When the last block of a cell is there, their sum takes
/// their place. A store serves one plan, whatever the machine, and one process at a time. It outlasts the end
/// of the process, however that comes; of a power cut the last blocks (no sync to the disk). Copy it with the
/// file "-wal" beside it, if there is one. Not for several threads at once.
class BlockStore {
 public:
  /// Opens it, or makes it. A file that is damaged, or no store of ramify's, is renamed (set_aside) and a new
  /// one made.
  /// Throws Error where it is of another plan or version (the first difference is named), where another
  /// process has it, and where it cannot be written.
  BlockStore(std::filesystem::path file, const Plan& plan);
  BlockStore(const BlockStore&) = delete;
  BlockStore& operator=(const BlockStore&) = delete;
  BlockStore(BlockStore&&) = delete;
  BlockStore& operator=(BlockStore&&) = delete;
  ~BlockStore();

  /// Where what lay in its place was put; nothing where all was well.
  const std::optional<std::filesystem::path>& set_aside() const { return set_aside_; }

  KeptWork kept() const;

  /// The sums of a cell that is complete.
  std::optional<CellSums> cell(std::size_t cell) const;
  /// The blocks of one that is not, by index. One that cannot be read is left out.
  std::vector<GrownBlock> blocks(std::size_t cell) const;

  /// Throws Error where the disk refuses; what was kept stays.
  void save(const GrownBlock& grown);
  /// The sum of all blocks of a cell, in their place.
  void complete(std::size_t cell, const CellSums& sums);

  /// What a file holds; nothing of one that is no store. Changes nothing.
  static KeptWork kept_in(const std::filesystem::path& file);

  static constexpr const char* file_name = "blocks.sqlite";

 private:
  class Database;

  const Plan* plan_;
  std::filesystem::path file_;
  std::optional<std::filesystem::path> set_aside_;
  std::unique_ptr<Database> database_;
};

}  // namespace ramify
