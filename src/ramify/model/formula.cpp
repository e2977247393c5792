#include "ramify/model/formula.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <muParser.h>

#include "ramify/core/error.hpp"

namespace ramify {
namespace {

/// muParser would take size = 5 for an assignment, and silently.
bool assigns(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '=') continue;
    const bool doubled = i + 1 < text.size() && text[i + 1] == '=';
    const bool compares = i > 0 && std::string_view("<>!").find(text[i - 1]) != std::string_view::npos;
    if (!doubled && !compares) return true;
    if (doubled) ++i;
  }
  return false;
}

}  // namespace

struct Formula::Compiled {
  mu::Parser parser;
  double depth = 1, size = 2, n = 2;

  explicit Compiled(const std::string& text) {
    parser.DefineVar("d", &depth);
    parser.DefineVar("size", &size);
    parser.DefineVar("n", &n);
    parser.SetExpr(text);
  }
};

Formula::Formula(std::string_view text, std::string_view where) : text_(text) {
  constexpr std::string_view remedy =
      "write numbers, d (depth, root 1), size (of the subtree), n (of the tree) and functions such as log(d)";
  const std::string problem = fmt::format("{} = '{}'", where, text);
  if (assigns(text)) throw Error(problem, "'=' would assign, not compare", "write == to compare");
  try {
    compiled_ = std::make_unique<Compiled>(text_);
    compiled_->parser.Eval();
  } catch (const mu::Parser::exception_type& error) {
    std::string why = error.GetMsg();
    std::replace(why.begin(), why.end(), '\n', ' ');
    throw Error(problem, why, remedy);
  }
}

Formula::Formula(const Formula& other)
    : text_(other.text_), compiled_(std::make_unique<Compiled>(other.text_)) {}
Formula::Formula(Formula&&) noexcept = default;
Formula::~Formula() = default;

double Formula::operator()(const NodePlace& node) {
  compiled_->depth = static_cast<double>(node.depth);
  compiled_->size = static_cast<double>(node.size);
  compiled_->n = static_cast<double>(node.n);
  return compiled_->parser.Eval();
}

}  // namespace ramify
