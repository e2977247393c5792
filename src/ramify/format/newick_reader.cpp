#include "ramify/format/newick_reader.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "ramify/format/newick_characters.hpp"

namespace ramify::detail {
namespace {

constexpr std::string_view remedy_form = "write trees like ((a:1,b:2):3,c);";

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
    while (position_ < text_.size() && newick_kind(text_[position_]) == NewickKind::blank) ++position_;
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
  while (!name.empty() && (name.back() == '=' || newick_kind(name.back()) == NewickKind::blank))
    name.remove_suffix(1);
  std::string kept(name);
  tree_ = {};
  tree_.name = std::move(kept);
  arity_.clear();
  tags_.clear();
  node_ = no_node;
}

void NewickReader::open() {
  if (open_.empty() && arity_.size() == 1 && arity_[0] == 0 && has_label_ && !has_length_) take_tree_name();
  if (node_ != no_node)
    refuse(position_, "a '(' after a node", "subtrees are parted by commas",
           "add the comma, or put quotes around labels that hold parentheses");
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
    if (peek() == ';') {
      finish();
      return std::move(tree_);
    }
    read_part();
  }
}

void NewickReader::read_part() {
  switch (peek()) {
    case '(':
      return open();
    case ')':
      return close();
    case ',':
      return comma();
    case ':':
      return length();
    case '{':
      return skip_braces();
    case ']':
      refuse(position_, "a ']' without its '['", "brackets hold comments", "remove it");
    case '\0':
      refuse(position_, "a zero byte", "this is no text", "give a text file of trees");
    default:
      return node_ != no_node && at_mark() ? skip_mark() : label();
  }
}

}  // namespace ramify::detail
