#include "ramify/family/require_binary.hpp"

#include <fmt/format.h>

#include "ramify/core/error.hpp"

namespace ramify {

void require_binary(std::size_t children, std::string_view where) {
  if (children == 2) return;
  throw Error(fmt::format("{}: a node with {} children", where, children),
              "families are fitted to binary trees", "contract one-child nodes, resolve forks of three");
}

}  // namespace ramify
