#pragma once

#include <concepts>
#include <cstdint>
#include <span>

#include "ramify/tree/grammar.hpp"

namespace ramify {

/// A statistic as a fold: a value at an external node, and a join of the children's values.
///
/// Requirements on a fold f, with labels of children and their values as ranges of the same length (2 in a
/// split tree, any number in a measured one), left to right:
///   f.external()                     the value of an external node
///   f.join(label, labels, values)    the value of an internal node
/// Both may add to a tally that f carries (counts per order) and join may draw from a stream that f owns (the
/// walk to the last node). Values are small and trivially copyable: one is kept for every open node of a
/// growing tree. Nodes are joined in postorder, left before right.
template <class F, class Label>
concept Fold =
    std::is_trivially_copyable_v<typename F::Value> &&
    requires(F& f, const Label& label, const Pair<Label>& labels, const Pair<typename F::Value>& values) {
      { f.external() } -> std::same_as<typename F::Value>;
      { f.join(label, labels, values) } -> std::same_as<typename F::Value>;
    };

}  // namespace ramify
