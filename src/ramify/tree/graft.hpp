#pragma once

#include "ramify/tree/grammar.hpp"

namespace ramify {

/// Nothing is grafted: every node is grown.
///
/// Requirements on a graft policy g, a label l of an internal node, a stream s and a fold f:
///   g.covers(l)       true where the subtree is not grown but drawn whole, from its exact law
///   g.draw(l, s, f)   the fold's value of such a subtree; adds its tally to the fold
/// covers must be cheap: it is asked at every node. It may also say true of external labels, which are never
/// drawn.
struct NoGraft {
  template <class Label>
  bool covers(const Label&) const {
    return false;
  }
  template <class Label, class Urbg, class F>
  auto draw(const Label&, Urbg&, F& fold) const {
    return fold.external();
  }
};

}  // namespace ramify
