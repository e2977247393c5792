#pragma once

#include <string>
#include <string_view>

#include "ramify/dossier/findings.hpp"
#include "ramify/dossier/report_request.hpp"

namespace ramify {

// The commands that repeat a report's numbers, for a shell.

/// ramify draw: the picture of the tree.
std::string draw_command(const Subject& subject, const ReportRequest& request);
/// ramify measure with these options: orders, summary, Horton diagram.
std::string measure_command(const Subject& subject, const ReportRequest& request, std::string_view options);
/// ramify horton with errors by the best of these families.
std::string horton_command(const Subject& subject, const ReportRequest& request, std::string_view families);
/// ramify fit of these families.
std::string fit_command(const Subject& subject, const ReportRequest& request, std::string_view families);
/// ramify test: the tree beside trees of a model.
std::string test_command(const Subject& subject, const ReportRequest& request, std::string_view model);
/// ramify report: the whole page.
std::string report_command(const ReportRequest& request);

}  // namespace ramify
