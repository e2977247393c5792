#include "ramify/format/parens.hpp"

#include <fmt/format.h>

#include "ramify/text/line_cursor.hpp"
#include "ramify/text/trimmed.hpp"
#include "ramify/tree/parenthesis_word.hpp"

namespace ramify {

std::vector<RecordedTree> read_parens(SourceText source) {
  std::vector<RecordedTree> trees;
  LineCursor lines(source.text());
  while (lines.next()) {
    if (trimmed(lines.line()).empty()) continue;
    const std::string name = fmt::format("{}:{}", source.name(), lines.number());
    trees.push_back({name, from_parentheses(lines.line(), name), {}, {}, {}});
  }
  if (trees.empty())
    throw source.error(source.text().size(), "no tree", "a tree is a line of E and (LR)",
                       "write one, such as ((EE)E)");
  if (trees.size() == 1) trees.front().name = source.name();
  return trees;
}

std::string write_parens(const RecordedTree& tree) {
  return to_parentheses(tree.tree) + '\n';
}

}  // namespace ramify
