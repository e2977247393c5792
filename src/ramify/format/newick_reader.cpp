#include "ramify/format/newick_reader.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

#include <fmt/format.h>

#include "ramify/text/whole_number.hpp"

namespace ramify::detail {
namespace {

constexpr std::string_view remedy_form = "write trees like ((a:1,b:2):3,c);";

enum class Kind : std::uint8_t { word, blank, mark };

constexpr std::array<Kind, 256> kinds() {
  std::array<Kind, 256> table{};
  for (const char c : {' ', '\t', '\n', '\r', '\v', '\f'}) table[static_cast<unsigned char>(c)] = Kind::blank;
  for (const char c : {'(', ')', '[', ']', ':', ';', ',', '{', '\0'})
    table[static_cast<unsigned char>(c)] = Kind::mark;
  return table;
}

Kind kind_of(char c) {
  static constexpr auto table = kinds();
  return table[static_cast<unsigned char>(c)];
}

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

void NewickReader::refuse(std::size_t place, std::string_view problem, std::string_view why,
                          std::string_view remedy) const {
  throw source_.error(place, problem, why, remedy);
}

void NewickReader::skip_comment() {
  const std::size_t begin = position_;
  const std::string_view head = text_.substr(begin, 4);
  const bool is_rooting = head == "[&R]" || head == "[&U]" || head == "[&r]" || head == "[&u]";
  if (head.starts_with("[&") && !is_rooting) ++annotations_;
  std::size_t depth = 0;
  do {
    position_ = text_.find_first_of("[]", position_);
    if (position_ == std::string_view::npos)
      refuse(begin, "a comment that is never closed", "'[' without its ']'", "close it");
    if (text_[position_++] == '[') {
      ++depth;
    } else {
      --depth;
    }
  } while (depth > 0);
}

void NewickReader::skip_blanks() {
  for (;;) {
    while (position_ < text_.size() && kind_of(text_[position_]) == Kind::blank) ++position_;
    if (peek() != '[') return;
    skip_comment();
  }
}

bool NewickReader::more() {
  skip_blanks();
  return position_ < text_.size();
}

std::uint32_t NewickReader::begin_leaf() {
  if (open_.empty() && !arity_.empty())
    refuse(position_, "more after the end of a tree", "a tree ends with ';'", "end it");
  if (arity_.size() >= no_node - 1)
    refuse(position_, "a tree of 4*10^9 nodes", "larger ones do not fit", "take a part of it");
  if (!open_.empty()) ++arity_[open_.back()];
  arity_.push_back(0);
  has_label_ = has_length_ = false;
  return static_cast<std::uint32_t>(arity_.size() - 1);
}

/// The node that a label, a length or a ',' here belongs to: a leaf without a label begins here unless one is
/// there.
std::uint32_t NewickReader::current() {
  if (node_ == no_node) node_ = begin_leaf();
  return node_;
}

/// What was read as a leaf alone is the name of the tree that begins here.
void NewickReader::take_tree_name() {
  std::string_view name = tree_.names[0];
  while (!name.empty() && (name.back() == '=' || kind_of(name.back()) == Kind::blank)) name.remove_suffix(1);
  std::string kept(name);
  tree_ = {};
  tree_.name = std::move(kept);
  arity_.clear();
  tags_.clear();
  node_ = no_node;
}

void NewickReader::open() {
  if (open_.empty() && arity_.size() == 1 && arity_[0] == 0 && has_label_ && !has_length_) take_tree_name();
  if (node_ != no_node) refuse(position_, "a '(' after a node", "subtrees are parted by commas", remedy_form);
  open_.push_back(begin_leaf());
  ++position_;
}

void NewickReader::close() {
  if (open_.empty()) refuse(position_, "a ')' without its '('", "parentheses come in pairs", remedy_form);
  if (node_ == no_node && arity_[open_.back()] == 0)
    refuse(position_, "an empty pair of parentheses", "an internal node has a child at least", remedy_form);
  current();
  node_ = open_.back();
  open_.pop_back();
  has_label_ = has_length_ = false;
  ++position_;
}

void NewickReader::comma() {
  if (open_.empty())
    refuse(position_, "a ',' outside of parentheses", "siblings stand in parentheses", remedy_form);
  current();
  node_ = no_node;
  ++position_;
}

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
  for (; position_ < text_.size() && kind_of(text_[position_]) != Kind::mark; ++position_) {
    const bool begins_word = position_ > end && end > begin;
    if (begins_word && (peek() == '\'' || at_mark())) break;
    if (kind_of(text_[position_]) == Kind::word) end = position_ + 1;
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
           "a network is not a tree", "take one of the trees that it displays");
}

/// "#1" or "$1" of PAML, which marks branches and clades, behind a node.
bool NewickReader::at_mark() const {
  if (peek() != '#' && peek() != '$') return false;
  const std::size_t end = text_.find_first_not_of("0123456789.", position_ + 1);
  return end > position_ + 1 && (end == std::string_view::npos || kind_of(text_[end]) != Kind::word);
}

void NewickReader::skip_mark() {
  ++marks_;
  position_ = std::min(text_.find_first_not_of("0123456789.", position_ + 1), text_.size());
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
  while (end < text_.size() && kind_of(text_[end]) == Kind::word) ++end;
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
        "not a finite number that a double holds", "write it like 0.23 or 1e-3");
  position_ += size;
  set_length(node, value);
}

