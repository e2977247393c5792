#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "ramify/tree/grammar.hpp"

namespace ramify {

/// Where a node stands in its tree.
struct NodePlace {
  Size size;   ///< internal nodes from it down
  Size depth;  ///< of the root: 1
  Size n;      ///< size of the whole tree
};

/// A number as a formula of a node: of its depth d, its size, and the n of the whole tree.
///
/// muParser reads it: + - * / ^, comparisons, && and ||, a ? b : c, min, max, abs, sqrt, exp, log (natural),
/// log2, log10, sin and so on; all in double precision. An object is used by one thread at a time; a copy has
/// variables of its own. A value costs some 50 ns, a copy some microseconds.
class Formula {
 public:
  /// @param where  names the formula in messages: "node_beta(A,B) with A"
  /// Throws Error where it is no formula, names another variable, or assigns one.
  Formula(std::string_view text, std::string_view where);
  Formula(const Formula& other);
  Formula(Formula&&) noexcept;
  Formula& operator=(const Formula&) = delete;
  Formula& operator=(Formula&&) = delete;
  ~Formula();

  /// NaN or infinite where it is not defined.
  double operator()(const NodePlace& node);

  const std::string& text() const { return text_; }

 private:
  struct Compiled;
  std::string text_;
  std::unique_ptr<Compiled> compiled_;
};

}  // namespace ramify
