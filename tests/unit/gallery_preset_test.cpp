// Presets: files that say what is drawn; what is wrong in one is said with its place.
#include <filesystem>
#include <map>
#include <regex>
#include <sstream>

#include "support/error_of.hpp"
#include <gtest/gtest.h>

#include "ramify/gallery/preset_drawing.hpp"
#include "ramify/shape/place_limbs.hpp"
#include "ramify/tabulate/tree_batch.hpp"
#include "ramify/text/text_file.hpp"

namespace ramify {
namespace {

const std::filesystem::path folder = std::filesystem::path(RAMIFY_SOURCE_DIR) / "configs" / "draw";

constexpr const char* small = R"(title = "Small"
source = "nobody"
model = "bst"
n = 5
radius = { rule = "constant", c = 1 }
length = { rule = "constant", c = 10 }
deviation = { rule = "constant", angle = 30 }
)";

PicturePreset parsed(const std::string& text) {
  return parse_picture_preset(text, "small.toml");
}

std::string refusal(const std::string& text) {
  return test::error_of([&] { parsed(text); });
}

/// The small preset with one line in the place of another.
std::string with(const std::string& line, const std::string& instead) {
  std::string text = small;
  return text.replace(text.find(line), line.size(), instead);
}

TEST(PicturePreset, SaysWhatIsDrawn) {
  const PicturePreset preset = parsed(small);
  EXPECT_EQ(preset.name, "small");
  EXPECT_EQ(preset.title, "Small");
  ASSERT_EQ(preset.panels.size(), 1u);
  EXPECT_EQ(preset.panels[0].n, 5u);
  EXPECT_EQ(preset.panels[0].seed, 1996u);
  EXPECT_EQ(preset.panels[0].rules.main, MainChild::largest);
}

// The ends of branches are those of the straight ones, and the same tree has the same walks.
TEST(PicturePreset, AWalkLeavesTheFormAsItIs) {
  const std::string walk = "n = 50\nplane = { rule = \"random\" }";
  const auto shape_of = [&](const std::string& lines) {
    const PicturePanel panel = parsed(with("n = 5", lines)).panels[0];
    return panel_shape(panel, panel_tree(panel, Cancellation()).tree, Cancellation());
  };
  const Shape straight = shape_of(walk);
  const Shape walking = shape_of(walk + "\nwalk = { steps = 4, deviation = 0.1 }");
  EXPECT_TRUE(straight.bends.empty());
  ASSERT_EQ(walking.bends.size(), 3 * walking.limbs.size());
  for (std::size_t limb = 0; limb < straight.limbs.size(); ++limb) {
    EXPECT_EQ(walking.limbs[limb].start, straight.limbs[limb].start);
    EXPECT_EQ(walking.limbs[limb].end, straight.limbs[limb].end);
  }
  EXPECT_EQ(walking.bends, shape_of(walk + "\nwalk = { steps = 4, deviation = 0.1 }").bends);
  EXPECT_NE(walking.bends, shape_of(walk + "\nreplicate = 1\nwalk = { steps = 4, deviation = 0.1 }").bends);
}

TEST(PicturePreset, EveryStepOfAWalkIsAPiece) {
  const PicturePreset preset =
      parsed(std::string(small) + "[[panel]]\n[[panel]]\nwalk = { steps = 4, deviation = 0.1 }\n");
  EXPECT_EQ(expected_pieces(preset), 11 + 4 * 11);
}

TEST(PicturePreset, AJointAlongTheSidesFillsItsNotches) {
  const PicturePanel sides = parsed(with("n = 5", "n = 5\njoint = \"sides\"")).panels[0];
  EXPECT_EQ(sides.rules.joint, BranchJoint::sides);
  EXPECT_TRUE(sides.look.fills_notches);
  EXPECT_FALSE(parsed(with("n = 5", "n = 5\njoint = \"legs\"")).panels[0].look.fills_notches);
}

TEST(PicturePreset, PanelsInheritWhatTheyDoNotSay) {
  const PicturePreset preset =
      parsed(std::string(small) +
             "columns = 3\n[[panel]]\nn = 7\nview = \"top\"\n[[panel]]\nreplicate = 4\n"
             "look = { style = \"lines\", bark = \"#ff8000\" }\n");
  EXPECT_EQ(preset.columns, 3u);
  ASSERT_EQ(preset.panels.size(), 2u);
  EXPECT_EQ(preset.panels[0].n, 7u);
  EXPECT_NEAR(preset.panels[0].look.view.toward[1], 1, 1e-12);
  EXPECT_EQ(preset.panels[1].n, 5u);
  EXPECT_EQ(preset.panels[1].replicate, 4u);
  EXPECT_EQ(preset.panels[1].look.style, TreeLook::Style::lines);
  EXPECT_NEAR(preset.panels[1].look.bark[1], 128 / 255.0, 1e-12);
}

struct Refusal {
  std::string line, instead, message;
  friend std::ostream& operator<<(std::ostream& out, const Refusal& refusal) {
    return out << testing::PrintToString(refusal.instead);
  }
};

class WrongPreset : public testing::TestWithParam<Refusal> {};

TEST_P(WrongPreset, IsRefusedWithItsPlace) {
  const auto& [line, instead, message] = GetParam();
  EXPECT_NE(refusal(with(line, instead)).find(message), std::string::npos) << refusal(with(line, instead));
}

INSTANTIATE_TEST_SUITE_P(
    All, WrongPreset,
    testing::Values(
        Refusal{"n = 5", "sise = 5", "small.toml:4:1: unknown key 'sise'"},
        Refusal{"n = 5", "n = 5\nmirors = true", "did you mean mirrors"},
        Refusal{"n = 5\n", "", "small.toml: no 'n'"}, Refusal{"n = 5", "n = -5", "small.toml:4:5: n = -5"},
        Refusal{"\"bst\"", "\"bts\"", "small.toml:3:9: unknown model 'bts'"},
        Refusal{"title = \"Small\"\n", "", "no 'title'"},
        Refusal{"length = { rule = \"constant\"", "length = { rule = \"constnt\"",
                "small.toml:6:19: no rule 'constnt' for a length"},
        Refusal{"length = { rule = \"constant\"", "length = { rule = \"constnt\"", "did you mean constant"},
        Refusal{"length = { rule = \"constant\", c = 10", "length = { rule = \"constant\", k = 10",
                "unknown key 'k' (the rule constant has rule, c)"},
        Refusal{"length = { rule = \"constant\", c = 10", "length = { rule = \"constant\"",
                "the rule constant without c"},
        Refusal{"c = 10", "c = -1", "c = -1 (of the rule constant it lies from 0 to inf)"},
        Refusal{"c = 10", "c = nan", "c = nan"},
        Refusal{"angle = 30", "angle = 300", "angle = 300 (of the rule constant it lies from -180 to 180)"},
        Refusal{"length = { rule = \"constant\", c = 10 }", "length = 10",
                "length is a whole number (it must be a table"},
        Refusal{"n = 5", "n = 5\nview = \"frnt\"", "small.toml:5:8: view 'frnt'"},
        Refusal{"n = 5", "n = 5\nlook = { style = \"star\" }", "no such style of a form"},
        Refusal{"n = 5", "n = 5\nlook = { bark = \"brown\" }", "a colour is # and six digits"},
        Refusal{"n = 5", "n = 5\nlook = { leaves = { apex = \"round\" } }", "did you mean rounded"},
        Refusal{"n = 5", "n = 5\nlook = { leaves = { margin = \"lobbed\" } }", "did you mean lobed"},
        Refusal{"n = 5", "n = 5\nlook = { leaves = { margin = \"lobed\", apex = \"acute\" } }",
                "a lobed leaf with an apex or a base"},
        Refusal{"n = 5", "n = 5\nmain = \"bigest\"", "main = \"bigest\""},
        Refusal{"n = 5", "n = 5\nwalk = { steps = 1, deviation = 0.1 }", "steps = 1"},
        Refusal{"n = 5", "n = 5\nwalk = { steps = 8 }", "small.toml:5:8: half a walk"},
        Refusal{"n = 5", "n = 5\nwalk = { steps = 8, deviaton = 1 }", "did you mean deviation"},
        Refusal{"n = 5", "n = 5\ntropism = [{ rule = \"pull\" }]", "the rule pull without strength"},
        Refusal{"title", "title =", "this is not TOML"}),
    [](const auto& refusal) { return "Case" + std::to_string(refusal.index); });

TEST(PicturePreset, ChangesGoToEveryPanel) {
  PicturePreset preset = parsed(std::string(small) + "[[panel]]\nn = 7\n[[panel]]\nn = 9\n");
  PresetChange changes;
  changes.n = 20;
  changes.seed = 3;
  changes.replicate = 5;
  changes.view = "top";
  changes.style = "bars";
  changes.color_by = "order";
  change(preset, changes);
  for (const PicturePanel& panel : preset.panels) {
    EXPECT_EQ(panel.n, 20u);
    EXPECT_EQ(panel.seed, 3u);
    EXPECT_EQ(panel.replicate, 5u);
    EXPECT_EQ(panel.look.style, TreeLook::Style::bars);
    EXPECT_TRUE(panel.look.by_order);
    EXPECT_NEAR(panel.look.view.toward[1], 1, 1e-12);
  }
  EXPECT_NE(test::error_of([&] { show_in_sheet_views(preset); }).find("it shows 2 trees"), std::string::npos);
  PicturePreset one = parsed(small);
  show_in_sheet_views(one);
  EXPECT_EQ(one.panels.size(), 4u);
  EXPECT_EQ(one.panels[1].caption, "oblique");
}

TEST(PicturePreset, TheTreeIsThatOfSample) {
  PicturePreset preset = parsed(with("n = 5", "n = 200\nseed = 8\nreplicate = 3"));
  const TreeBatch batch{Model::parse("bst"), 200, 8, 1, false};
  EXPECT_EQ(panel_tree(preset.panels[0], Cancellation()).tree, batch.grown(3, 4, Cancellation())[0].tree);
  preset.panels[0].replicate = 4;
  EXPECT_NE(panel_tree(preset.panels[0], Cancellation()).tree, batch.grown(3, 4, Cancellation())[0].tree);
}

TEST(PicturePreset, AnUnknownNameIsRefusedWithTheNearest) {
  EXPECT_NE(test::error_of([] { find_picture_preset(folder, "aple_life"); }).find("did you mean apple_life"),
            std::string::npos);
  EXPECT_NE(
      test::error_of([] { find_picture_preset("nowhere", "apple_life"); }).find("no presets in 'nowhere'"),
      std::string::npos);
}

/// The file without what only says what it is.
std::string rules_of(const std::string& text) {
  std::istringstream lines(text);
  std::string rules;
  for (std::string line; std::getline(lines, line);)
    if (!std::regex_search(line, std::regex("^(title|source|note|caption) ="))) rules += line + '\n';
  return rules;
}

TEST(Presets, AreManyAndNoTwoTheSameButForTheName) {
  std::map<std::string, std::string> seen;
  for (const std::string& name : picture_preset_names(folder)) {
    const std::string text = read_text_file(folder / (name + ".toml"));
    const auto [other, is_new] = seen.emplace(rules_of(text), name);
    EXPECT_TRUE(is_new) << name << " is " << other->second;
  }
  EXPECT_GE(seen.size(), 40u);
}

class EveryPreset : public testing::TestWithParam<std::string> {};

// Small trees of the same rules: whatever a preset asks for goes together.
TEST_P(EveryPreset, GivesAForm) {
  const PicturePreset preset = find_picture_preset(folder, GetParam());
  EXPECT_FALSE(preset.source.empty());
  for (PicturePanel panel : preset.panels) {
    if (panel.model.is_split()) panel.n = std::min<Size>(panel.n, 60);
    const RecordedTree tree = panel_tree(panel, Cancellation());
    const Shape shape = panel_shape(panel, tree.tree, Cancellation());
    EXPECT_EQ(shape.limbs.size(), tree.tree.node_count());
    EXPECT_GT(shape.limbs[0].end[1], 0);
  }
}

INSTANTIATE_TEST_SUITE_P(All, EveryPreset, testing::ValuesIn(picture_preset_names(folder)),
                         [](const auto& name) { return name.param; });

// docs/draw.md is where a rule is looked up.
TEST(Rules, AreAllInTheDocumentation) {
  const std::string page = read_text_file(std::filesystem::path(RAMIFY_SOURCE_DIR) / "docs" / "draw.md");
  const auto expect_named = [&](const char* heading, const auto& rules) {
    const auto section = page.find(heading);
    ASSERT_NE(section, std::string::npos) << heading;
    for (const auto& rule : rules) {
      const auto row = page.find("| `" + std::string(rule.name) + "` |", section);
      ASSERT_NE(row, std::string::npos) << rule.name;
      const std::string line = page.substr(row, page.find('\n', row) - row);
      for (const auto& constant : rule.constants)
        EXPECT_NE(line.find("`" + std::string(constant.name)), std::string::npos)
            << rule.name << ' ' << constant.name;
    }
  };
  expect_named("### Radius and length", extent_rules());
  expect_named("### Deviation", deviation_rules());
  expect_named("### Plane", plane_rules());
  expect_named("### Tropism", tropism_rules());
}

}  // namespace
}  // namespace ramify
