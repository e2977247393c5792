// Files that are written in other ways with the same meaning give the same answer: 500 of each.
#include <filesystem>
#include <sstream>

#include "support/fixtures.hpp"
#include "support/mutations.hpp"
#include "support/tree_files.hpp"

#include "ramify/text/csv_reader.hpp"
#include "ramify/text/text_file.hpp"

namespace ramify {
namespace {

/// Nodes and streams, and lengths where they are known, of every tree.
void expect_same_answers(const std::string& name, const std::string& text, const ReadOptions& options) {
  constexpr int mutations = 500;
  Remarks remarks;
  const std::string right = test::measured_text(text, options, remarks);
  ASSERT_FALSE(right.starts_with("refused")) << right;
  test::Mutator mutator(1996);
  for (int i = 0; i < mutations; ++i) {
    const std::string mutated = mutator.mutated(name, text);
    ASSERT_EQ(test::measured_text(mutated, options, remarks), right) << mutated;
  }
}

TEST(MutatedFiles, ExamplesKeepTheirAnswers) {
  const std::filesystem::path folder = std::filesystem::path(RAMIFY_SOURCE_DIR) / "data/examples";
  for (const char* name : {"brook_flowlines.csv", "sapling.mtg", "sapling.newick", "sapling.swc",
                           "sapling_edges.csv", "sapling_qsm.csv"}) {
    SCOPED_TRACE(name);
    expect_same_answers(name, read_text_file(folder / name), {});
  }
}

std::filesystem::path field_folder() {
  return std::filesystem::path(test::shared_file("x")).parent_path().parent_path() / "field";
}

ReadOptions options_of(std::string_view text) {
  constexpr std::string_view root = "--root ";
  return {text.starts_with(root) ? std::string(text.substr(root.size())) : std::string(), 0};
}

TEST(FieldFiles, HaveTheirRightAnswers) {
  RAMIFY_NEEDS_SHARED_FILES();
  const CsvData expected = CsvData::read(field_folder() / "expected.csv");
  for (std::size_t row = 0; row < expected.rows(); ++row) {
    const std::string file(expected.at(row, "file"));
    std::string right =
        fmt::format("{} / {}", expected.at(row, "right_nodes"), expected.at(row, "right_streams"));
    Remarks remarks;
    std::string found = test::measured_text(read_text_file(field_folder() / file),
                                            options_of(expected.at(row, "options")), remarks);
    const std::string_view lengths = expected.at(row, "right_mean_lengths");
    if (lengths.empty()) {
      found = found.substr(0, right.size());  // the table says nothing of them
    } else {
      while (found.ends_with(" -")) found.resize(found.size() - 2);
      right += " /";
      std::istringstream numbers{std::string(lengths)};
      for (double length = 0; numbers >> length;) right += fmt::format(" {:.6g}", length);
    }
    EXPECT_EQ(found, right) << file;
  }
}

TEST(FieldFiles, KeepTheirAnswersWhenMutated) {
  RAMIFY_NEEDS_SHARED_FILES();
  const CsvData expected = CsvData::read(field_folder() / "expected.csv");
  for (std::size_t row = 0; row < expected.rows(); ++row) {
    const std::string file(expected.at(row, "file"));
    SCOPED_TRACE(file);
    expect_same_answers(file, read_text_file(field_folder() / file), options_of(expected.at(row, "options")));
  }
  const std::pair<const char*, const char*> others[] = {
      {"08_all_points_soma.swc", ""},   {"08b_branch_typed_soma.swc", ""},
      {"19_trees_interleaved.csv", ""}, {"19b_trees_interleaved_torn.csv", ""},
      {"26_radius_unknown.swc", ""},    {"27_nan_lengths.newick", ""},
      {"27b_empty_lengths.newick", ""}, {"25_neurite_not_joined.swc", "--root neurites"}};
  for (const auto& [file, options] : others) {
    SCOPED_TRACE(file);
    expect_same_answers(file, read_text_file(field_folder() / file), options_of(options));
  }
}

/// What the folder's README says of the files that the table leaves out.
TEST(FieldFiles, AreReadOrRefusedAsTheirReadmeSays) {
  RAMIFY_NEEDS_SHARED_FILES();
  const auto read = [](const char* file, const ReadOptions& options, Remarks& remarks) {
    return test::measured_text(read_text_file(field_folder() / file), options, remarks);
  };
  const struct {
    const char* file;
    const char* root;
    const char* right;
    const char* says;
  } cases[] = {
      {"08_all_points_soma.swc", "", "1 / 1 / -", "all 6 points are typed soma"},
      {"08b_branch_typed_soma.swc", "", "2 1 / 2 1 / 5.65685 10", "2 soma points lie up to 2.91 radii"},
      {"19_trees_interleaved.csv", "", "2 1 / 2 1 / 1 2; 2 1 / 2 1 / 1.5 3", ""},
      {"19b_trees_interleaved_torn.csv", "", "3 2 / 3 1; 2 1 / 2 1", ""},
      {"25_neurite_not_joined.swc", "neurites", "2 1 / 2 1 / 5 5", ""},
      {"26_radius_unknown.swc", "", "2 1 / 2 1 / 5 10", "3 points are without a radius"},
      {"27_nan_lengths.newick", "", "4 2 1 / 4 2 1 / 1.5 1 -", "3 branches are without a length"},
      {"27b_empty_lengths.newick", "", "4 2 1 / 4 2 1 / 1.5 1 -", "3 branches are without a length"},
  };
  for (const auto& [file, root, right, says] : cases) {
    Remarks remarks;
    EXPECT_EQ(read(file, {root, 0}, remarks), right) << file;
    EXPECT_NE(fmt::format("{}", fmt::join(remarks.lines("f"), "\n")).find(says), std::string::npos) << file;
  }
  Remarks remarks;
  EXPECT_NE(read("25_neurite_not_joined.swc", {}, remarks).find("--root neurites"), std::string::npos);
}

}  // namespace
}  // namespace ramify
