#include "ramify/format/newick.hpp"

#include <fmt/format.h>

#include "ramify/core/number.hpp"
#include "ramify/format/newick_reader.hpp"

namespace ramify {
namespace {

/// Lines and columns of ascending places, counted once.
class Places {
 public:
  explicit Places(SourceText source) : source_(source) {}

  SourceLocation at(std::size_t place) {
    const SourceLocation step = SourceText(source_.text().substr(last_), "").at(place - last_);
    line_ += step.line - 1;
    column_ = step.line == 1 ? column_ + step.column - 1 : step.column;
    last_ = place;
    return {std::string(source_.name()), line_, column_};
  }

 private:
  SourceText source_;
  std::size_t last_ = 0, line_ = 1, column_ = 1;
};

/// A tree that has a name of its own keeps it behind that of the file; others are named after their places.
void name_trees(std::vector<RecordedTree>& trees, const std::vector<SourceLocation>& places) {
  for (std::size_t i = 0; i < trees.size(); ++i) {
    const SourceLocation& place = places[i];
    const bool shares_line = (i > 0 && places[i - 1].line == place.line) ||
                             (i + 1 < places.size() && places[i + 1].line == place.line);
    if (trees.size() == 1) {
      trees[i].name = place.file;
    } else if (!trees[i].name.empty()) {
      trees[i].name = fmt::format("{}:{}", place.file, trees[i].name);
    } else {
      trees[i].name = shares_line ? fmt::format("{}:{}:{}", place.file, place.line, place.column)
                                  : fmt::format("{}:{}", place.file, place.line);
    }
  }
}

bool needs_quotes(std::string_view label) {
  if (label.empty() || label.find_first_of("()[]{}'\":;, \t\r\n\v\f#$=") != std::string_view::npos)
    return true;
  // A label that begins like a byte-order mark would be taken for one at the start of a file.
  return label.find('\0') != std::string_view::npos || label.starts_with("\xEF\xBB\xBF");
}

void append_label(std::string& text, std::string_view label) {
  if (!needs_quotes(label)) {
    text += label;
    return;
  }
  text += '\'';
  for (const char c : label) {
    if (c == '\'') text += '\'';
    text += c;
  }
  text += '\'';
}

}  // namespace

std::size_t newick_count_line(std::string_view text) {
  const std::size_t tree = text.find_first_not_of("0123456789 \t\r\n");
  if (tree == std::string_view::npos || text[tree] != '(') return 0;
  return text.substr(0, tree).find_first_of("0123456789") == std::string_view::npos ? 0 : tree;
}

std::vector<RecordedTree> read_newick(SourceText source, Remarks& remarks) {
  detail::NewickReader reader(source);
  Places places(source);
  std::vector<RecordedTree> trees;
  std::vector<SourceLocation> begins;
  if (const std::size_t tree = newick_count_line(source.text()); tree > 0) {
    reader.seek(tree);
    remarks.ignore("line", "of counts before the trees");
  }
  while (reader.more()) {
    begins.push_back(places.at(reader.position()));
    trees.push_back(reader.next());
  }
  if (trees.empty())
    throw source.error(source.text().size(), "no tree", "a Newick tree ends with ';'",
                       "write trees like ((a:1,b:2):3,c);");
  name_trees(trees, begins);
  reader.remark(remarks);
  return trees;
}

std::string write_newick(const RecordedTree& recorded) {
  const Tree& tree = recorded.tree;
  std::string text;
  std::size_t leaves = 0;
  struct Open {
    std::size_t node;
    std::uint32_t missing;
  };
  std::vector<Open> open;
  const auto end_node = [&](std::size_t node) {
    if (const std::string_view name = recorded.names[node]; !name.empty()) append_label(text, name);
    if (!recorded.lengths.empty() && recorded.lengths[node] == recorded.lengths[node])
      text += ':' + format_exact(recorded.lengths[node]);
  };
  for (std::size_t node = 0; node < tree.node_count(); ++node) {
    if (tree.arity(node) > 0) {
      text += '(';
      open.push_back({node, tree.arity(node)});
      continue;
    }
    ++leaves;
    if (recorded.names.empty()) text += std::to_string(leaves);
    end_node(node);
    while (!open.empty() && --open.back().missing == 0) {
      text += ')';
      end_node(open.back().node);
      open.pop_back();
    }
    if (!open.empty()) text += ',';
  }
  return text += ";\n";
}

}  // namespace ramify
