#include "ramify/format/json_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "ramify/core/json_text.hpp"
#include "ramify/core/number.hpp"
#include "ramify/text/line_cursor.hpp"
#include "ramify/text/trimmed.hpp"
#include "ramify/tree/each_edge.hpp"

namespace ramify {
namespace {

using Json = nlohmann::json;

constexpr std::string_view remedy_form = R"(write {"parent": [-1,0,0]}, nodes in preorder)";

/// One line of the file.
class ObjectReader {
 public:
  ObjectReader(SourceText source, std::string_view line, Remarks& remarks)
      : source_(source), line_(line), remarks_(remarks) {}

  RecordedTree tree() const {
    const Json object = parsed();
    if (!object.is_object() || !object.contains("parent") || !object["parent"].is_array())
      fail("no list \"parent\"", "a tree is an object that has one");
    RecordedTree tree;
    tree.tree = Tree(arities(object["parent"]));
    if (object.contains("name") && object["name"].is_string()) tree.name = object["name"];
    const std::size_t nodes = tree.tree.node_count();
    tree.lengths = numbers(object, "length", nodes);
    tree.radii = numbers(object, "radius", nodes);
    const Json* labels = list(object, "label", nodes);
    for (std::size_t node = 0; labels != nullptr && node < nodes; ++node) {
      const Json& label = (*labels)[node];
      if (!label.is_string() && !label.is_null()) fail(fmt::format("label {}", label.dump()), "not a text");
      if (label.is_string() && !tree.names.set(node, label.get_ref<const std::string&>()))
        fail("more than 4 GB of labels", "they do not fit");
    }
    remark_others(object);
    return tree;
  }

 private:
  void remark_others(const Json& object) const {
    constexpr std::array<std::string_view, 5> known{"parent", "name", "length", "radius", "label"};
    for (const auto& item : object.items())
      if (std::ranges::find(known, item.key()) == known.end()) remarks_.ignore_named("key", item.key());
  }

  [[noreturn]] void fail(std::string_view problem, std::string_view why) const {
    throw source_.error(line_, problem, why, remedy_form);
  }

  Json parsed() const {
    try {
      return Json::parse(line_);
    } catch (const Json::parse_error& error) {
      throw source_.error(source_.offset(line_) + std::max<std::size_t>(error.byte, 1) - 1,
                          "not a line of JSON", "reading stopped here", remedy_form);
    } catch (const Json::exception&) {
      fail("a number out of range", "a double does not hold it");
    }
  }

  /// A node belongs to the last open node that its parent is: what was opened after that is done.
  std::vector<std::uint32_t> arities(const Json& parents) const {
    std::vector<std::uint32_t> arity, path;
    for (const Json& parent : parents) {
      if (!parent.is_number_integer()) fail(fmt::format("parent {}", parent.dump()), "not a whole number");
      const bool is_root = parent == -1;
      if (is_root != arity.empty())
        fail(is_root ? "a second root" : "the first node has a parent", "the root, and it alone, has -1");
      while (!path.empty() && parent != path.back()) path.pop_back();
      if (!is_root && path.empty())
        fail(fmt::format("node {} is not in preorder", arity.size()),
             "every subtree is listed before the next begins");
      if (!is_root) ++arity[path.back()];
      path.push_back(static_cast<std::uint32_t>(arity.size()));
      arity.push_back(0);
    }
    if (arity.empty()) fail("a tree of no nodes", "there is one at least");
    return arity;
  }

  const Json* list(const Json& object, const char* key, std::size_t nodes) const {
    if (!object.contains(key)) return nullptr;
    const Json& values = object[key];
    if (!values.is_array() || values.size() != nodes)
      fail(fmt::format("\"{}\" is not a list of {} values", key, nodes), "every node has one");
    return &values;
  }

  std::vector<double> numbers(const Json& object, const char* key, std::size_t nodes) const {
    const Json* values = list(object, key, nodes);
    std::vector<double> numbers;
    for (std::size_t node = 0; values != nullptr && node < nodes; ++node) {
      const Json& value = (*values)[node];
      if (!value.is_number() && !value.is_null())
        fail(fmt::format("{} {}", key, value.dump()), "not a number");
      numbers.push_back(value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>());
    }
    return numbers;
  }

  SourceText source_;
  std::string_view line_;
  Remarks& remarks_;
};

void append_numbers(std::string& text, std::string_view key, const std::vector<double>& values) {
  if (values.empty()) return;
  text += fmt::format(",\"{}\":[", key);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) text += ',';
    text += std::isfinite(values[i]) ? format_exact(values[i]) : "null";
  }
  text += ']';
}

}  // namespace

std::vector<RecordedTree> read_json_trees(SourceText source, Remarks& remarks) {
  std::vector<RecordedTree> trees;
  LineCursor lines(source.text());
  while (lines.next()) {
    if (trimmed(lines.line()).empty()) continue;
    trees.push_back(ObjectReader(source, lines.line(), remarks).tree());
    trees.back().name = fmt::format("{}:{}", source.name(), lines.number());
  }
  if (trees.empty())
    throw source.error(source.text().size(), "no tree", "a tree is an object a line", remedy_form);
  if (trees.size() == 1) trees.front().name = source.name();
  return trees;
}

std::string write_json_tree(const RecordedTree& recorded) {
  std::vector<std::int64_t> parents(recorded.tree.node_count(), -1);
  each_edge(recorded.tree, [&](std::size_t parent, std::size_t child) {
    parents[child] = static_cast<std::int64_t>(parent);
  });
  std::string text = "{";
  if (!recorded.name.empty()) text += "\"name\":" + json_text(recorded.name) + ',';
  text += fmt::format("\"parent\":[{}]", fmt::join(parents, ","));
  append_numbers(text, "length", recorded.lengths);
  append_numbers(text, "radius", recorded.radii);
  if (!recorded.names.empty()) {
    text += ",\"label\":[";
    for (std::size_t node = 0; node < parents.size(); ++node) {
      if (node > 0) text += ',';
      text += json_text(recorded.names[node]);
    }
    text += ']';
  }
  return text += "}\n";
}

}  // namespace ramify
