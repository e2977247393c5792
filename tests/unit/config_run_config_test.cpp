#include <filesystem>

#include "support/error_of.hpp"
#include <gtest/gtest.h>

#include "ramify/config/run_config.hpp"
#include "ramify/statistic/registry.hpp"
#include "ramify/text/text_file.hpp"

namespace ramify {
namespace {

using Sizes = std::vector<Size>;

constexpr std::string_view good =
    "models = [\"bst\"]\n"
    "n = [10, 20]\n"
    "replicates = 5\n"
    "statistics = [\"strahler\"]\n";

/// The good config with one of its four lines replaced.
std::string with_line(std::size_t line, std::string_view text) {
  std::string result;
  std::string_view rest = good;
  for (std::size_t i = 1; !rest.empty(); ++i) {
    const auto end = rest.find('\n') + 1;
    result += i == line ? std::string(text) + "\n" : std::string(rest.substr(0, end));
    rest.remove_prefix(end);
  }
  return result;
}

std::string config_error(std::string_view text) {
  return test::error_of([&] { parse_run_config(text, "c.toml"); });
}

std::vector<std::string> texts(const std::vector<Model>& models) {
  std::vector<std::string> names;
  for (const auto& model : models) names.push_back(model.text());
  return names;
}

TEST(RunConfig, ReadsEveryKey) {
  const RunConfig config = parse_run_config(R"toml(
claim      = "C20"
seed       = 7
models     = ["bst", "patricia(1/4.35)"]
n          = { from = 100, to = 10_000, count = 3 }
replicates = { to_1e3 = 2000, above = 100 }
statistics = ["strahler", "streams", "height"]
graft      = false
)toml",
                                            "c.toml");
  EXPECT_EQ(config.path, "c.toml");
  EXPECT_EQ(config.claim, "C20");
  EXPECT_EQ(config.seed, 7u);
  EXPECT_FALSE(config.graft);
  EXPECT_TRUE(config.statistics.contains(statistic::streams));
  EXPECT_EQ(config.statistics.chosen().size(), 3u);
  ASSERT_EQ(config.groups.size(), 1u);
  EXPECT_EQ(texts(config.groups[0].models), (std::vector<std::string>{"bst", "patricia(1/4.35)"}));
  EXPECT_EQ(config.groups[0].sizes, (Sizes{100, 1000, 10000}));
  EXPECT_EQ(config.groups[0].replicates.count(1000), 2000u);
  EXPECT_EQ(config.groups[0].replicates.count(10000), 100u);
}

TEST(RunConfig, Defaults) {
  const RunConfig config = parse_run_config(good, "c.toml");
  EXPECT_EQ(config.claim, std::nullopt);
  EXPECT_EQ(config.seed, 1996u);
  EXPECT_TRUE(config.graft);
  EXPECT_EQ(config.groups.at(0).replicates.count(max_size), 5u);
}

TEST(RunConfig, CellsInheritWhatTheyDoNotSay) {
  const RunConfig config = parse_run_config(R"toml(
replicates = 50
n = [10]
statistics = ["height"]
[[cells]]
models = ["bst", "catalan"]
[[cells]]
models = ["patricia(0.23)"]
n = { from = 100, factor = "1/0.23", count = 3 }
[[cells]]
models = ["bst"]
n = [20]
replicates = { above = 3 }
)toml",
                                            "c.toml");
  ASSERT_EQ(config.groups.size(), 3u);
  EXPECT_EQ(config.groups[0].sizes, (Sizes{10}));
  EXPECT_EQ(config.groups[0].replicates.count(10), 50u);
  EXPECT_EQ(config.groups[1].sizes, (Sizes{100, 435, 1890}));
  EXPECT_EQ(config.groups[1].replicates.count(435), 50u);
  EXPECT_EQ(config.groups[2].sizes, (Sizes{20}));
  EXPECT_EQ(config.groups[2].replicates.count(20), 3u);
}

TEST(RunConfig, WholeNumbersMayBeWrittenWithAnExponent) {
  EXPECT_EQ(parse_run_config(with_line(2, "n = [1e2, 1e6]"), "c.toml").groups[0].sizes,
            (Sizes{100, 1'000'000}));
  EXPECT_EQ(parse_run_config(with_line(2, "n = [4611686018427387904]"), "c.toml").groups[0].sizes,
            (Sizes{max_size}));
}

struct Refusal {
  std::string text;
  std::string start;  ///< of the message

  friend std::ostream& operator<<(std::ostream& out, const Refusal& refusal) { return out << refusal.start; }
};

class Refused : public testing::TestWithParam<Refusal> {};

TEST_P(Refused, InOneLineWithThePlace) {
  const std::string message = config_error(GetParam().text);
  EXPECT_TRUE(message.starts_with(GetParam().start)) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos);
  const auto why = message.find(" ("), remedy = message.find("): ");
  EXPECT_TRUE(why < remedy && remedy < message.size() - 3) << message;  // "problem (why): what to do"
}

