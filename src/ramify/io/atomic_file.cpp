#include "ramify/io/atomic_file.hpp"

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

#include "ramify/text/located_error.hpp"

namespace ramify {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t probe_bytes = 1 << 16;

std::string_view remedy(int reason) {
  switch (reason) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      return "free space or choose another place";
    case EACCES:
    case EPERM:
    case EROFS:
      return "get the right to write there or choose another place";
    case ENOENT:
      return "create its folder or choose another place";
    default:
      return "choose another place";
  }
}

Error cannot_write(const fs::path& path, int reason) {
  return error_at({}, fmt::format("cannot write '{}'", path.string()),
                  std::generic_category().message(reason), remedy(reason));
}

/// 0, or the reason why it failed. The last bytes may fail only at the close, so both are looked at.
int write_and_close(std::FILE* file, std::string_view content) {
  const bool whole = std::fwrite(content.data(), 1, content.size(), file) == content.size();
  const int write_reason = whole ? 0 : errno;
  const int close_reason = std::fclose(file) == 0 ? 0 : errno;
  return write_reason != 0 ? write_reason : close_reason;
}

/// A name that no file has: hidden, in the target's folder, so that the rename stays within one file system.
fs::path temporary_name(const fs::path& path) {
  static std::atomic<unsigned> counter{0};
  return path.parent_path() /
         fmt::format(".{}.{}-{}.part", path.filename().string(), ::getpid(), counter.fetch_add(1));
}

std::FILE* open_temporary(const fs::path& path, fs::path& temporary) {
  for (;;) {
    temporary = temporary_name(path);
    std::FILE* file = std::fopen(temporary.c_str(), "wbx");
    if (file != nullptr) return file;
    if (errno != EEXIST) throw cannot_write(path, errno);
  }
}

/// Temporary files that are being written, for a signal handler to see; where all places are taken (threads
/// that save cells are fewer) a file is not seen.
std::array<std::atomic<const char*>, 64> unfinished{};

class Unfinished {
 public:
  explicit Unfinished(const char* path) {
    for (auto& place : unfinished) {
      const char* none = nullptr;
      if (!place.compare_exchange_strong(none, path)) continue;
      place_ = &place;
      break;
    }
  }
  ~Unfinished() {
    if (place_ != nullptr) place_->store(nullptr);
  }
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;
  Unfinished(Unfinished&&) = delete;
  Unfinished& operator=(Unfinished&&) = delete;

 private:
  std::atomic<const char*>* place_ = nullptr;
};

bool must_be_written_through(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::symlink_status(path, ignored);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

void write_through(const fs::path& path, std::string_view content) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) throw cannot_write(path, errno);
  if (const int reason = write_and_close(file, content); reason != 0) throw cannot_write(path, reason);
}

/// The outermost folder of the path that does not exist yet; empty where all do.
fs::path first_missing(const fs::path& path) {
  fs::path missing;
  std::error_code ignored;
  for (fs::path p = path; !p.empty() && !fs::exists(p, ignored); p = p.parent_path()) missing = p;
  return missing;
}

void probe(const fs::path& folder) {
  fs::path file = folder / "probe";
  fs::path temporary;
  const int reason = write_and_close(open_temporary(file, temporary), std::string(probe_bytes, '\n'));
  std::error_code ignored;
  fs::remove(temporary, ignored);
  if (reason != 0) throw cannot_write(folder, reason);
}

}  // namespace

void write_file_atomically(const fs::path& path, std::string_view content) {
  if (must_be_written_through(path)) return write_through(path, content);
  fs::path temporary;
  std::FILE* file = open_temporary(path, temporary);
  const Unfinished listed(temporary.c_str());
  int reason = write_and_close(file, content);
  if (reason == 0 && std::rename(temporary.c_str(), path.c_str()) != 0) reason = errno;
  if (reason == 0) return;
  std::error_code ignored;
  fs::remove(temporary, ignored);
  throw cannot_write(path, reason);
}

void remove_unfinished_files() noexcept {
  for (const auto& place : unfinished)
    if (const char* path = place.load()) ::unlink(path);
}

void require_writable_folder(const fs::path& path) {
  // "results/" would have an empty last part, whose parent is itself.
  const fs::path folder = path.has_filename() ? path : path.parent_path();
  const fs::path created = first_missing(folder);
  std::error_code reason;
  fs::create_directories(folder, reason);
  if (!reason && !fs::is_directory(folder, reason)) reason = std::make_error_code(std::errc::not_a_directory);
  try {
    if (reason)
      throw error_at({}, fmt::format("cannot use the folder '{}'", path.string()), reason.message(),
                     remedy(reason.value()));
    probe(folder);
  } catch (const Error&) {
    std::error_code ignored;
    for (fs::path p = folder; !created.empty() && p != created.parent_path(); p = p.parent_path())
      fs::remove(p, ignored);
    throw;
  }
}

}  // namespace ramify
