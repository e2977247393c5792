#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "ramify/model/split_law.hpp"
#include "ramify/random/alias_table.hpp"

namespace ramify {

/// A split law of the user's own: P(left = i) of every size n from a table (`file(PATH)`).
///
/// The table is shared by copies; two laws are equal where their tables are. A draw is one alias look-up.
class TabulatedSplit {
 public:
  static constexpr bool uses_table = false;  // every size has an alias table here

  /// From a CSV file with the columns n, left, probability, in any order; other columns are ignored. What has
  /// no row has probability 0.
  ///
  /// Throws Error with file:line:column where n < 1, left > n-1, a probability is negative or no finite
  /// number, a pair (n, left) comes twice, a size between 2 and the largest has no row, or the probabilities
  /// of a size do not sum to 1 within 1e-9 (they are then scaled to 1). n = 1, where left is 0, may be left
  /// out. About 400 bytes a row while it is read, 32 after. O(rows log rows).
  static TabulatedSplit read(const std::filesystem::path& path);
  /// read() of the text of a file.
  static TabulatedSplit parse(std::string_view text, std::string_view name);

  /// The largest n of the table.
  Size largest_size() const { return table_->begins.size() - 2; }

  /// 2 <= n <= largest_size().
  template <class Urbg>
  Size left(Size n, Urbg& stream) const {
    const auto [begin, count] = row(n);
    return table_->lefts[begin + draw_alias(std::span(table_->cells).subspan(begin, count), stream)];
  }

  /// P(left = i), i = 0..n-1; 1 <= n <= largest_size().
  WeightWindow window(Size n, double cutoff) const;

  SplitCharacter character() const;
  static const ModelInfo& info();

  /// Of the probabilities: the same for every file that holds the same law.
  std::uint64_t content_hash() const { return table_->hash; }

  friend bool operator==(const TabulatedSplit& a, const TabulatedSplit& b);

 private:
  /// Row after row: the outcomes of positive probability, ascending.
  struct Table {
    std::vector<std::size_t> begins;  ///< of the row of n, n = 0..largest+1
    std::vector<Size> lefts;
    std::vector<double> probabilities;
    std::vector<AliasCell> cells;
    std::uint64_t hash = 0;
  };
  struct Row {
    std::size_t begin, count;
  };

  explicit TabulatedSplit(std::shared_ptr<const Table> table) : table_(std::move(table)) {}

  Row row(Size n) const { return {table_->begins[n], table_->begins[n + 1] - table_->begins[n]}; }

  std::shared_ptr<const Table> table_;
};

}  // namespace ramify