const Refusal keys_and_types[] = {
    {with_line(3, "replicate = 5"),
     "c.toml:3:1: unknown key 'replicate' (a config has claim, seed, models, n, replicates, statistics, "
     "graft, cells): "
     "did you mean replicates? "},
    {with_line(3, "replicates = \"5\""),
     "c.toml:3:14: replicates is a string (it must be a whole number or a table"},
    {with_line(1, "models = \"bst\""),
     "c.toml:1:10: models is a string (it must be a list of models): write models"},
    {with_line(1, "models = [1]"), "c.toml:1:11: models is a whole number ("},
    {with_line(1, "models = []"), "c.toml:1:10: models is empty ("},
    {with_line(1, ""), "c.toml: no 'models' ("},
    {with_line(2, ""), "c.toml: no 'n' ("},
    {with_line(3, ""), "c.toml: no 'replicates' ("},
    {with_line(4, ""), "c.toml: no 'statistics' ("},
    {"seed = -1\n" + std::string(good), "c.toml:1:8: seed = -1 (it must be a whole number from 0 to "},
    {"seed = 1.5\n" + std::string(good), "c.toml:1:8: seed = 1.5 ("},
    {"seed = true\n" + std::string(good), "c.toml:1:8: seed is true or false ("},
    {"graft = 1\n" + std::string(good), "c.toml:1:9: graft is a whole number (it must be true or false)"},
    {"claim = 20\n" + std::string(good), "c.toml:1:9: claim is a whole number ("},
    {"seed = 1\nseed = 2\n", "c.toml:2:"},
    {"models = [\"bst\"\nn = 3", "c.toml:2:1: this is not TOML ("},
    {"a = \"\xff\"", "c.toml:1:"},
};
INSTANTIATE_TEST_SUITE_P(KeysAndTypes, Refused, testing::ValuesIn(keys_and_types));

const Refusal models_and_statistics[] = {
    {with_line(1, "models = [\"bst\", \"bts\"]"),
     "c.toml:1:18: unknown model 'bts' (no model has that name): did you mean bst"},
    {with_line(1, "models = [\"beta(0,1)\"]"),
     "c.toml:1:11: beta(a,b) with a = 0 (a must lie in [1e-9,1e9]): "},
    {with_line(1, "models = [\"patricia(1)\"]"), "c.toml:1:11: patricia(p) with p = 1 ("},
    {with_line(1, "models = [\"b\\nst\"]"), "c.toml:1:11: unknown model 'b\\x0ast' ("},
    {with_line(1, "models = [\"b\\u0007st\"]"), "c.toml:1:11: unknown model 'b\\x07st' ("},
    {with_line(4, "statistics = [\"strahlr\"]"),
     "c.toml:4:15: unknown statistic 'strahlr' (no statistic has that name): did"},
    {with_line(4, "statistics = [\"height\", \"height\"]"), "c.toml:4:25: statistic 'height' given twice ("},
    {with_line(4, "statistics = []"), "c.toml:4:14: statistics is empty ("},
    {with_line(1, "models = [\"bst\", \"bst\"]"), "c.toml:2:6: bst with n = 10 twice ("},
    {with_line(1, "models = [\"split(0.25)\", \"split(1/4)\"]"),
     "c.toml:2:6: split(1/4) with n = 10 twice ("},
};

TEST(RunConfig, WhiteSpaceAroundAModelIsIgnored) {
  EXPECT_EQ(config_error(with_line(1, "models = [\" bst\\n\"]")), "");
}

TEST(RunConfig, ModelsAndStatisticsAreRefusedWithThePlace) {
  for (const auto& refusal : models_and_statistics) {
    const std::string message = config_error(refusal.text);
    EXPECT_TRUE(message.starts_with(refusal.start)) << message;
    EXPECT_EQ(message.find_first_of("\n\a"), std::string::npos);
  }
}

