#pragma once

#include <cstdint>
#include <map>
#include <string_view>
#include <tuple>
#include <vector>

#include "ramify/format/mtg_header.hpp"
#include "ramify/text/number_style.hpp"
#include "ramify/text/remarks.hpp"

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

  MtgGraph(const SourceText& source, const MtgHeader& header, const NumberStyle& style, Remarks& remarks)
      : source_(source), header_(header), style_(style), remarks_(remarks) {}

  /// Adds the entities of a line, or with "*" what is measured at a later date of the last one of its column.
  /// An absolute name (in the first column, without "^") may repeat what is there already.
  void add_line(std::string_view line);

  /// Throws Error where a scene, the first entity without a class of its own, has no parts.
  void require_whole_scene() const;

  const std::vector<Vertex>& vertices() const { return vertices_; }

  /// Whether a vertex is a node of the tree at a scale; 0: those without parts.
  bool is_node(std::uint32_t vertex, unsigned scale) const;
  /// The node that a node hangs on at that scale; none for a root.
  std::uint32_t parent(std::uint32_t vertex, unsigned scale) const;

 private:
  /// What stands in a column, from where its entities go on from the column before.
  struct Column {
    std::uint32_t last = none;
    std::map<unsigned, std::uint32_t> of_scale;  ///< the last entity of every scale
  };
  /// Where the code of a line goes on.
  struct Start {
    std::size_t column;
    bool same_column, absolute;
    std::uint32_t from;
  };

  Start start_of(std::string_view code, std::size_t column);
  std::uint32_t add_code(std::string_view code, const Start& start);
  std::uint32_t named_entity(std::string_view mark, std::string_view label, std::uint32_t from,
                             const Start& start, bool& is_old);
  std::uint32_t add_entity(std::string_view mark, std::string_view label, std::uint32_t from,
                           const Column* column);
  void add_later(std::size_t column, const std::vector<std::string_view>& fields);
  bool begins_with_entity(std::string_view code) const;
  void remark_no_code(const std::vector<std::string_view>& fields);
  std::uint32_t next_anchor(std::uint32_t vertex) const;
  std::uint32_t raised(std::uint32_t vertex, unsigned scale) const;
  std::uint32_t deepest_part(std::uint32_t vertex) const;
  unsigned scale_of_class(std::string_view label) const;
  const unsigned* known_scale(std::string_view label) const;
  void add_features(std::vector<std::string_view> fields, Vertex& vertex);
  void move_back(std::vector<std::string_view>& fields);

  SourceText source_;
  const MtgHeader& header_;
  NumberStyle style_;
  Remarks& remarks_;
  std::vector<Vertex> vertices_;
  std::vector<Column> columns_;
  std::map<std::tuple<std::uint32_t, char, std::string_view>, std::uint32_t>
      named_;  // by what it goes on from
};

}  // namespace ramify::detail
