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

/// A fold that keeps a tally beside its values, and takes that of a grafted tree.
///
/// Requirements on a fold f of such a kind:
///   F::Tally            adds up with +=, value-initialised to nothing
///   f.add_tally(n, t)   adds a whole subtree with n internal nodes, its external nodes included
template <class F>
concept AddsTally = requires(F& fold, Size n, const typename F::Tally& tally) { fold.add_tally(n, tally); };

/// A fold whose tally can also be taken from it for a small tree, to build the law of it.
///
///   F::Tally            ordered
///   F::largest_tallied  the largest tree that a Tally can hold
///   f.take_tally()      what join has added since the last call; that of external nodes is left out
template <class F>
concept Tallied = AddsTally<F> && requires(F& fold) {
  { fold.take_tally() } -> std::same_as<typename F::Tally>;
  { F::largest_tallied } -> std::convertible_to<Size>;
};

template <class F>
struct TallyOfFold {
  using type = NoTally;
};
template <AddsTally F>
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
  if constexpr (AddsTally<F>) fold.add_tally(n, tally);
}

}  // namespace ramify