const Refusal sizes[] = {
    {with_line(2, "n = []"), "c.toml:2:5: n is empty ("},
    {with_line(2, "n = 10"), "c.toml:2:5: n is a whole number (it must be a list"},
    {with_line(2, "n = [10, 0]"),
     "c.toml:2:10: n = 0 (it must be a whole number from 1 to 4611686018427387904)"},
    {with_line(2, "n = [-3]"), "c.toml:2:6: n = -3 ("},
    {with_line(2, "n = [2.5]"), "c.toml:2:6: n = 2.5 ("},
    {with_line(2, "n = [nan]"), "c.toml:2:6: n = nan ("},
    {with_line(2, "n = [4611686018427387905]"), "c.toml:2:6: n = 4611686018427387905 ("},
    {with_line(2, "n = [99999999999999999999]"), "c.toml:2:"},
    {with_line(2, "n = [10, 20, 10]"), "c.toml:2:14: bst with n = 10 twice ("},
    {with_line(2, "n = { from = 0, to = 10, count = 3 }"), "c.toml:2:14: from = 0 ("},
    {with_line(2, "n = { from = 10, to = 5, count = 3 }"), "c.toml:2:5: a grid from 10 to 5 ("},
    {with_line(2, "n = { from = 10, to = 20, count = 0 }"), "c.toml:2:35: count = 0 ("},
    {with_line(2, "n = { from = 10, to = 20, count = 1e9 }"), "c.toml:2:35: count = 1000000000 ("},
    {with_line(2, "n = { from = 10, to = 20 }"), "c.toml:2:5: n without 'count' ("},
    {with_line(2, "n = { from = 10, count = 3 }"), "c.toml:2:5: n without 'to' ("},
    {with_line(2, "n = { from = 10, to = 20, factor = 2, count = 3 }"), "c.toml:2:23: a grid with both "},
    {with_line(2, "n = { from = 10, factor = 1, count = 3 }"), "c.toml:2:27: a grid with factor = 1 ("},
    {with_line(2, "n = { from = 10, factor = \"1/0\", count = 3 }"), "c.toml:2:27: factor = '1/0' ("},
    {with_line(2, "n = { from = 10, factor = 1e9, count = 9 }"), "c.toml:2:27: a grid from 10 by "},
    {with_line(2, "n = { form = 10, to = 20, count = 3 }"),
     "c.toml:2:7: unknown key 'form' (a grid of n has from, to, factor, "
     "count): did you mean from? "},
    {"models = [\"catalan\"]\nn = [1125899906842625]\nreplicates = 1\nstatistics = [\"height\"]",
     "c.toml:2:6: n = 1125899906842625 for catalan ("},
};
INSTANTIATE_TEST_SUITE_P(Sizes, Refused, testing::ValuesIn(sizes));

const Refusal replicates_and_cells[] = {
    {with_line(3, "replicates = 0"), "c.toml:3:14: replicates = 0 ("},
    {with_line(3, "replicates = { above = 0 }"), "c.toml:3:24: above = 0 ("},
    {with_line(3, "replicates = { to_15 = 9 }"), "c.toml:2:10: no number of replicates for n = 20 ("},
    {with_line(3, "replicates = { upto_1e5 = 9 }"), "c.toml:3:27: unknown key 'upto_1e5' in replicates ("},
    {with_line(3, "replicates = { to_0 = 9, above = 1 }"), "c.toml:3:23: unknown key 'to_0' in replicates ("},
    {with_line(3, "replicates = { to_1e2 = 9, to_100 = 8, above = 1 }"),
     "c.toml:3:37: 'to_100' bounds n at 100 again ("},
    {with_line(3, "replicates = {}"), "c.toml:2:6: no number of replicates for n = 10 ("},
    {std::string(good) + "[[cells]]\nn = [1]\nseed = 3\n",
     "c.toml:7:1: unknown key 'seed' (a [[cells]] table has "},
    {std::string(good) + "[[cells]]\nn = [1]\n", "c.toml:2:5: 'n' outside [[cells]] is not used ("},
    {std::string(good) + "[[cells]]\n[[cells]]\nn = [20]\n", "c.toml:7:6: bst with n = 20 twice ("},
    {"cells = 3\n" + std::string(good), "c.toml:1:9: cells is a whole number ("},
    {"cells = []\n" + std::string(good), "c.toml:1:9: cells is empty ("},
    {"cells = [3]\n" + std::string(good), "c.toml:1:10: cells is a whole number ("},
};
INSTANTIATE_TEST_SUITE_P(ReplicatesAndCells, Refused, testing::ValuesIn(replicates_and_cells));

TEST(RunConfig, FileThatIsNotThere) {
  EXPECT_EQ(test::error_of([] { read_run_config("/no/such.toml"); }),
            "cannot read '/no/such.toml' (No such file or directory): check the path");
}

/// The ```toml blocks of a page.
std::vector<std::string> examples(const std::string& page) {
  const std::string open = "```toml\n";
  std::vector<std::string> blocks;
  for (auto begin = page.find(open); begin != std::string::npos; begin = page.find(open, begin)) {
    begin += open.size();
    blocks.push_back(page.substr(begin, page.find("```", begin) - begin));
  }
  return blocks;
}

TEST(RunConfig, ExamplesOfTheDocumentationParse) {
  const auto page = std::filesystem::path(RAMIFY_SOURCE_DIR) / "docs/config.md";
  const auto blocks = examples(read_text_file(page));
  ASSERT_EQ(blocks.size(), 2u);
  const RunConfig first = parse_run_config(blocks[0], "docs/config.md");
  EXPECT_EQ(first.claim, "C20");
  EXPECT_EQ(first.groups.at(0).sizes.size(), 9u);
  EXPECT_EQ(first.groups.at(0).replicates.count(1'000'000), 100u);
  const RunConfig second = parse_run_config(blocks[1], "docs/config.md");
  ASSERT_EQ(second.groups.size(), 2u);
  EXPECT_EQ(second.groups[1].sizes, (Sizes{100, 435, 1890, 8219, 35735}));
}

}  // namespace
}  // namespace ramify
