#include "ramify/format/write_trees.hpp"

#include "ramify/format/edge_table.hpp"
#include "ramify/format/json_tree.hpp"
#include "ramify/format/newick.hpp"
#include "ramify/format/parens.hpp"
#include "ramify/format/swc.hpp"

namespace ramify {

const std::vector<TreeFormat>& written_formats() {
  static const std::vector<TreeFormat> formats{TreeFormat::newick, TreeFormat::edges, TreeFormat::swc,
                                               TreeFormat::parens, TreeFormat::json};
  return formats;
}

std::string write_trees(const std::vector<RecordedTree>& trees, TreeFormat format) {
  if (format == TreeFormat::edges) return write_edge_table(trees);
  if (format == TreeFormat::swc) return write_swc(trees);
  std::string text;
  for (const RecordedTree& tree : trees) {
    if (format == TreeFormat::newick) text += write_newick(tree);
    if (format == TreeFormat::parens) text += write_parens(tree);
    if (format == TreeFormat::json) text += write_json_tree(tree);
  }
  return text;
}

}  // namespace ramify
