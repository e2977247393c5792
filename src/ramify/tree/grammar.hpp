#pragma once

#include <array>
#include <concepts>
#include <cstdint>

namespace ramify {

/// Internal nodes of a subtree: the label of every split tree. At most 2^62.
using Size = std::uint64_t;
inline constexpr Size max_size = Size{1} << 62;

/// The labels of the two children of a node: {left, right}.
template <class Label>
using Pair = std::array<Label, 2>;

/// A random tree as a grammar: a node carries a label, the grammar draws the labels of its children.
///
/// Requirements on a grammar g, a label l and a stream of random words s:
///   g.is_external(l)   true where a node with this label has no children
///   g.children(l, s)   the labels of both children of an internal node, drawn from s; it may draw nothing
///                      where there is no choice. Only the label and s may decide.
/// A grammar is immutable: one object is shared by all threads.
template <class G, class Urbg>
concept Grammar = requires(const G& g, const typename G::Label& label, Urbg& stream) {
  { g.is_external(label) } -> std::convertible_to<bool>;
  { g.children(label, stream) } -> std::same_as<Pair<typename G::Label>>;
};

}  // namespace ramify
