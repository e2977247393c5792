#include "claim_section.hpp"

#include <utility>

#include "verdict_words.hpp"
#include "verdicts.hpp"
#include <fmt/format.h>

namespace ramify {
namespace {

PageTone tone_of(Decision decision) {
  switch (decision) {
    case Decision::reproduced:
      return PageTone::good;
    case Decision::refuted:
      return PageTone::bad;
    case Decision::inconclusive:
      break;
  }
  return PageTone::open;
}

PageSection part_section(const Verdict& verdict) {
  const auto& [statement, basis] = verdict.finding;
  PageList facts{{fmt::format("Claimed in {}.", statement.source),
                  fmt::format("Convention: {}.", statement.convention),
                  fmt::format("Method: {}.", basis.method)}};
  if (statement.instead)
    facts.items.push_back(fmt::format("What holds instead: {}.", in_words({*statement.instead})));
  return {fmt::format("{}: {}: {}", statement.part, statement.text, to_string(verdict.decision)),
          {PageParagraph{how_reached(verdict)}, std::move(facts)},
          {},
          statement.part};
}

PageSection controls_section(const std::vector<Verdict>& verdicts) {
  PageSection section{"Negative controls", {}, {}};
  Table controls = control_table(verdicts);
  if (controls.rows() == 0)
    section.blocks.emplace_back(PageParagraph{
        "No other value is named that somebody might believe; wrong samplers and wrong laws are put "
        "before the same checks by the project's tests, which reject them."});
  else
    section.blocks.emplace_back(PageTable{
        "Values put in the theory's place, held against the same interval by the same rule: with a rival "
        "nothing may be reproduced. outside by: from the nearer end of the interval, also in its widths. "
        "power: how "
        "often it is not reproduced; an interval without chance gives the same verdict every time",
        std::move(controls)});
  return section;
}

PageSection repeat_section(const ClaimOnPage& of, const std::string& command) {
  std::string files = fmt::format("Its verdicts alone: claims/{}.csv", of.claim.id);
  if (!of.plots.empty())
    files += fmt::format("; the numbers of its pictures: claims/{}_points.csv", of.claim.id);
  return {"This claim again", {PageCommands{{command}}, PageParagraph{files + "."}}, {}};
}

/// Leads to the trees of its models.
PageTable tree_table(const std::vector<const SampleTree*>& trees) {
  PageTable on_page{"Trees of its models", Table({"model", "n", "seed"})};
  for (const SampleTree* tree : trees) {
    on_page.table.add(Row().texts({tree->model.text()}).whole(tree->n).whole(tree->seed));
    on_page.links.push_back(tree->anchor());
  }
  return on_page;
}

}  // namespace

PageTable verdicts_on_page(const std::vector<Verdict>& verdicts, std::string caption) {
  Table table(
      {"part", "verdict", "statement", "theory", "true value lies in", "evidence", "standing", "sampler"});
  PageTable on_page{std::move(caption), table};
  on_page.badges.column = "verdict";
  for (const Verdict& verdict : verdicts) {
    const auto& [statement, basis] = verdict.finding;
    on_page.table.add(
        Row().texts({statement.part, to_string(verdict.decision), statement.text,
                     theory_text(verdict.finding), interval_text(basis), to_string(basis.evidence),
                     to_string(basis.standing), sampler_text(verdict.sampler)}));
    on_page.links.push_back(statement.part);
    on_page.badges.tones.push_back(tone_of(verdict.decision));
  }
  return on_page;
}

PageSection claim_section(const ClaimOnPage& of, const std::string& command) {
  const std::string id(of.claim.id);
  PageSection section{fmt::format("{}: {}", id, of.claim.statement),
                      {PageParagraph{fmt::format("Source: {}.", of.claim.source)}},
                      {},
                      id,
                      id};
  if (of.verdicts.empty())
    section.blocks.emplace_back(PageParagraph{"None of its parts could be judged."});
  else
    section.blocks.emplace_back(verdicts_on_page(of.verdicts, fmt::format("The parts of {}", id)));
  for (const FiledPlot& plot : of.plots) section.blocks.push_back(figure_of(plot));
  if (!of.trees.empty()) section.blocks.emplace_back(tree_table(of.trees));
  for (const Verdict& verdict : of.verdicts) section.parts.push_back(part_section(verdict));
  section.parts.push_back(controls_section(of.verdicts));
  section.parts.push_back(repeat_section(of, command));
  return section;
}

}  // namespace ramify
