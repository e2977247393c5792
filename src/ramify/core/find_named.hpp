#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "ramify/core/nearest_name.hpp"

namespace ramify {

/// The entry of a list with that name. Throws Error, nearest names given, where there is none.
/// @param all   entries with a member that is their name
/// @param kind  what they are, as `ramify list` names them, without its s: "model"
template <class Range, class Entry>
const Entry& find_named(const Range& all, std::string_view Entry::* name_of, std::string_view name,
                        std::string_view kind) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Entry& e) { return e.*name_of == name; });
  if (found != all.end()) return *found;
  std::vector<std::string> known;
  for (const Entry& entry : all) known.emplace_back(entry.*name_of);
  refuse_name(kind, name, known);
}

}  // namespace ramify
