#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "exit_code.hpp"

#include "ramify/core/cancellation.hpp"
#include "ramify/core/workforce.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): theirs
class App;
class Option;
}  // namespace CLI

namespace ramify::cli {

/// How an option is shown, and whether it may be left out.
enum class Need {
  optional,
  defaulted,  ///< help shows the value it has where it is left out
  required,
};

/// An option that was declared, to be named in a rule.
struct DeclaredOption {
  CLI::Option* option;
};

/// One verb while it is declared. The command-line library stays behind it: one file pays for its headers.
///
/// Values must live until the program has run: keep them in what `work` captures.
class Verb {
 public:
  using Work = std::function<ExitCode(const Cancellation&)>;
  /// By all processes of a team; none: this process is alone.
  using TeamWork = std::function<ExitCode(Team*, const Cancellation&)>;

  /// What the chosen verb does: one of the two.
  struct Chosen {
    Work alone;
    TeamWork together;
  };

  Verb(CLI::App& app, Chosen& chosen) : app_(&app), chosen_(&chosen) {}

  /// @param names  "--n", "-o,--output", or a bare name where it is known by its place
  DeclaredOption option(const std::string& names, std::string& value, const std::string& what,
                        Need need = Need::optional);
  /// One or more values.
  DeclaredOption option(const std::string& names, std::vector<std::string>& values, const std::string& what,
                        Need need = Need::optional);
  DeclaredOption flag(const std::string& names, bool& value, const std::string& what);
  /// The two are not given together.
  static void exclude(DeclaredOption one, DeclaredOption other);
  /// Ends the help of the verb.
  void example(const std::string& text);
  /// What the verb does, once it is chosen and its options are read.
  void work(Work work);
  /// The same of a verb that the processes of a team do together; those that do not lead must write nothing.
  void team_work(TeamWork work);

 private:
  CLI::App* app_;
  Chosen* chosen_;
};

class ProgramPages;

/// The command line: verbs, and the flag that Ctrl-C sets.
class Program {
 public:
  Program();
  Program(const Program&) = delete;
  Program(Program&&) = delete;
  Program& operator=(const Program&) = delete;
  Program& operator=(Program&&) = delete;
  ~Program();

  Verb verb(const std::string& name, const std::string& description);

  /// Pages about the program, made from what was declared.
  ProgramPages pages() const;

  /// What long work looks at.
  Cancellation& cancellation() { return cancellation_; }

  /// Reads the arguments and does the work of the verb they name; the exit code.
  /// @param team  that this process belongs to; none where it is alone
  int run(int argc, const char* const* argv, Team* team);

 private:
  int refuse(const std::exception& error, const std::string& given) const;

  std::unique_ptr<CLI::App> app_;
  Cancellation cancellation_;
  ExitCode work(const std::string& verb, Team* team) const;

  Verb::Chosen chosen_;
};

}  // namespace ramify::cli
