// One libFuzzer program for each reader of trees: any bytes are either refused by an Error of one line, or
// give whole trees that are written and read back unchanged.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "ramify/core/error.hpp"
#include "ramify/format/order_counts.hpp"
#include "ramify/format/read_trees.hpp"
#include "ramify/format/write_trees.hpp"
#include "ramify/tree/contract_unary.hpp"

namespace {

using namespace ramify;

void require(bool holds) {
  if (!holds) std::abort();
}

void require_whole(const RecordedTree& tree) {
  const std::size_t nodes = tree.tree.node_count();
  require(nodes > 0 && Tree::is_well_formed(tree.tree.arities()));
  require(tree.lengths.empty() || tree.lengths.size() == nodes);
  require(tree.radii.empty() || tree.radii.size() == nodes);
}

std::vector<RecordedTree> read_again(const std::string& text) {
  Remarks remarks;
  return read_trees(text, "back", std::nullopt, {}, remarks);
}

void require_same_again(const RecordedTree& tree) {
  for (const TreeFormat format : written_formats()) {
    const auto back = read_again(write_trees({tree}, format));
    require(back.size() == 1 && back.front().tree == tree.tree);
    if (format != TreeFormat::newick && format != TreeFormat::json) continue;
    for (std::size_t node = 0; node < tree.tree.node_count(); ++node)
      require(format == TreeFormat::json || tree.names[node].empty() ||
              back.front().names[node] == tree.names[node]);
  }
}

void read(std::string_view text, std::optional<TreeFormat> format, const ReadOptions& options) {
  try {
    Remarks remarks;
    const auto trees = read_trees(text, "fuzz", format, options, remarks);
    require(!trees.empty());
    for (const RecordedTree& tree : trees) {
      require_whole(tree);
      require_same_again(tree);
      const RecordedTree contracted = contract_unary(tree);
      require_whole(contracted);
      for (const std::uint32_t arity : contracted.tree.arities()) require(arity != 1);
    }
  } catch (const Error& error) {
    require(std::string_view(error.what()).find('\n') == std::string_view::npos);
  }
}

void read_counts(std::string_view text) {
  try {
    if (is_order_table(text)) read_order_counts(SourceText(text, "fuzz"));
  } catch (const Error& error) {
    require(std::string_view(error.what()).find('\n') == std::string_view::npos);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  constexpr std::string_view target = RAMIFY_FUZZ_TARGET;
  if (target == "counts") {
    read_counts(text);
    return 0;
  }
  const auto format = parse_tree_format(target);
  read(text, format, {});
  const bool has_roots =
      format && (*format == TreeFormat::swc || *format == TreeFormat::mtg || *format == TreeFormat::qsm ||
                 *format == TreeFormat::edges || *format == TreeFormat::flowlines);
  if (has_roots) read(text, format, {"all", 2});
  if (format == TreeFormat::swc) read(text, format, {"neurites", 0});
  return 0;
}
