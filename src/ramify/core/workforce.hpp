#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "ramify/core/cancellation.hpp"

namespace ramify {

/// The outcome of an item on its way between processes.
using Bytes = std::vector<std::uint8_t>;

/// Work that falls into items which any process of a team can do.
struct SharedWork {
  /// All that an item's outcome depends on: processes that differ in it do not work together.
  std::string identity;
  /// What is to be done, in the order in which it is handed out. The leading process decides.
  std::vector<std::size_t> items;
  /// Does an item in the leading process and keeps its outcome; several threads call it at once.
  /// worker says which thread of its process it is.
  std::function<void(std::size_t item, unsigned worker)> keep;
  /// Does an item in another process, likewise.
  std::function<Bytes(std::size_t item, unsigned worker)> send;
  /// Keeps the outcome of an item that another process did; one call at a time, beside those of keep.
  std::function<void(std::size_t item, const Bytes& outcome)> take;
};

/// Processes that do the same command together: all of them go the same way through the program, one leads,
/// and what is shared is done by all. The others write nothing and learn no outcome.
class Team {
 public:
  Team() = default;
  Team(const Team&) = delete;
  Team(Team&&) = delete;
  Team& operator=(const Team&) = delete;
  Team& operator=(Team&&) = delete;
  virtual ~Team() = default;

  virtual bool leads() const = 0;
  virtual unsigned processes() const = 0;
  /// Of this process, on the machine that it shares with others of the team.
  virtual unsigned cores() const = 0;

  /// Does every item once, somewhere, and returns when all are done. Throws what an item throws, in the
  /// leading process; Interrupted where any process is stopped.
  virtual void share(const SharedWork& work, unsigned threads, const Cancellation& cancellation) = 0;
};

/// Who does what falls into items: threads of this process, and those of the others where there is a team.
struct Workforce {
  // NOLINTNEXTLINE(google-explicit-constructor): threads alone are a workforce
  Workforce(unsigned threads_here, Team* its_team = nullptr) : threads(threads_here), team(its_team) {}

  unsigned processes() const { return team == nullptr ? 1 : team->processes(); }
  /// False in a process that only helps: it writes nothing, and outcomes of what is shared are not known
  /// there.
  bool leads() const { return team == nullptr || team->leads(); }

  unsigned threads;  ///< of this process, >= 1
  Team* team;        ///< none: this process is alone
};

/// Does every item of shared work once, and returns when all are done; throws as Team::share does.
void share(const SharedWork& work, const Workforce& workforce, const Cancellation& cancellation);

}  // namespace ramify
