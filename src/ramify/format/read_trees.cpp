#include "ramify/format/read_trees.hpp"

#include <array>
#include <cstdio>

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/format/gunzip.hpp"
#include "ramify/format/json_tree.hpp"
#include "ramify/format/mtg.hpp"
#include "ramify/format/newick.hpp"
#include "ramify/format/nexus.hpp"
#include "ramify/format/parens.hpp"
#include "ramify/format/swc.hpp"
#include "ramify/format/tree_table.hpp"
#include "ramify/text/text_file.hpp"

namespace ramify {
namespace {

std::string read_standard_input() {
  std::string text;
  std::array<char, 1 << 16> block;
  while (const std::size_t size = std::fread(block.data(), 1, block.size(), stdin))
    text.append(block.data(), size);
  if (std::ferror(stdin) != 0)
    throw Error("cannot read standard input", "it ended with an error", "name a file instead of -");
  return text;
}

void require_no_root(TreeFormat format, const ReadOptions& options) {
  if (options.root.empty()) return;
  throw Error(fmt::format("--root {}", options.root), fmt::format("{} trees have one root", name_of(format)),
              "leave it out; it is for tables of nodes and parents");
}

}  // namespace

std::vector<RecordedTree> read_trees(std::string_view text, std::string_view name,
                                     std::optional<TreeFormat> format, const ReadOptions& options,
                                     Remarks& remarks) {
  const SourceText source(text, name);
  const TreeFormat known = format ? *format : detect_tree_format(source);
  switch (known) {
    case TreeFormat::swc:
      return read_swc(source, options, remarks);
    case TreeFormat::mtg:
      return read_mtg(source, options, remarks);
    case TreeFormat::qsm:
      return read_tree_table(source, TableKind::qsm, options, remarks);
    case TreeFormat::edges:
      return read_tree_table(source, TableKind::edges, options, remarks);
    case TreeFormat::flowlines:
      return read_tree_table(source, TableKind::flowlines, options, remarks);
    case TreeFormat::newick:
    case TreeFormat::nexus:
    case TreeFormat::parens:
    case TreeFormat::json:
      break;
  }
  require_no_root(known, options);
  if (known == TreeFormat::newick) return read_newick(source, remarks);
  if (known == TreeFormat::nexus) return read_nexus(source, remarks);
  return known == TreeFormat::parens ? read_parens(source) : read_json_trees(source, remarks);
}

std::string read_tree_file(const std::string& path) {
  std::string text = path == "-" ? read_standard_input() : read_text_file(path);
  return is_gzip(text) ? gunzip(text, path) : text;
}

}  // namespace ramify
