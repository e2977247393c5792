#include "ramify/format/nexus.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "ramify/format/newick_reader.hpp"

namespace ramify {
namespace {

std::string lower(std::string_view text) {
  std::string small;
  for (const char c : text) small += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return small;
}

/// The commands and blocks of a NEXUS text.
class NexusReader {
 public:
  NexusReader(SourceText source, Remarks& remarks)
      : source_(source), text_(source.text()), newick_(source), remarks_(remarks) {
    const std::size_t begin = text_.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos || !is_nexus(text_.substr(begin)))
      throw source.error(std::size_t{0}, "no NEXUS file", "it begins with #NEXUS", "leave out --format");
    position_ = begin + 6;
  }

  std::vector<RecordedTree> trees() {
    while (auto word = token()) {
      if (lower(*word) != "begin") {
        skip_command(*word);
        continue;
      }
      const std::string block = token().value_or("");
      if (lower(block) == "trees") {
        skip_command(block);
        read_block();
      } else {
        skip_block(block);
      }
    }
    if (trees_.empty())
      throw source_.error(text_.size(), "no tree in a NEXUS file", "trees stand in a block TREES",
                          "export the trees, not the data alone");
    if (trees_.size() == 1) trees_.front().name = source_.name();
    newick_.remark(remarks_);
    return std::move(trees_);
  }

 private:
  /// A word, a quoted word, or one of ; , = * in what stands outside of comments; nothing at the end.
  std::optional<std::string> token() {
    newick_.seek(position_);
    const bool more = newick_.more();
    position_ = newick_.position();
    if (!more) return std::nullopt;
    constexpr std::string_view marks = ";,=*()";
    const char first = text_[position_];
    if (first == '\'' || first == '"') return quoted(first);
    if (marks.find(first) != std::string_view::npos) return std::string(1, text_[position_++]);
    const std::size_t begin = position_;
    position_ = std::min(text_.find_first_of(" \t\r\n\v\f[;,=()", begin), text_.size());
    if (position_ == begin) ++position_;
    return std::string(text_.substr(begin, position_ - begin));
  }

  std::string quoted(char quote) {
    const std::size_t begin = position_++;
    std::string word;
    for (;; word += quote, ++position_) {
      const std::size_t end = text_.find(quote, position_);
      if (end == std::string_view::npos)
        throw source_.error(begin, "a quote that is never closed", "it runs to the end of the file",
                            "close it");
      word += text_.substr(position_, end - position_);
      position_ = end + 1;
      if (position_ == text_.size() || text_[position_] != quote) return word;
    }
  }

  std::string needed_token() {
    if (auto word = token()) return *std::move(word);
    throw source_.error(text_.size(), "the text ends within a NEXUS command", "a command ends with ';'",
                        "restore what was cut off");
  }

  /// Up to the ';', which may be the token that was read last.
  void skip_command(std::string word) {
    while (word != ";") word = needed_token();
  }

  void skip_block(const std::string& name) {
    if (lower(name) != "taxa") remarks_.ignore_named("block", name);
    for (;;) {
      const std::string word = lower(needed_token());
      if (word == "end" || word == "endblock") return skip_command(word);
    }
  }

  void read_block() {
    translation_.clear();
    for (;;) {
      const std::string command = lower(needed_token());
      if (command == "end" || command == "endblock") return skip_command(command);
      if (command == "translate") {
        read_translation();
      } else if (command == "tree" || command == "utree") {
        read_tree();
      } else {
        if (command != "title" && command != "link") remarks_.ignore_named("command", command);
        skip_command(command);
      }
    }
  }

  void read_translation() {
    for (;;) {
      const std::string token = needed_token();
      if (token == ";") return;
      if (token == ",") continue;
      std::string label = needed_token();
      if (label == ";" || label == ",")
        throw source_.error(position_ - 1, fmt::format("token '{}' without a label", token),
                            "TRANSLATE has pairs of a token and a label", "add the label");
      translation_[token] = std::move(label);
    }
  }

  void read_tree() {
    std::string name = needed_token();
    if (name == "*") name = needed_token();
    if (needed_token() != "=")
      throw source_.error(position_ - 1, fmt::format("tree {} without '='", name),
                          "a tree is written TREE name = (a,b);", "add it");
    newick_.seek(position_);
    if (!newick_.more()) needed_token();
    RecordedTree tree = newick_.next();
    position_ = newick_.position();
    tree.name = fmt::format("{}:{}", source_.name(), name);
    trees_.push_back(translated(std::move(tree)));
  }

  RecordedTree translated(RecordedTree tree) const {
    if (translation_.empty() || tree.names.empty()) return tree;
    NodeNames names;
    for (std::size_t node = 0; node < tree.tree.node_count(); ++node) {
      const auto found = translation_.find(tree.names[node]);
      names.set(node, found == translation_.end() ? tree.names[node] : std::string_view(found->second));
    }
    tree.names = std::move(names);
    return tree;
  }

  SourceText source_;
  std::string_view text_;
  detail::NewickReader newick_;
  Remarks& remarks_;
  std::size_t position_ = 0;
  std::map<std::string, std::string, std::less<>> translation_;
  std::vector<RecordedTree> trees_;
};

}  // namespace

bool is_nexus(std::string_view text) {
  return lower(text.substr(0, 6)) == "#nexus";
}

std::vector<RecordedTree> read_nexus(SourceText source, Remarks& remarks) {
  return NexusReader(source, remarks).trees();
}

}  // namespace ramify
