#pragma once

#include "ramify/core/cancellation.hpp"
#include "ramify/dossier/findings.hpp"
#include "ramify/page/page.hpp"

namespace ramify {

// The sections of a report, one function each. A picture that cannot be drawn is named as missing, with the
// reason, also among the warnings.

using Warnings = std::vector<std::string>;

PageSection words_section(const Subject& subject, const Findings& findings);
/// The tree, coloured by order; for trees alone. Throws Interrupted.
PageSection picture_section(const Subject& subject, const ReportRequest& request,
                            const Cancellation& cancellation, Warnings& warnings);
PageSection orders_section(const Subject& subject, const ReportRequest& request, Warnings& warnings);
/// Horton's ratios with their errors.
PageSection ratios_section(const Subject& subject, const Findings& findings, const ReportRequest& request);
PageSection families_section(const Subject& subject, const Findings& findings, const ReportRequest& request);
/// For trees with a best model alone.
PageSection departures_section(const Subject& subject, const Findings& findings,
                               const ReportRequest& request);

/// Nodes of the largest tree that is drawn into a page, which would else have many megabytes.
inline constexpr std::size_t most_pictured_nodes = 40'000;

}  // namespace ramify
