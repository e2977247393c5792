#include "ramify/dossier/commands.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/page/shell_word.hpp"

namespace ramify {
namespace {

/// A file as an argument: what begins with - is no option.
std::string file_word(const std::string& file) {
  return shell_word(file.size() > 1 && file.front() == '-' ? "./" + file : file);
}

std::string option(std::string_view name, const std::string& value) {
  return value.empty() ? "" : fmt::format(" {} {}", name, shell_word(value));
}

/// How the file was read.
std::string reading_options(const Subject& subject, const ReportRequest& request) {
  if (!subject.tree) return {};
  return option("--root", request.root) + option("--resolve", request.resolve);
}

}  // namespace

std::string draw_command(const Subject& subject, const ReportRequest& request) {
  const std::string which = subject.of > 1 ? fmt::format(" --which {}", subject.place) : "";
  return fmt::format("ramify draw --tree {}{}{} -o tree.svg", file_word(subject.file),
                     option("--root", request.root), which);
}

std::string measure_command(const Subject& subject, const ReportRequest& request, std::string_view options) {
  return fmt::format("ramify measure {}{}{}", file_word(subject.file), reading_options(subject, request),
                     options);
}

std::string horton_command(const Subject& subject, const ReportRequest& request, std::string_view families) {
  return fmt::format("ramify horton {}{} --model {} --seed {}", file_word(subject.file),
                     reading_options(subject, request), shell_word(families), request.seed);
}

std::string fit_command(const Subject& subject, const ReportRequest& request, std::string_view families) {
  return fmt::format("ramify fit {}{} --model {} --seed {}", file_word(subject.file),
                     reading_options(subject, request), shell_word(families), request.seed);
}

std::string test_command(const Subject& subject, const ReportRequest& request, std::string_view model) {
  return fmt::format("ramify test {}{} --model {} --replicates {} --seed {}", file_word(subject.file),
                     reading_options(subject, request), shell_word(model), request.replicates, request.seed);
}

std::string report_command(const ReportRequest& request) {
  std::vector<std::string> files, families;
  for (const auto& file : request.files) files.push_back(file_word(file));
  for (const Family* family : request.families) families.emplace_back(family->name);
  return fmt::format("ramify report {}{}{}{} --replicates {} --bootstrap {} --seed {} -o report.html",
                     fmt::join(files, " "), option("--root", request.root),
                     option("--resolve", request.resolve),
                     option("--model", fmt::format("{}", fmt::join(families, ","))), request.replicates,
                     request.bootstrap, request.seed);
}

}  // namespace ramify
