#include "ramify/run/work_folder.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include "ramify/core/error.hpp"
#include "ramify/io/atomic_file.hpp"
#include "ramify/run/block_store.hpp"

namespace ramify {
namespace {

namespace fs = std::filesystem;

/// What a run that was told to stop may take: its processes can outlive the mpirun that started them, and
/// who goes on with it comes before they have ended.
constexpr std::chrono::seconds stopping_time{2};

fs::path work_of(const fs::path& folder) {
  return folder.string() + ".incomplete";
}

/// Entries of a folder; 0 where there is none, or none that can be looked into.
std::ptrdiff_t entries(const fs::path& folder) {
  std::error_code ignored;
  return std::distance(fs::directory_iterator(folder, ignored), fs::directory_iterator());
}

void remove_whole(const fs::path& path) {
  std::error_code reason;
  fs::remove_all(path, reason);
  if (reason)
    throw Error(fmt::format("cannot remove '{}'", path.string()), reason.message(), "choose another --out");
}

void empty_folder(const fs::path& folder) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) remove_whole(entry.path());
}

}  // namespace

void require_run_folder(const fs::path& folder, KeptCells kept) {
  std::error_code ignored;
  for (const fs::path& path : {folder, work_of(folder)})
    if (fs::exists(path, ignored) && !fs::is_directory(path, ignored))
      throw Error(fmt::format("'{}' is a file", path.string()), "a run has a folder of its own there",
                  "choose another --out");
  if (entries(folder) > 0 && !fs::exists(folder / "provenance.json", ignored))
    throw Error(fmt::format("'{}' is not the folder of a run", folder.string()),
                "it has no provenance.json, and a run would replace it", "choose another --out");
  const KeptWork stopped = BlockStore::kept_in(work_of(folder) / BlockStore::file_name);
  if (!stopped.none() && kept == KeptCells::refuse)
    throw Error(
        fmt::format("{} of a stopped run are kept in '{}'", to_string(stopped), work_of(folder).string()),
        "a new run would drop them", "add --resume to go on with them, or --restart to begin anew");
}

WorkFolder::WorkFolder(fs::path folder, KeptCells kept)
    : folder_(std::move(folder)), work_(work_of(folder_)) {
  lock(kept == KeptCells::take_over ? stopping_time : std::chrono::seconds(0));
  try {
    require_run_folder(folder_, kept);
    if (kept != KeptCells::take_over) empty_folder(work_);
  } catch (const Error&) {
    ::close(locked_);
    throw;
  }
}

WorkFolder::~WorkFolder() {
  ::close(locked_);
}

void WorkFolder::lock(std::chrono::steady_clock::duration patience) {
  const auto lost = std::chrono::steady_clock::now() + patience;
  while (!try_lock()) {
    if (std::chrono::steady_clock::now() >= lost)
      throw Error(fmt::format("another run works in '{}'", work_.string()), "two would mix their cells",
                  "wait for it, or choose another --out");
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

bool WorkFolder::try_lock() {
  require_writable_folder(work_);  // again at every try: a run that is finished takes it away
  locked_ = ::open(work_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (locked_ >= 0 && ::flock(locked_, LOCK_EX | LOCK_NB) == 0) return true;
  if (errno != EWOULDBLOCK) return true;  // a file system without locks: then nothing is known of other runs
  ::close(locked_);
  return false;
}

void WorkFolder::move_into_place() const {
  remove_whole(folder_);
  std::error_code reason;
  fs::rename(work_, folder_, reason);
  if (reason)
    throw Error(fmt::format("cannot rename '{}' to '{}'", work_.string(), folder_.string()), reason.message(),
                "rename it yourself: it is complete");
}

}  // namespace ramify
