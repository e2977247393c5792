#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ramify {

/// Names of the nodes of a tree, by preorder place: one block of text, 8 bytes a node beside it, and nothing
/// where no node has a name.
class NodeNames {
 public:
  /// No node has a name.
  bool empty() const { return places_.empty(); }

  /// The name of a node, empty where it has none.
  std::string_view operator[](std::size_t node) const {
    if (node >= places_.size()) return {};
    return std::string_view(text_).substr(places_[node].begin, places_[node].size);
  }

  /// Names a node; a second name takes the place of the first. False where there would be more than 4 GB.
  bool set(std::size_t node, std::string_view name) {
    if (name.empty()) return true;
    if (text_.size() + name.size() > UINT32_MAX) return false;
    if (node >= places_.size()) places_.resize(node + 1);
    places_[node] = {static_cast<std::uint32_t>(text_.size()), static_cast<std::uint32_t>(name.size())};
    text_ += name;
    return true;
  }

 private:
  struct Place {
    std::uint32_t begin = 0, size = 0;
  };
  std::string text_;
  std::vector<Place> places_;
};

}  // namespace ramify
