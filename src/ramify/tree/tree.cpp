#include "ramify/tree/tree.hpp"

#include <algorithm>

namespace ramify {

bool Tree::is_well_formed(std::span<const std::uint32_t> arity) {
  std::uint64_t owed = 1;  // nodes that the word so far has promised and not yet given
  for (const std::uint32_t children : arity) {
    if (owed == 0) return false;
    owed += children;
    --owed;
  }
  return owed == 0;
}

Size Tree::size() const {
  return static_cast<Size>(
      std::count_if(arity_.begin(), arity_.end(), [](std::uint32_t k) { return k > 0; }));
}

}  // namespace ramify
