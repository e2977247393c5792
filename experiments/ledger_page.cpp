#include "ledger_page.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "verdicts.hpp"
#include <fmt/format.h>

#include "ramify/core/version.hpp"
#include "ramify/page/shell_word.hpp"
#include "ramify/run/plan.hpp"
#include "ramify/text/remarks.hpp"

namespace ramify {
namespace {

std::string command_of(const Reproduction& reproduction, std::string_view claim) {
  return fmt::format("ramify reproduce --scale {}{}{}", reproduction.scale,
                     claim.empty() ? "" : " --claim " + shell_word(claim), reproduction.options);
}

PageSection trees_section(const std::vector<SampleTree>& trees) {
  PageSection section{
      "Sample trees",
      {PageParagraph{"The first tree of every model, of 100 internal nodes, as ramify sample "
                     "--no-graft grows it, in one form: radii by the cube root of the leaves, "
                     "lengths ten radii, Murray's angles; coloured by Horton-Strahler order."}},
      {},
      "trees",
      "Trees"};
  for (const SampleTree& tree : trees)
    section.parts.push_back(
        {tree.model.text(),
         {PagePicture{tree.svg, fmt::format("A tree of {} with {} internal nodes", tree.model.text(), tree.n),
                      fmt::format("{}, n = {}, seed {}, replicate 0", tree.model.text(), tree.n, tree.seed)},
          PageCommands{{tree.command()}}},
         {},
         tree.anchor()});
  return section;
}

std::vector<PageBlock> ledger_lead(const Reproduction& reproduction) {
  const auto& verdicts = reproduction.judged.verdicts;
  const auto number = [&](Decision decision) {
    return std::ranges::count(verdicts, decision, &Verdict::decision);
  };
  return {PageParagraph{
      fmt::format("What ramify {} finds of {} in {}, at the {} scale: {} reproduced, {} refuted, {} "
                  "inconclusive. Every number "
                  "below is made by the program from its configs and seeds, and every claim names the "
                  "command that repeats it.",
                  version, counted(verdicts.size(), "statement"),
                  counted(reproduction.claims.size(), "claim"), reproduction.scale,
                  number(Decision::reproduced), number(Decision::refuted), number(Decision::inconclusive))}};
}

PageSection glance_section(const Ledger::Judged& judged) {
  PageTable table = verdicts_on_page(judged.verdicts,
                                     "Every part of every claim; sampler: sampled means beside their exact "
                                     "laws, and the worst in standard errors");
  table.filters = {"verdict", "evidence"};
  PageSection section{"The ledger at a glance", {std::move(table)}, {}, "ledger", "Ledger"};
  if (judged.failures.empty()) return section;
  section.blocks.emplace_back(PageParagraph{"What could not be judged:"});
  section.blocks.emplace_back(PageList{judged.failures});
  return section;
}

PageSection reading_section() {
  return {
      "How to read it",
      {PageParagraph{
           "One rule judges every statement, and it has no tolerance. What is known of a number is an "
           "interval that holds its true value. It is reproduced where the interval contains the "
           "theory (of a bound: keeps it) and excludes every rival that the statement names, refuted "
           "where it excludes the theory (breaks the bound), inconclusive else."},
       PageList{{"evidence exact: laws or enumeration at finite n",
                 "evidence limit: exact laws at growing n, taken to the limit with a bound",
                 "evidence sampled: trees", "evidence fitted: the parameters of a model",
                 "evidence measured: trees of nature", "evidence published: printed numbers of a source",
                 "standing proved: nothing is left to believe but the error bounds of the computation",
                 "standing extrapolated: numbers of a few digits, and that they go on as they did",
                 "standing seen: what was seen, and no more",
                 "sampler: whether what draws the trees obeys the exact law; - where no trees are taken"}}},
      {},
      "reading",
      "How to read it"};
}

Table config_table(const std::vector<RunConfig>& configs) {
  Table table({"config", "claims", "seed", "cells", "trees"});
  for (const RunConfig& config : configs) {
    const Plan plan = make_plan(config);
    table.add(Row()
                  .texts({file_name(config), config.claim.value_or("none")})
                  .whole(config.seed)
                  .whole(plan.cells.size())
                  .whole(total_trees(plan)));
  }
  return table;
}

PageSection sources_section(const Reproduction& reproduction) {
  PageSection section{"Provenance", {}, {}, "provenance", "Provenance"};
  section.blocks.emplace_back(PageParagraph{fmt::format(
      "Made by ramify {}. Configs and seeds decide every number, and nothing else does; compiler, host, "
      "threads and times stand in the provenance.json of every run.",
      version)});
  if (reproduction.configs.empty()) {
    section.blocks.emplace_back(PageParagraph{"No trees were sampled: no config serves these claims."});
    return section;
  }
  section.blocks.emplace_back(PageTable{"The configs, whose trees hold the samplers against the laws",
                                        config_table(reproduction.configs)});
  for (const RunConfig& config : reproduction.configs)
    section.blocks.emplace_back(PageVerbatim{file_name(config), config.text});
  return section;
}

}  // namespace

std::vector<ClaimOnPage> claims_on_page(const Reproduction& reproduction,
                                        const std::vector<FiledPlot>& plots) {
  std::vector<ClaimOnPage> claims;
  for (const Claim* claim : reproduction.claims) {
    ClaimOnPage& of = claims.emplace_back(ClaimOnPage{*claim, {}, {}, trees_of(*claim, reproduction.trees)});
    std::ranges::copy_if(
        reproduction.judged.verdicts, std::back_inserter(of.verdicts),
        [&](const Verdict& verdict) { return claim_of(verdict.finding.statement.part) == claim->id; });
    std::ranges::copy_if(plots, std::back_inserter(of.plots),
                         [&](const FiledPlot& plot) { return claim_of(plot.named.stem) == claim->id; });
  }
  return claims;
}

Page ledger_page(const Reproduction& reproduction, const std::vector<ClaimOnPage>& claims) {
  Page page{"The ledger of claims",
            ledger_lead(reproduction),
            {glance_section(reproduction.judged), reading_section()},
            {PageParagraph{fmt::format("Made by ramify {}. The whole page again:", version)},
             PageCommands{{command_of(reproduction, reproduction.asked)}}}};
  for (const ClaimOnPage& of : claims)
    page.sections.push_back(claim_section(of, command_of(reproduction, of.claim.id)));
  if (!reproduction.trees.empty()) page.sections.push_back(trees_section(reproduction.trees));
  page.sections.push_back(sources_section(reproduction));
  return page;
}

}  // namespace ramify
