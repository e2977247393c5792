#include <memory>

#include "program_pages.hpp"
#include "session.hpp"
#include "verbs.hpp"

#include "ramify/core/nearest_name.hpp"

namespace ramify::cli {
namespace {

std::string page_of(const ProgramPages& pages, const std::string& what) {
  if (what == "man") return pages.man();
  if (what == "bash") return pages.bash();
  if (what == "zsh") return pages.zsh();
  throw Error("cannot describe the command line for '" + what + "'", "there is no such page",
              did_you_mean(what, {"man", "bash", "zsh"}) + "take man, bash or zsh");
}

}  // namespace

void add_describe(Program& program) {
  struct Options {
    std::string what;
    Output output;
  };
  auto options = std::make_shared<Options>();
  Verb verb =
      program.verb("describe", "The command line itself: as a man page, or as a completion for a shell");
  verb.option("what", options->what, "man, bash or zsh", Need::required);
  options->output.add_to(verb);
  verb.example("Example: ramify describe bash");
  verb.work([options, &program](const Cancellation&) {
    emit(page_of(program.pages(), options->what), options->output);
    return ExitCode::done;
  });
}

}  // namespace ramify::cli
