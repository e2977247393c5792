#pragma once

#include <variant>

#include "ramify/model/aldous.hpp"
#include "ramify/model/beta.hpp"
#include "ramify/model/beta_multinomial.hpp"
#include "ramify/model/bst.hpp"
#include "ramify/model/catalan.hpp"
#include "ramify/model/chain.hpp"
#include "ramify/model/complete.hpp"
#include "ramify/model/dst.hpp"
#include "ramify/model/fixed_split.hpp"
#include "ramify/model/ford.hpp"
#include "ramify/model/patricia.hpp"
#include "ramify/model/tabulated_split.hpp"

namespace ramify {

/// The split law of any model, in the order they are listed; std::visit gives the concrete type, so nothing
/// is virtual for each node.
using AnySplitLaw = std::variant<Bst, Beta, BetaMultinomial, FixedSplit, Dst, Patricia, Catalan, Aldous, Ford,
                                 Complete, Chain, TabulatedSplit>;

}  // namespace ramify
