#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "ramify/text/remarks.hpp"
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
  void seek(std::size_t position) { position_ = position; }
  /// The next tree; its name is what stands before it, `name(...);` or `name = (...);`.
  RecordedTree next();
  /// Remarks marks, annotations and missing lengths of all trees that were read.
  void remark(Remarks& remarks) const;

 private:
  char peek() const { return position_ < text_.size() ? text_[position_] : '\0'; }
  void skip_blanks();
  void skip_comment();
  void open();
  void close();
  void comma();
  void label();
  void quoted_label(char quote);
  void unquoted_label();
  bool at_mark() const;
  void skip_mark();
  /// One part of a tree but its end: a bracket, a comma, a label, a length.
  void read_part();
  void skip_braces();
  void length();
  bool missing_length();
  void set_length(std::uint32_t node, double value);
  void take_tree_name();
  void require_no_hybrid(std::string_view name, std::size_t place);
  void name_node(std::string_view name, std::size_t place);
  std::uint32_t begin_leaf();
  std::uint32_t current();
  void finish();
  void count_missing_lengths();
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
  struct Tagged {
    std::string stem;
    std::size_t place;
  };
  std::map<std::string, Tagged, std::less<>> tags_;  ///< "#H1" and the like at the ends of labels
  std::size_t marks_ = 0, braces_ = 0, annotations_ = 0, missing_lengths_ = 0, missing_here_ = 0;
};

}  // namespace ramify::detail
