#pragma once

#include <chrono>
#include <filesystem>

namespace ramify {

/// What becomes of the cells that a stopped run of the same name has kept.
enum class KeptCells {
  refuse,     ///< an Error says that they are there
  take_over,  ///< --resume
  drop,       ///< --restart
};

/// Throws Error where a run may not be put in `folder`: it is a file or holds what no run wrote (it has no
/// provenance.json), or "<folder>.incomplete" keeps cells of a stopped run and these are to be refused.
/// Changes nothing.
void require_run_folder(const std::filesystem::path& folder, KeptCells kept);

/// "<folder>.incomplete", in which a run works until it is finished; no other process works in it meanwhile.
class WorkFolder {
 public:
  /// Throws Error as require_run_folder does, where another run works there (to take over, when it has not
  /// ended in two seconds), and where nothing can be written.
  WorkFolder(std::filesystem::path folder, KeptCells kept);
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  WorkFolder(WorkFolder&&) = delete;
  WorkFolder& operator=(WorkFolder&&) = delete;

  const std::filesystem::path& path() const { return work_; }

  /// Puts it in the place of `folder`, and of an older run there.
  void move_into_place() const;

 private:
  void lock(std::chrono::steady_clock::duration patience);
  /// False where another run works there.
  bool try_lock();

  std::filesystem::path folder_, work_;
  int locked_ = -1;  // a descriptor of the folder; the system lets go of it however the process ends
};

}  // namespace ramify
