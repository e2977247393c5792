#include "ramify/dossier/sections.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/dossier/commands.hpp"
#include "ramify/dossier/plain_words.hpp"
#include "ramify/draw/drawing_file.hpp"
#include "ramify/draw/node_link.hpp"
#include "ramify/fit/model_fit_table.hpp"
#include "ramify/io/readable.hpp"
#include "ramify/measure/horton_plot.hpp"
#include "ramify/measure/measure_tables.hpp"
#include "ramify/report/picture_file.hpp"
#include "ramify/text/remarks.hpp"

namespace ramify {
namespace {

constexpr unsigned leaf_order = 1;  // as in `measure`

PageBlock missing_picture(const std::string& why, const Subject& subject, Warnings& warnings) {
  warnings.push_back(fmt::format("{}: no picture: {}", subject.name, why));
  return PageParagraph{fmt::format("Picture missing: {}.", why)};
}

PagePicture picture_of(const RecordedTree& tree, const Subject& subject, const Cancellation& cancellation) {
  const NodeLinkStyle style{NodeLinkStyle::Form::dendrogram, leaf_order, !has_drawable_lengths(tree)};
  const auto& streams = subject.measured.orders.streams;
  const std::string scale = style.same_lengths ? "every branch as long as another" : "branches to scale";
  return {
      svg_of(node_link_diagram(tree, style), cancellation),
      fmt::format(
          "Node-link diagram with the root at the left: {}, {} from root to tips, coloured and widened by "
          "order 1 to {}",
          counted(streams.front(), "tip"), scale, streams.size()),
      fmt::format(
          "The tree: {}; colour and width are the Horton-Strahler order of the node that a branch leads to.",
          scale)};
}

std::string horton_alternative(const MeasuredOrders& orders) {
  std::vector<std::string> means;
  if (!orders.mean_lengths.empty()) means.emplace_back("mean length");
  if (!orders.mean_radii.empty()) means.emplace_back("mean radius");
  return fmt::format("Horton diagram: on a logarithmic axis {} streams of orders 1 to {}{}{}",
                     fmt::join(orders.streams, ", "), orders.streams.size(),
                     means.empty() ? "" : ", with their ", listed(means));
}

std::vector<std::string> names_of(const std::vector<const Family*>& families) {
  std::vector<std::string> names;
  for (const Family* family : families) names.emplace_back(family->name);
  return names;
}

/// Of the fits, what the table has no column for.
PageList fit_notes(const Findings& findings) {
  PageList notes;
  for (const FamilyFit& fit : findings.fit->fits)
    if (!fit.note.empty()) notes.items.push_back(fmt::format("{}: {}", fit.family->name, fit.note));
  if (!findings.left_out.empty())
    notes.items.push_back(fmt::format("Not fitted: {}, {}.", listed(names_of(findings.left_out)),
                                      findings.fit->observable == "tree"
                                          ? "for which the tree is too small"
                                          : "which take minutes from counts; --model names what is fitted"));
  return notes;
}

Table departures_table(const Findings& findings, std::uint64_t trees) {
  Table table(
      {"statistic", "of the tree", "expected", "standard deviations off", "p", "adjusted p", "known by"});
  for (const ComparedStatistic& of : findings.compared)
    table.add(Row()
                  .text(of.column.name())
                  .summary(of.observed)
                  .summary(of.expected)
                  .significant(of.effect(), 3)
                  .text(fmt::format("{}{:.2g}", of.is_bound ? "< " : "", of.p_value))
                  .significant(of.adjusted_p, 2)
                  .text(of.exact ? "exact law" : fmt::format("{} trees", trees)));
  return table;
}

}  // namespace

PageSection words_section(const Subject& subject, const Findings& findings) {
  PageSection section{"In plain words", {}, {}};
  section.blocks.emplace_back(
      PageParagraph{fmt::format("{}", fmt::join(plain_words(subject, findings), " "))});
  if (!subject.remarks.empty()) {
    section.blocks.emplace_back(PageParagraph{"What was remarked in reading:"});
    section.blocks.emplace_back(PageList{subject.remarks});
  }
  return section;
}

PageSection picture_section(const Subject& subject, const ReportRequest& request,
                            const Cancellation& cancellation, Warnings& warnings) {
  const RecordedTree& tree = subject.as_recorded ? *subject.as_recorded : *subject.tree;
  PageSection section{"Picture", {}, {}};
  if (tree.tree.node_count() > most_pictured_nodes)
    section.blocks.push_back(missing_picture(
        fmt::format(
            "a page shows trees of {} nodes at most, this has {}; the command draws it, as PNG if need be",
            most_pictured_nodes, tree.tree.node_count()),
        subject, warnings));
  else
    section.blocks.emplace_back(picture_of(tree, subject, cancellation));
  const bool is_forced = !tree.lengths.empty() && !has_drawable_lengths(tree);
  section.blocks.emplace_back(
      PageCommands{{draw_command(subject, request) + (is_forced ? " --same-lengths" : "")}});
  return section;
}

PageSection orders_section(const Subject& subject, const ReportRequest& request, Warnings& warnings) {
  PageSection section{"Orders", {}, {}};
  const MeasuredOrders& orders = subject.measured.orders;
  const Table all = readable(orders_table({orders}, leaf_order));
  section.blocks.emplace_back(
      PageTable{"By Horton-Strahler order, 1 at the tips; lengths and radii in the unit of the file",
                all.selected({"order", "streams", "nodes", "mean_length", "mean_radius"})});
  const DrawnPlot plot = draw_plot(horton_plot({orders}, leaf_order), PictureFormat::svg);
  if (plot.bytes.empty())
    section.blocks.push_back(missing_picture(plot.why_not, subject, warnings));
  else
    section.blocks.emplace_back(PagePicture{plot.bytes, horton_alternative(orders), "Horton diagram"});
  section.blocks.emplace_back(PageCommands{{measure_command(subject, request, " --plot horton.svg")}});
  if (request.resolve == "random" && request.seed != 1996)
    section.blocks.emplace_back(PageParagraph{
        "Forks were resolved at random by the seed of this report; measure draws them by seed 1996."});
  return section;
}

PageSection families_section(const Subject& subject, const Findings& findings, const ReportRequest& request) {
  PageSection section{"Which model is it like?", {}, {}};
  if (!findings.fit) {
    section.blocks.emplace_back(PageParagraph{findings.why_no_fit});
    return section;
  }
  const FittedDatum& datum = *findings.fit;
  section.blocks.emplace_back(PageTable{
      fmt::format("Families of models, the best first: n = {} internal nodes, fitted from {}. AIC - best: "
                  "{:g} and less "
                  "is as good, more than {:g} is out. misfit p: of trees of the fitted model so many lie as "
                  "far from it",
                  datum.n, datum.used, as_good, is_out),
      model_fit_lines(datum)});
  if (PageList notes = fit_notes(findings); !notes.items.empty())
    section.blocks.emplace_back(std::move(notes));
  PageCommands commands{
      {fit_command(subject, request, fmt::format("{}", fmt::join(names_of(findings.fitted), ",")))}};
  if (const FamilyFit& best = datum.fits.front(); best.goodness.trees > 0)
    commands.lines.push_back(fit_command(subject, request, best.family->name) +
                             fmt::format(" --bootstrap {}", best.goodness.trees));
  section.blocks.emplace_back(std::move(commands));
  return section;
}

PageSection departures_section(const Subject& subject, const Findings& findings,
                               const ReportRequest& request) {
  PageSection section{"Where it departs from the best model", {}, {}};
  const std::string& model = findings.best->text();
  if (findings.compared.empty()) {
    section.blocks.emplace_back(PageParagraph{findings.why_not_compared});
  } else {
    section.blocks.emplace_back(PageTable{
        fmt::format("The tree beside trees of {} of its size; orders count from 0 at the tips", model),
        readable(departures_table(findings, request.replicates))});
    section.blocks.emplace_back(
        PageParagraph{"Adjusted p allows for the number of statistics (Holm 1979): below 0.05 the tree "
                      "departs. The model was fitted "
                      "to this very tree, so p-values are rather too large."});
  }
  section.blocks.emplace_back(PageCommands{{test_command(subject, request, model)}});
  return section;
}

}  // namespace ramify
