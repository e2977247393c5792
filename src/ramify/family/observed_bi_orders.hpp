#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ramify/text/csv_reader.hpp"
#include "ramify/tree/tree.hpp"

namespace ramify {

/// How many nodes of one binary tree or of several have which orders below: all that the likelihood of a tree
/// grown by order depends on, given the order of its root. Leaf order 0.
///
/// A node of order k has children of the orders k and j < k, or two of order k-1, which is written j = k
/// (model/ramification_matrix.hpp).
class ObservedBiOrders {
 public:
  ObservedBiOrders() = default;

  /// O(nodes). Throws Error for a tree with a node of other than two children.
  /// @param where  names the tree in messages
  ObservedBiOrders(const Tree& tree, std::string_view where);

  /// Of a table of counts, CSV with the columns order, side, count (read_bi_order_counts): one tree or
  /// several together. How many roots there are of every order follows: streams of the order, less those that
  /// join a higher one from the side, less two for each stream of the next. Throws Error with
  /// file:line:column, and where more streams of an order are said to go on than there are.
  static ObservedBiOrders of_table(const CsvData& table);

  /// Those of a further tree, or of further trees: their likelihoods multiply.
  void add(const ObservedBiOrders& others);

  /// Nodes of order k with (k,j) below, j <= k, k = 1..largest_order().
  double count(std::size_t k, std::size_t j) const { return rows_[k - 1][j]; }

  /// Nodes of order k.
  double nodes(std::size_t k) const;

  /// Streams of order k, each of which begins at a node with two of order k-1 below.
  double streams(std::size_t k) const { return count(k, k); }

  /// Internal nodes of all orders.
  double all_nodes() const;

  /// Streams that end in the side of one i orders above, i >= 1.
  double side_branches(std::size_t i) const;

  /// Of the trees' roots, one by one, and the largest of them: 0 without a tree.
  std::span<const std::size_t> tree_orders() const { return tree_orders_; }
  std::size_t largest_order() const { return rows_.size(); }

 private:
  std::vector<std::vector<double>> rows_;  ///< of order k at k-1: k+1 numbers
  std::vector<std::size_t> tree_orders_;
};

/// The text is such a table: its header has order, side and count.
bool is_bi_order_table(std::string_view text);

}  // namespace ramify
