#include "ramify/gallery/rules_reader.hpp"

#include <array>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/core/find_named.hpp"

namespace ramify::detail {
namespace {

constexpr Expected rule_wanted{"a table with a rule and its constants",
                               "length = { rule = \"radius_power\", c = 10 }"};
constexpr Expected name_wanted{"the name of a rule", "rule = \"constant\""};
constexpr Expected tropisms_wanted{"a list of tables",
                                   "tropism = [{ rule = \"lean\", strength = 0.2, y = 1 }]"};
constexpr Expected azimuths_wanted{"a list of degrees", "azimuths = [0, 120, 240]"};
constexpr Expected word_wanted{"a word", "main = \"largest\""};
constexpr Expected switch_wanted{"true or false", "mirrors = true"};

double read_constant(const TomlTable& table, const TomlValue& rule, std::string_view name,
                     const RuleConstant& constant) {
  const std::string example = fmt::format("{} = 1", constant.name);
  const auto value = table.find(constant.name);
  if (!value) {
    if (constant.otherwise) return *constant.otherwise;
    rule.fail(fmt::format("the rule {} without {}", name, constant.name), "it has no value of its own",
              fmt::format("add {}", example));
  }
  return read_between(*value, constant.least, constant.most, {"a number", example},
                      fmt::format("of the rule {} ", name));
}

template <class Rule>
Rule read_rule(const TomlValue& value, const std::vector<RuleInfo<Rule>>& all, std::string_view kind) {
  const TomlTable table(value.file(), value.table(rule_wanted));
  const auto name = table.find("rule");
  if (!name) value.fail(fmt::format("{} without a rule", kind), "a table names one", "add rule = \"...\"");
  const std::string text = name->text(name_wanted);
  std::vector<std::string> known;
  for (const auto& info : all) known.emplace_back(info.name);
  const auto info = std::ranges::find(all, text, &RuleInfo<Rule>::name);
  if (info == all.end())
    name->fail(fmt::format("no rule '{}' for a {}", text, kind),
               fmt::format("there are {}", fmt::join(known, ", ")),
               did_you_mean(text, known) + "take one of these");
  std::vector<std::string_view> keys{"rule"};
  for (const auto& constant : info->constants) keys.push_back(constant.name);
  table.require_known(fmt::format("the rule {}", info->name), keys);
  std::vector<double> constants;
  for (const auto& constant : info->constants)
    constants.push_back(read_constant(table, value, info->name, constant));
  return info->make(constants);
}

/// The choice that a key's word names, the first where there is no such key.
template <class Choice, std::size_t count>
Choice read_choice(const FindKey& find, std::string_view key,
                   const std::array<std::pair<std::string_view, Choice>, count>& choices) {
  const auto value = find(key);
  if (!value) return choices.front().second;
  const std::string text = value->text(word_wanted);
  std::vector<std::string> known;
  for (const auto& [name, choice] : choices) {
    if (text == name) return choice;
    known.emplace_back(name);
  }
  value->fail(fmt::format("{} = \"{}\"", key, text), fmt::format("it is one of {}", fmt::join(known, ", ")),
              did_you_mean(text, known) + "take one of these");
}

bool read_switch(const FindKey& find, std::string_view key) {
  const auto value = find(key);
  return value && value->boolean(switch_wanted);
}

}  // namespace

TomlValue require(const FindKey& find, std::string_view file, std::string_view key, std::string_view why) {
  if (auto value = find(key)) return *std::move(value);
  throw error_at({std::string(file), 0, 0}, fmt::format("no '{}'", key), why,
                 "add it; docs/draw.md has an example");
}

double read_between(const TomlValue& value, double least, double most, const Expected& expected,
                    std::string_view of) {
  const double number = value.real(expected);
  if (number >= least && number <= most) return number;
  value.fail(fmt::format("{} = {:g}", value.key(), number),
             fmt::format("{}it lies from {:g} to {:g}", of, least, most), "take a number in between");
}

ShapeRules read_rules(std::string_view file, const FindKey& find) {
  const auto required = [&](std::string_view key) {
    return require(find, file, key, "a form needs radius, length and deviation");
  };
  using enum MainChild;
  constexpr std::array<std::pair<std::string_view, MainChild>, 3> mains{
      {{"largest", largest}, {"first", first}, {"highest_order", highest_order}}};
  constexpr std::array<std::pair<std::string_view, Arrangement>, 3> arrangements{
      {{"coplanar", Arrangement::coplanar},
       {"alternating", Arrangement::alternating},
       {"whorl", Arrangement::whorl}}};
  constexpr std::array<std::pair<std::string_view, BranchJoint>, 3> joints{
      {{"centre", BranchJoint::centre}, {"legs", BranchJoint::legs}, {"sides", BranchJoint::sides}}};
  ShapeRules rules{read_rule(required("radius"), extent_rules(), "radius"),
                   read_rule(required("length"), extent_rules(), "length"),
                   read_rule(required("deviation"), deviation_rules(), "deviation")};
  if (const auto plane = find("plane")) rules.plane = read_rule(*plane, plane_rules(), "plane");
  if (const auto tropisms = find("tropism"))
    for (const auto& tropism : tropisms->elements(tropisms_wanted))
      rules.tropisms.push_back(read_rule(tropism, tropism_rules(), "tropism"));
  rules.arrangement = read_choice(find, "arrangement", arrangements);
  if (const auto azimuths = find("azimuths")) {
    for (const auto& azimuth : azimuths->elements(azimuths_wanted))
      rules.azimuths.push_back(azimuth.real(azimuths_wanted));
    rules.arrangement = Arrangement::turned;
  }
  rules.joint = read_choice(find, "joint", joints);
  rules.main = read_choice(find, "main", mains);
  rules.mirrors = read_switch(find, "mirrors");
  rules.foreshortens = read_switch(find, "foreshortens");
  return rules;
}

}  // namespace ramify::detail
