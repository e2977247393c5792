#include "ramify/tree/parenthesis_word.hpp"

#include <vector>

#include <fmt/format.h>

#include "ramify/core/error.hpp"

namespace ramify {
namespace {

[[noreturn]] void refuse(std::string_view where, std::size_t column, std::string_view why) {
  throw Error(fmt::format("{}:{}: not a tree", where, column), why,
              "write E for an external node and (LR) for an internal one, such as ((EE)E)");
}

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

}  // namespace

std::string to_parentheses(const Tree& tree) {
  std::string text;
  std::vector<std::uint32_t> missing;  // children still to come of every open node
  for (const std::uint32_t arity : tree.arities()) {
    if (arity > 0) {
      text += '(';
      missing.push_back(arity);
      continue;
    }
    text += 'E';
    while (!missing.empty() && --missing.back() == 0) {
      text += ')';
      missing.pop_back();
    }
  }
  return text;
}

Tree from_parentheses(std::string_view text, std::string_view where) {
  std::vector<std::uint32_t> arity;
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (is_space(c)) continue;
    if (c == ')') {
      if (open.empty()) refuse(where, i + 1, "a ')' without its '('");
      if (arity[open.back()] == 0) refuse(where, i + 1, "an internal node without children");
      open.pop_back();
      continue;
    }
    if (c != 'E' && c != '(') refuse(where, i + 1, fmt::format("'{}' is none of E, ( and )", c));
    if (open.empty() && !arity.empty()) refuse(where, i + 1, "more follows after the first tree");
    if (!open.empty()) ++arity[open.back()];
    if (c == '(') open.push_back(arity.size());
    arity.push_back(0);
  }
  if (!open.empty()) refuse(where, text.size(), fmt::format("{} '(' left open", open.size()));
  if (arity.empty()) refuse(where, 1, "no tree at all");
  return Tree(std::move(arity));
}

}  // namespace ramify
