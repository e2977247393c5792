#include "ramify/dossier/report_page.hpp"

#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "ramify/core/version.hpp"
#include "ramify/dossier/commands.hpp"
#include "ramify/dossier/findings.hpp"
#include "ramify/dossier/plain_words.hpp"
#include "ramify/dossier/sections.hpp"

namespace ramify {
namespace {

std::string title_of(const ReportRequest& request) {
  std::vector<std::string> names;
  for (const std::string& file : request.files)
    names.push_back(file == "-" ? "standard input" : std::filesystem::path(file).filename().string());
  return fmt::format("Report on {}", listed(names));
}

std::vector<PageBlock> colophon_of(const ReportRequest& request) {
  std::vector<PageBlock> blocks;
  blocks.emplace_back(
      PageParagraph{fmt::format("Made by ramify {}, seed {}. The whole page again:", version, request.seed)});
  blocks.emplace_back(PageCommands{{report_command(request)}});
  return blocks;
}

/// The sections of one subject.
std::vector<PageSection> sections_of(const Subject& subject, const ReportRequest& request,
                                     const Cancellation& cancellation, Report& report) {
  const Findings findings = find_out(subject, request, cancellation);
  if (findings.fit && !findings.best) report.converged = false;
  std::vector<PageSection> sections{words_section(subject, findings)};
  if (subject.tree) sections.push_back(picture_section(subject, request, cancellation, report.warnings));
  sections.push_back(orders_section(subject, request, report.warnings));
  sections.push_back(ratios_section(subject, findings, request));
  sections.push_back(families_section(subject, findings, request));
  if (subject.tree && findings.best) sections.push_back(departures_section(subject, findings, request));
  return sections;
}

}  // namespace

Report report_page(const std::vector<Subject>& subjects, const ReportRequest& request,
                   const Cancellation& cancellation) {
  Report report{{title_of(request), {}, {}, colophon_of(request)}, {}, true};
  double done = 0;
  for (const Subject& subject : subjects) {
    std::vector<PageSection> sections = sections_of(subject, request, cancellation, report);
    if (subjects.size() == 1)
      report.page.sections = std::move(sections);
    else
      report.page.sections.push_back({subject.name, {}, std::move(sections)});
    if (request.progress) request.progress(++done, static_cast<double>(subjects.size()));
  }
  return report;
}

}  // namespace ramify
