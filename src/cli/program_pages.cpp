#include "program_pages.hpp"

#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/core/version.hpp"

namespace ramify::cli {
namespace {

std::vector<const CLI::App*> verbs_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

/// "-o", "--output" of an option; nothing of what is known by its place.
std::vector<std::string> flags_of(const CLI::Option& option) {
  std::vector<std::string> flags;
  for (const auto& name : option.get_snames()) flags.push_back("-" + name);
  for (const auto& name : option.get_lnames()) flags.push_back("--" + name);
  return flags;
}

std::vector<std::string> all_flags(const CLI::App& verb) {
  std::vector<std::string> all;
  for (const CLI::Option* option : verb.get_options())
    for (auto& flag : flags_of(*option)) all.push_back(std::move(flag));
  return all;
}

bool has_value(const CLI::Option& option) {
  return option.get_items_expected_max() > 0;
}

/// As troff wants a text: no line begins with a dot or a quote, and a - is one that can be copied.
std::string troff(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if ((c == '.' || c == '\'') && (safe.empty() || safe.back() == '\n')) safe += "\\&";
    if (c == '\\')
      safe += "\\e";
    else if (c == '-')
      safe += "\\-";
    else
      safe += c;
  }
  return safe;
}

std::string man_entry(const CLI::Option& option) {
  const auto flags = flags_of(option);
  std::string head = flags.empty() ? option.get_name() : fmt::format("{}", fmt::join(flags, ", "));
  if (!flags.empty() && has_value(option)) head += " VALUE";
  std::string text = option.get_description();
  if (const std::string value = option.get_default_str(); !value.empty())
    text += fmt::format(" (if left out: {})", value);
  return fmt::format(".TP\n.B {}\n{}\n", troff(head), troff(text));
}

/// In single quotes of a shell, and of zsh's _arguments, where [ ] and : have a meaning.
std::string zsh_text(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') safe += '\\';
    if (c == '\'')
      safe += "'\\''";
    else
      safe += c;
  }
  return safe;
}

std::vector<std::string> zsh_arguments(const CLI::App& verb) {
  std::vector<std::string> lines;
  for (const CLI::Option* option : verb.get_options())
    for (const auto& flag : flags_of(*option))
      lines.push_back(fmt::format("'*{}[{}]{}'", flag, zsh_text(option->get_description()),
                                  has_value(*option) ? ":value:_files" : ""));
  lines.emplace_back("'*:file:_files'");
  return lines;
}

}  // namespace

std::string ProgramPages::man() const {
  std::string page = fmt::format(
      ".TH RAMIFY 1 \"\" \"ramify {}\"\n.SH NAME\nramify \\- {}\n.SH SYNOPSIS\n.B ramify\nVERB [OPTION]...\n"
      ".SH DESCRIPTION\n{}\n",
      version, "a statistical laboratory for random branching structures",
      "Grows random trees, measures them, holds them against exact finite\\-size laws and against theorems, "
      "and fits models to measured trees.");
  for (const CLI::App* verb : verbs_of(*app_)) {
    page += fmt::format(".SH RAMIFY {}\n{}.\n", troff(verb->get_name()), troff(verb->get_description()));
    for (const CLI::Option* option : verb->get_options()) page += man_entry(*option);
    page += fmt::format(".PP\n{}\n", troff(verb->get_footer()));
  }
  return page +
         ".SH EXIT STATUS\n0 done; 1 a check failed; 2 refused, with one line on standard error; 3 a fit did "
         "not converge; 130 and 143 stopped by Ctrl\\-C and SIGTERM; 141 nobody reads the output.\n";
}

std::string ProgramPages::bash() const {
  std::vector<std::string> names;
  std::string cases;
  for (const CLI::App* verb : verbs_of(*app_)) {
    names.push_back(verb->get_name());
    cases += fmt::format("    {}) options='{}' ;;\n", verb->get_name(), fmt::join(all_flags(*verb), " "));
  }
  return fmt::format(
      "# bash completion of ramify; made by ramify describe bash\n"
      "_ramify() {{\n"
      "  local word=${{COMP_WORDS[COMP_CWORD]}} options=\n"
      "  if ((COMP_CWORD == 1)); then\n"
      "    COMPREPLY=($(compgen -W '{} --help --version' -- \"$word\"))\n"
      "    return\n"
      "  fi\n"
      "  case ${{COMP_WORDS[1]}} in\n{}  esac\n"
      "  if [[ $word == -* ]]; then\n"
      "    COMPREPLY=($(compgen -W \"$options\" -- \"$word\"))\n"
      "  else\n"
      "    COMPREPLY=($(compgen -f -- \"$word\"))\n"
      "  fi\n"
      "}}\n"
      "complete -o filenames -F _ramify ramify\n",
      fmt::join(names, " "), cases);
}

std::string ProgramPages::zsh() const {
  std::string names, cases;
  for (const CLI::App* verb : verbs_of(*app_)) {
    names += fmt::format("    '{}:{}'\n", verb->get_name(), zsh_text(verb->get_description()));
    cases += fmt::format("    {})\n      _arguments {} ;;\n", verb->get_name(),
                         fmt::join(zsh_arguments(*verb), " \\\n        "));
  }
  return fmt::format(
      "#compdef ramify\n# zsh completion of ramify; made by ramify describe zsh\n"
      "local -a verbs=(\n{}  )\n"
      "if ((CURRENT == 2)); then\n  _describe verb verbs\n  return\nfi\n"
      "local verb=$words[2]\nshift words\n((CURRENT--))\n"
      "case $verb in\n{}esac\n",
      names, cases);
}

}  // namespace ramify::cli
