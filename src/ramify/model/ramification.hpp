#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "ramify/model/ramification_matrix.hpp"
#include "ramify/random/alias_table.hpp"
#include "ramify/tree/grammar.hpp"

namespace ramify {

struct ModelInfo;

/// Trees grown from a ramification matrix (A17): a node of order k has children of the orders k and j < k
/// with probability p(k,j), or two of order k-1 with probability p(k,k); the higher one left or right with a
/// fair coin. Leaf order 0; n is the order of the root. Viennot, Eyrolles, Janey and Arques 1989; Kruszewski
/// 1996, 4.2.4. The matrix is shared by copies.
class Ramification {
 public:
  using Label = std::uint32_t;
  static constexpr std::string_view label_meaning = "order, leaf order 0";

  /// Throws Error for a negative probability, a row that does not sum to 1 within 1e-9 (they are then scaled
  /// to 1), and p(k,k) = 0: the tree would never end. @param name  for messages
  Ramification(const RamificationMatrix& matrix, std::string_view name);

  Label root(Size n) const { return static_cast<Label>(n); }

  template <class Urbg>
  void children(Label order, Urbg& stream, std::vector<Label>& below) const {
    if (order == 0) return;
    const auto& row = matrix_->rows[order - 1];
    const auto side = static_cast<Label>(draw_alias(row, stream));
    if (side == order) {
      below.insert(below.end(), 2, order - 1);
    } else {
      const bool higher_left = (stream() >> 63) != 0;
      below.push_back(higher_left ? order : side);
      below.push_back(higher_left ? side : order);
    }
  }

  /// 2 E_n + 1 with E_k = (1 + the sum over j < k of p(k,j) E_j) / p(k,k) + 2 E_(k-1) internal nodes.
  double expected_nodes(Size n) const { return matrix_->expected_nodes[n]; }
  std::size_t largest_order(Size n) const { return n; }
  Size largest_size() const { return matrix_->rows.size(); }
  std::uint64_t content_hash() const { return matrix_->hash; }

 private:
  struct Matrix {
    std::vector<std::vector<AliasCell>> rows;
    std::vector<double> expected_nodes;  ///< of order 0, 1, ...
    std::uint64_t hash = 0;
  };
  std::shared_ptr<const Matrix> matrix_;
};

// The models whose trees are grown from a matrix: from one of a file, of Tokunaga numbers, of a Markov chain,
// of rows of two others.
const ModelInfo& ramification_info();
const ModelInfo& tokunaga_info();
const ModelInfo& markov_info();
const ModelInfo& hybrid_info();

}  // namespace ramify
