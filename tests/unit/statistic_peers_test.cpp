// Indices of trees as other programs print them (RAMIFY_SHARED/peers: R packages treebalance, treestats, ape,
// apTreeshape, and DendroPy).
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>

#include "support/columns.hpp"
#include "support/tree_files.hpp"
#include <gtest/gtest.h>

#include "ramify/sample/measure_tree.hpp"
#include "ramify/text/csv_reader.hpp"
#include "ramify/text/text_file.hpp"

namespace ramify {
namespace {

/// Their peer_names, and ours.
const std::map<std::string_view, const char*> peer_names{
    {"sackin", "sackin"},
    {"colless", "colless"},
    {"total_internal_path_length", "path_length"},
    {"total_cophenetic", "total_cophenetic"},
    {"rooted_quartet_3", "rooted_quartets"},
    {"b1", "b1"},
    {"b2", "b2"},
    {"average_leaf_depth", "average_leaf_depth"},
    {"variance_leaf_depth", "variance_leaf_depth"},
    {"max_width_over_max_depth", "maximum_width_over_maximum_depth"},
    {"stairs1", "stairs1"},
    {"stairs2", "stairs2"},
    {"symmetry_nodes", "symmetry_nodes"},
    {"pitchforks", "pitchforks"},
    {"j_one", "j1"}};

/// All digits are those of a double in 15 digits.
TEST(TreeIndices, AreThoseOfOtherPrograms) {
  RAMIFY_NEEDS_SHARED_FILES();
  const std::string folder = test::shared_file("../peers/");
  const CsvData peers = CsvData::read(folder + "indices.csv");
  std::map<std::string, std::size_t> compared;
  std::map<std::string, TreeMeasures> measured;
  for (std::size_t row = 0; row < peers.rows(); ++row) {
    const std::string tree(peers.at(row, "tree"));
    const auto ours = peer_names.find(peers.at(row, "index"));
    if (ours == peer_names.end() || tree.starts_with("phylo_")) continue;
    if (!measured.contains(tree))
      measured[tree] = measure_tree(test::tree_of(read_text_file(folder + "trees/" + tree)).tree, {1, 0}, 0);
    const double value = test::column(ours->second).real_value(measured.at(tree));
    const double theirs = peers.real(row, "value");
    EXPECT_NEAR(value, theirs, 1e-12 * std::abs(theirs))
        << ours->second << " of " << tree << " by " << peers.at(row, "peer");
    ++compared[ours->second];
  }
  for (const auto& [theirs, ours] : peer_names) EXPECT_GE(compared[ours], 9u) << ours;
}

}  // namespace
}  // namespace ramify
