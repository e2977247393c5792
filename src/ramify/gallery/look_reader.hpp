#pragma once

#include "ramify/draw/tree_look.hpp"
#include "ramify/gallery/rules_reader.hpp"

namespace ramify::detail {

/// How a panel is drawn, from its keys look and view. Throws Error with the place.
TreeLook read_look(const FindKey& find);

}  // namespace ramify::detail
