#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "ramify/format/mtg_header.hpp"

namespace ramify::detail {

/// The vertices of an MTG and how they hang together.
class MtgGraph {
 public:
  static constexpr std::uint32_t none = UINT32_MAX;

  struct Vertex {
    std::string_view label;  ///< part of the text
    unsigned scale;
    std::uint32_t complex;  ///< what it is a part of; none at the coarsest scale
    std::uint32_t anchor;   ///< what it follows or branches from; none where its complex says that
    std::uint32_t last_part = none;
    double length, radius, x, y, z;
  };

  MtgGraph(const SourceText& source, const MtgHeader& header) : source_(source), header_(header) {}

  /// Adds the entities of a line.
  void add_line(std::string_view line);

  const std::vector<Vertex>& vertices() const { return vertices_; }

  /// Whether a vertex is a node of the tree at a scale; 0: those without parts.
  bool is_node(std::uint32_t vertex, unsigned scale) const;
  /// The node that a node hangs on at that scale; none for a root.
  std::uint32_t parent(std::uint32_t vertex, unsigned scale) const;

 private:
  std::uint32_t add_entity(std::string_view mark, std::string_view label, std::uint32_t from);
  std::uint32_t next_anchor(std::uint32_t vertex) const;
  std::uint32_t raised(std::uint32_t vertex, unsigned scale) const;
  std::uint32_t deepest_part(std::uint32_t vertex) const;
  unsigned scale_of_class(std::string_view label) const;
  void add_features(const std::vector<std::string_view>& fields, Vertex& vertex) const;

  SourceText source_;
  const MtgHeader& header_;
  std::vector<Vertex> vertices_;
  std::vector<std::uint32_t> last_;  // entity of every column
};

}  // namespace ramify::detail
