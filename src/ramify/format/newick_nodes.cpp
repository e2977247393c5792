// What NewickReader makes of labels, marks and lengths: all that is said of a node.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

#include <fmt/format.h>

#include "ramify/format/newick_characters.hpp"
#include "ramify/format/newick_reader.hpp"
#include "ramify/text/whole_number.hpp"

namespace ramify::detail {
namespace {

/// Where "#H1", "#LGT2", "#R3" or "#4" stands at the end of a label: extended Newick (Cardona, Rossello and
/// Valiente 2008). npos where it does not.
std::size_t hybrid_tag(std::string_view label) {
  const auto mark = label.rfind('#');
  if (mark == std::string_view::npos) return mark;
  std::string_view rest = label.substr(mark + 1);
  while (!rest.empty() && std::string_view("HLGTR").find(rest.front()) != std::string_view::npos)
    rest.remove_prefix(1);
  const bool is_tag = !rest.empty() && rest.find_first_not_of("0123456789") == std::string_view::npos;
  return is_tag ? mark : std::string_view::npos;
}

}  // namespace

void NewickReader::name_node(std::string_view name, std::size_t place) {
  const std::uint32_t node = current();
  if (has_label_ || has_length_)
    refuse(place, fmt::format("a second label '{}'", excerpt(name)), "a node has one, before its length",
           "put a ',' between nodes, and quotes around labels that hold blanks or marks");
  has_label_ = true;
  if (!tree_.names.set(node, name))
    refuse(place, "more than 4 GB of labels", "they do not fit", "shorten them");
}

void NewickReader::label() {
  if (peek() == '\'' || peek() == '"') {
    quoted_label(peek());
  } else {
    unquoted_label();
  }
}

void NewickReader::quoted_label(char quote) {
  const std::size_t begin = position_++;
  std::string name;
  for (;;) {
    const std::size_t end = text_.find(quote, position_);
    if (end == std::string_view::npos)
      refuse(begin, "a quote that is never closed", "the label runs to the end of the file", "close it");
    name += text_.substr(position_, end - position_);
    position_ = end + 1;
    if (peek() != quote) break;
    name += quote;
    ++position_;
  }
  name_node(name, begin);
}

void NewickReader::unquoted_label() {
  const std::size_t begin = position_;
  std::size_t end = begin;
  // Blanks within a label are no part of the standard, but of many files; apostrophes are letters, except
  // where a word begins.
  for (; position_ < text_.size() && newick_kind(text_[position_]) != NewickKind::mark; ++position_) {
    const bool begins_word = position_ > end && end > begin;
    if (begins_word && (peek() == '\'' || at_mark())) break;
    if (newick_kind(text_[position_]) == NewickKind::word) end = position_ + 1;
  }
  const std::string_view name = text_.substr(begin, end - begin);
  require_no_hybrid(name, begin);
  name_node(name, begin);
}

/// Two labels with the same tag are two ends of one node, where their names do not tell them apart.
void NewickReader::require_no_hybrid(std::string_view name, std::size_t place) {
  const std::size_t mark = hybrid_tag(name);
  if (mark == std::string_view::npos) return;
  const std::string_view stem = name.substr(0, mark), tag = name.substr(mark);
  const auto [first, is_new] = tags_.emplace(tag, Tagged{std::string(stem), place});
  const bool same_node =
      !is_new && (stem == first->second.stem || stem.empty() || first->second.stem.empty());
  const bool is_leaf_alone = stem.empty() && node_ == no_node;
  if (same_node || is_leaf_alone)
    refuse(first->second.place, fmt::format("a hybrid node '{}{}'", excerpt(first->second.stem), tag),
           "a network is not a tree",
           "take one of the trees that it displays, or put quotes around labels that end so");
}

/// "#1" or "$1" of PAML, in quotes too, which marks branches and clades, behind a node.
bool NewickReader::at_mark() const {
  const bool quoted = peek() == '\'';
  const std::size_t mark = position_ + (quoted ? 1 : 0);
  if (mark >= text_.size() || (text_[mark] != '#' && text_[mark] != '$')) return false;
  const std::size_t end = std::min(text_.find_first_not_of("0123456789.", mark + 1), text_.size());
  if (end == mark + 1) return false;
  if (quoted) return end < text_.size() && text_[end] == '\'';
  return end == text_.size() || newick_kind(text_[end]) != NewickKind::word;
}

void NewickReader::skip_mark() {
  ++marks_;
  const bool quoted = peek() == '\'';
  position_ = std::min(text_.find_first_not_of("0123456789.", position_ + (quoted ? 2 : 1)), text_.size());
  if (quoted) ++position_;
}

/// "{Foreground}" of HyPhy, "{12}" of placements: what is said of the branch of a node.
void NewickReader::skip_braces() {
  const std::size_t end = text_.find('}', position_);
  if (end == std::string_view::npos)
    refuse(position_, "a '{' that is never closed", "braces hold marks of branches", "close it");
  if (node_ == no_node)
    refuse(position_, "a '{' without a node", "braces hold marks of the node before them",
           "put quotes around labels that hold braces");
  ++braces_;
  position_ = end + 1;
}

/// "nan", "NA", nothing: whether no length stands here, which is skipped.
bool NewickReader::missing_length() {
  std::size_t end = position_;
  while (end < text_.size() && newick_kind(text_[end]) == NewickKind::word) ++end;
  if (!is_missing(text_.substr(position_, end - position_))) return false;
  position_ = end;
  ++missing_here_;
  return true;
}

void NewickReader::set_length(std::uint32_t node, double value) {
  if (tree_.lengths.size() <= node)
    tree_.lengths.resize(std::size_t{node} + 1, std::numeric_limits<double>::quiet_NaN());
  tree_.lengths[node] = value;
  has_length_ = true;
}

void NewickReader::length() {
  const std::uint32_t node = current();
  const std::size_t colon = position_++;
  if (has_length_)
    refuse(colon, "a second length",
           "a branch has one; support values of the form :length:support are not read",
           "write the support as a label");
  skip_blanks();
  if (missing_length()) return set_length(node, std::numeric_limits<double>::quiet_NaN());
  const char* const begin = text_.data() + position_;
  const char* const end = text_.data() + text_.size();
  double value = 0;
  auto [after, status] = std::from_chars(begin + (peek() == '+' ? 1 : 0), end, value);
  // Numbers too close to 0 for a double are 0; those too far from it are refused.
  const auto size = static_cast<std::size_t>(after - begin);
  if (status == std::errc::result_out_of_range)
    value = std::strtod(std::string(begin, size).c_str(), nullptr);
  if (status == std::errc::invalid_argument || !std::isfinite(value))
    refuse(
        position_,
        fmt::format("a branch length '{}'", excerpt(text_.substr(position_, std::max<std::size_t>(size, 1)))),
        "not a finite number that a double holds",
        "write it like 0.23 or 1e-3, and put quotes around labels that hold a colon");
  position_ += size;
  set_length(node, value);
}

}  // namespace ramify::detail
