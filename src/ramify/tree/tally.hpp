#pragma once

#include <compare>
#include <concepts>

#include "ramify/tree/grammar.hpp"

namespace ramify {

/// The tally of a fold that has none.
struct NoTally {
  NoTally& operator+=(NoTally) { return *this; }
  friend auto operator<=>(const NoTally&, const NoTally&) = default;
};

/// A fold whose tally can be taken from it for a small tree and given back to it for a grafted one.
///
/// Requirements on a fold f of such a kind:
///   F::Tally            ordered, adds up with +=, value-initialised to nothing
///   F::largest_tallied  the largest tree that a Tally can hold
///   f.take_tally()      what join has added since the last call; that of external nodes is left out
///   f.add_tally(n, t)   adds a whole subtree with n internal nodes, its external nodes included
template <class F>
concept Tallied = requires(F& fold, Size n, const typename F::Tally& tally) {
  { fold.take_tally() } -> std::same_as<typename F::Tally>;
  fold.add_tally(n, tally);
  { F::largest_tallied } -> std::convertible_to<Size>;
};

template <class F>
struct TallyOfFold {
  using type = NoTally;
};
template <Tallied F>
struct TallyOfFold<F> {
  using type = typename F::Tally;
};
template <class F>
using TallyOf = typename TallyOfFold<F>::type;

template <class F>
constexpr Size largest_tallied() {
  if constexpr (Tallied<F>) {
    return F::largest_tallied;
  } else {
    return max_size;
  }
}

template <class F>
TallyOf<F> take_tally(F& fold) {
  if constexpr (Tallied<F>) {
    return fold.take_tally();
  } else {
    return {};
  }
}

template <class F>
void add_tally(F& fold, Size n, const TallyOf<F>& tally) {
  if constexpr (Tallied<F>) fold.add_tally(n, tally);
}

}  // namespace ramify
