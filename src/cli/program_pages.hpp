#pragma once

#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): theirs
class App;
}  // namespace CLI

namespace ramify::cli {

/// The command line as other programs read it: made from the declared verbs and options, so that they never
/// tell another story than --help.
class ProgramPages {
 public:
  explicit ProgramPages(const CLI::App& app) : app_(&app) {}

  /// Of section 1, in troff's man macros.
  std::string man() const;
  /// A completion of verbs and options, and of file names where a value is wanted.
  std::string bash() const;
  std::string zsh() const;

 private:
  const CLI::App* app_;
};

}  // namespace ramify::cli
