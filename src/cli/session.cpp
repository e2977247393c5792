#include "session.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <memory>
#include <thread>

#include <fmt/format.h>
#include <unistd.h>

#include "ramify/io/atomic_file.hpp"
#include "ramify/io/csv_writer.hpp"
#include "ramify/run/plan.hpp"
#include "ramify/text/read_count.hpp"

namespace ramify::cli {

std::vector<std::string> split_list(const std::string& text) {
  std::vector<std::string> items(1);
  int depth = 0;
  for (const char c : text) {
    if (c == '(') ++depth;
    if (c == ')') --depth;
    if (c == ',' && depth == 0)
      items.emplace_back();
    else if (c != ' ' || depth > 0)
      items.back() += c;
  }
  std::erase(items, "");
  return items;
}

unsigned read_threads(const std::string& text) {
  if (text.empty()) return std::max(1u, std::thread::hardware_concurrency());
  const std::uint64_t threads = read_count("--threads", text);
  if (threads < 1 || threads > 1024)
    throw Error(fmt::format("--threads {}", threads), "must be from 1 to 1024",
                "leave it out to use every core");
  return static_cast<unsigned>(threads);
}

void emit(const std::string& text, const std::string& output_file) {
  if (!output_file.empty()) return write_file_atomically(output_file, text);
  const bool written =
      std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (!written)
    throw Error("cannot write to standard output", std::strerror(errno),
                "free space, or name a file with -o");
}

void emit(const Table& table, const std::string& output_file) {
  emit(write_csv(table), output_file);
}

std::optional<PictureFile> picture_file(const std::string& text) {
  if (text.empty()) return std::nullopt;
  return PictureFile(text);
}

void require_consent(double nodes, bool yes) {
  if (nodes <= large_work || yes) return;
  throw Error(fmt::format("{:.3g} nodes to grow", nodes), "more than 10^13 takes days",
              "add --yes if you mean it, or see --dry-run");
}

std::function<void(double, double)> progress_line(const std::string& label) {
  if (isatty(STDERR_FILENO) == 0) return {};
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  auto last = std::make_shared<Clock::time_point>(begin);
  return [=](double done, double total) {
    const auto now = Clock::now();
    if (now - *last < std::chrono::milliseconds(200)) return;
    *last = now;
    const double seconds = std::chrono::duration<double>(now - begin).count();
    const double left = done > 0 ? seconds * (total - done) / done : 0;
    fmt::print(stderr, "\r{}: {:3.0f} %, {:.3g} nodes, {:.0f} s left \033[K", label, 100 * done / total, done,
               left);
    std::fflush(stderr);
  };
}

void clear_progress_line() {
  if (isatty(STDERR_FILENO) != 0) fmt::print(stderr, "\r\033[K");
}

}  // namespace ramify::cli