void NewickReader::finish() {
  if (!open_.empty())
    refuse(position_, fmt::format("a ';' with {} '(' left open", open_.size()), "parentheses come in pairs",
           "close them, or restore what was cut off");
  if (arity_.empty()) refuse(position_, "a ';' without a tree", "a tree has a node at least", "remove it");
  ++position_;
  tree_.tree = Tree(std::move(arity_));
  count_missing_lengths();
}

/// In a tree that has lengths every branch has one; the root need not.
void NewickReader::count_missing_lengths() {
  if (tree_.lengths.empty()) return;
  tree_.lengths.resize(tree_.tree.node_count(), std::numeric_limits<double>::quiet_NaN());
  const auto missing = static_cast<std::size_t>(std::count_if(
      tree_.lengths.begin() + 1, tree_.lengths.end(), [](double length) { return std::isnan(length); }));
  missing_lengths_ += std::max(missing, missing_here_);
  const bool any = !std::isnan(tree_.lengths[0]) || missing + 1 < tree_.lengths.size();
  if (!any) tree_.lengths.clear();
}

void NewickReader::remark(Remarks& remarks) const {
  if (missing_lengths_ > 0)
    remarks.doubt(fmt::format("{} without a length", missing_lengths_ == 1
                                                         ? "a branch is"
                                                         : fmt::format("{} branches are", missing_lengths_)));
  remarks.ignore("mark", "of branches (#1, $1)", marks_);
  remarks.ignore("mark", "in braces", braces_);
  remarks.ignore("annotation", "in brackets", annotations_);
}

RecordedTree NewickReader::next() {
  tree_ = {};
  arity_.clear();
  open_.clear();
  tags_.clear();
  missing_here_ = 0;
  node_ = no_node;
  has_label_ = has_length_ = false;
  for (;;) {
    skip_blanks();
    if (position_ == text_.size())
      refuse(position_, "the text ends within a tree",
             fmt::format("{} '(' left open and no ';' seen", open_.size()), "restore what was cut off");
    switch (peek()) {
      case '(':
        open();
        break;
      case ')':
        close();
        break;
      case ',':
        comma();
        break;
      case ':':
        length();
        break;
      case ';':
        finish();
        return std::move(tree_);
      case ']':
        refuse(position_, "a ']' without its '['", "brackets hold comments", "remove it");
      case '{':
        skip_braces();
        break;
      case '\0':
        refuse(position_, "a zero byte", "this is no text", "give a text file of trees");
      default:
        if (node_ != no_node && at_mark()) {
          skip_mark();
        } else {
          label();
        }
    }
  }
}

}  // namespace ramify::detail
