#pragma once

#include <string>
#include <vector>

#include "ramify/text/source_text.hpp"
#include "ramify/tree/recorded_tree.hpp"

namespace ramify::detail {

/// Reads one Newick tree after the other from a text, character by character.
class NewickReader {
 public:
  explicit NewickReader(SourceText source) : source_(source), text_(source.text()) {}

  /// Skips white space and comments; true where more follows.
  bool more();
  /// Where the next tree begins.
  std::size_t position() const { return position_; }
  /// The next tree, without a name.
  RecordedTree next();

 private:
  char peek() const { return position_ < text_.size() ? text_[position_] : '\0'; }
  void skip_blanks();
  void skip_comment();
  void open();
  void close();
  void comma();
  void label();
  void quoted_label();
  void unquoted_label();
  void length();
  void name_node(std::string_view name, std::size_t place);
  std::uint32_t begin_leaf();
  std::uint32_t current();
  void finish();
  [[noreturn]] void refuse(std::size_t place, std::string_view problem, std::string_view why,
                           std::string_view remedy) const;

  SourceText source_;
  std::string_view text_;
  std::size_t position_ = 0;

  static constexpr std::uint32_t no_node = UINT32_MAX;
  std::vector<std::uint32_t> arity_;
  std::vector<std::uint32_t> open_;  // internal nodes whose ')' is still to come
  std::uint32_t node_ = no_node;     // what a label or length here belongs to; none after '(' and ','
  bool has_label_ = false, has_length_ = false;
  RecordedTree tree_;
};

}  // namespace ramify::detail
