#include "session.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstring>
#include <mutex>
#include <thread>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "ramify/core/number.hpp"
#include "ramify/io/atomic_file.hpp"
#include "ramify/io/csv_writer.hpp"
#include "ramify/io/readable.hpp"
#include "ramify/io/text_writer.hpp"
#include "ramify/run/plan.hpp"
#include "ramify/text/read_count.hpp"

namespace ramify::cli {
namespace {

/// The progress line: a thread that writes it, so that work need not look at the clock.
class Progress {
 public:
  Progress() : on_terminal_(isatty(STDERR_FILENO) != 0) {}

  /// Of new work.
  void show(const std::string& label) {
    if (!on_terminal_) return;
    hide();
    label_ = label;
    done_ = total_ = 0;
    writer_ = std::jthread([this](const std::stop_token& stop) { write_lines(stop); });
  }

  void tell(double done, double total) {
    done_ = done;
    total_ = total;
  }

  void hide() {
    if (writer_.joinable()) writer_ = {};  // waits for the thread
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds silent{2000}, between{200};

  void write_lines(const std::stop_token& stop) {
    const auto begin = Clock::now();
    std::unique_lock lock(mutex_);
    bool written = false;
    for (auto next = begin + silent; !wakes_.wait_until(lock, stop, next, [] { return false; });
         next = Clock::now() + between) {
      if (stop.stop_requested()) break;
      write_line(std::chrono::duration<double>(Clock::now() - begin).count());
      written = true;
    }
    if (written) fmt::print(stderr, "\r\033[K");
    std::fflush(stderr);
  }

  void write_line(double seconds) {
    const double done = done_, total = total_;
    if (done > 0 && total > 0)
      fmt::print(stderr, "\r{}: {:3.0f} %, {:.0f} s left \033[K", label_, 100 * done / total,
                 seconds * (total - done) / done);
    else
      fmt::print(stderr, "\r{}: {:.0f} s \033[K", label_, seconds);
    std::fflush(stderr);
  }

  const bool on_terminal_;
  std::string label_;
  std::atomic<double> done_ = 0, total_ = 0;
  std::mutex mutex_;
  std::condition_variable_any wakes_;
  std::jthread writer_;  // last: it ends before what it uses does
};

/// Characters of a line of the terminal; 0 where it does not say.
std::size_t terminal_width() {
  winsize size{};
  return ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

bool is_terminal_forgotten = false;

Progress& progress() {
  static Progress line;
  return line;
}

}  // namespace

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

void add_threads(Verb& verb, std::string& threads) {
  verb.option("--threads", threads, "threads; all cores if left out. The result does not depend on it");
}

unsigned read_threads(const std::string& text) {
  if (text.empty()) return std::max(1u, std::thread::hardware_concurrency());
  const std::uint64_t threads = read_count("--threads", text);
  if (threads < 1 || threads > 1024)
    throw Error(fmt::format("--threads {}", threads), "must be from 1 to 1024",
                "leave it out to use every core");
  return static_cast<unsigned>(threads);
}

Workforce read_workforce(const std::string& threads, Team* team) {
  return {threads.empty() && team != nullptr ? team->cores() : read_threads(threads), team};
}

std::uint64_t read_replicates(const std::string& text) {
  const std::uint64_t trees = read_count("--replicates", text);
  if (trees < 99)
    throw Error(fmt::format("--replicates {}", trees),
                "the smallest p-value is 2/(replicates + 1): with fewer than 99 trees above 0.02",
                "take 99 or more");
  return trees;
}

std::uint64_t read_bootstrap(const std::string& text) {
  const std::uint64_t trees = read_count("--bootstrap", text);
  if (trees > 0 && trees < 40)
    throw Error(fmt::format("--bootstrap {}", trees), "2.5 and 97.5 % of fewer than 40 trees are their ends",
                "take 40 trees or more, say 1000, or 0 for none");
  return trees;
}

double read_real(const std::string& option, const std::string& text) {
  if (const auto value = parse_real(text)) return *value;
  throw Error(option + " " + text, "not a finite number",
              "write a number or a fraction, such as 0.23 or 1/4.35");
}

void forget_terminal() {
  is_terminal_forgotten = true;
}

void Output::add_to(Verb& verb) {
  verb.option("-o,--output", file, "write to this file, in one step; - is standard output");
}

void Output::add_table_to(Verb& verb) {
  add_to(verb);
  verb.flag("--csv", csv, "a table as CSV on a terminal too, where it is aligned for reading");
}

bool Output::is_for_reading() const {
  return (file.empty() || file == "-") && !csv && !is_terminal_forgotten && isatty(STDOUT_FILENO) != 0;
}

void emit(const std::string& text, const Output& output) {
  clear_progress_line();
  if (!output.file.empty() && output.file != "-") return write_file_atomically(output.file, text);
  const bool written =
      std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (!written && errno == EPIPE) throw ClosedPipe();
  if (!written)
    throw Error("cannot write to standard output", std::strerror(errno),
                "free space, or name a file with -o");
}

void emit(const Table& table, const Output& output) {
  emit(output.is_for_reading() ? write_text(readable(table), terminal_width()) : write_csv(table), output);
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

void say_alone(const std::string& what, const Team& team) {
  fmt::print(stderr, "ramify: note: {} works in one process: the other {} of this job wait for it\n", what,
             team.processes() - 1);
}

void show_progress(const std::string& label) {
  progress().show(label);
}

std::function<void(double, double)> progress_line(const std::string& label) {
  progress().show(label);
  return [](double done, double total) { progress().tell(done, total); };
}

void clear_progress_line() {
  progress().hide();
}

}  // namespace ramify::cli
