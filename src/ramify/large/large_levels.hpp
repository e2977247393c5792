#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

#include "ramify/core/cancellation.hpp"
#include "ramify/large/compressed_rows.hpp"
#include "ramify/large/size_grid.hpp"

namespace ramify {

/// How P(event of level k) of a size follows from level k-1 of its children, and what it is where nothing
/// follows.
struct LevelJoin {
  /// The chance that the event of a child is that of its parent, from leaves of the child and of all; nothing
  /// where the event is that of either child: P(a) + P(b) - P(a) P(b).
  std::function<double(double child, double all)> share;
  bool grows = true;  ///< with the size; else it falls: 1 of small trees
};

/// P(V > h) of a height or depth, or P(V < k) of a fill level, at sizes of any magnitude: level after level,
/// for all places of the grid at once.
///
/// A level is known everywhere before the next one, so it is interpolated with centred stencils; one-sided
/// ones would grow waves. An upper tail is kept to 1e-100, for the front of a height is pulled by it. What is
/// linear in the level before is one sum over the grid, whatever the places of the row; products of both
/// children are taken where neither is below 1e-17. Rows of one shape are kept once. Cost: levels x places of
/// the grid where 0 < P < 1 x (places between a size and its smallest child, 0.5 ns each, and places of a row
/// that are products, 15 ns each).
class LargeLevels {
 public:
  /// P at level k = 0, 1, ... of a size of the table.
  using Table = std::function<double(Size n, std::size_t level)>;

  /// Goes on until the event is sure (or, where it grows with the size, impossible) at every size. Throws
  /// Interrupted.
  LargeLevels(const LevelJoin& join, const SizeGrid& grid, const CompressedRows& rows, const Table& table,
              const Cancellation& cancellation);

  /// P at level 0, 1, ... of a number of leaves on the grid.
  std::vector<double> levels(double leaves) const;

 private:
  using Weights = std::array<double, Stencil::width>;
  using Offset = std::int32_t;  ///< of a place from that of the row
  /// One of a row's splits where the event is that of either child: weight P(smaller) P(larger).
  struct Product {
    Offset smaller, larger;                         ///< first place of the stencil
    std::uint32_t smaller_weights, larger_weights;  ///< in weights_
    double weight;
  };
  /// P = sum of linear[i] P(place + first + i) - the sum of the products, the largest smaller child first.
  struct Row {
    Offset first = 0;
    std::vector<double> linear;
    std::vector<Product> products;
  };
  struct Level {
    std::size_t first;  ///< place of values[0]; 0 or 1 below, 1 or 0 above, as the event grows or falls
    std::vector<double> values;
  };
  struct Hash {
    std::size_t operator()(const Weights& weights) const;
  };

  void prepare(const LevelJoin& join, const CompressedRows& rows, const Cancellation& cancellation);
  Row prepared(const LevelJoin& join, const CompressedRow& row, std::size_t place);
  std::uint32_t kept(const Weights& weights);
  double joined(std::size_t place, std::size_t first, const std::vector<double>& last) const;
  double products(const Row& row, std::size_t place, const std::vector<double>& last) const;
  void fill_table(const Table& table, std::size_t level, std::vector<double>& values) const;
  bool next(const Table& table, std::size_t level, const std::vector<double>& last,
            std::vector<double>& values);
  void keep(const std::vector<double>& values);

  const SizeGrid* grid_;
  bool grows_;
  std::vector<Row> rows_;              ///< of different shapes
  std::vector<std::uint32_t> row_of_;  ///< of each new place
  std::vector<Weights> weights_;       ///< of stencils; those of one share are the same at all places
  std::unordered_map<Weights, std::uint32_t, Hash> known_weights_;
  std::size_t felt_from_ = 0, felt_to_ = 0;  ///< places where the last level is no less than 1e-17
  std::vector<Level> levels_;
};

}  // namespace ramify
