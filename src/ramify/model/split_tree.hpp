#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <span>
#include <string_view>
#include <vector>

#include "ramify/model/split_law.hpp"
#include "ramify/random/alias_table.hpp"

namespace ramify {

/// A split tree as a grammar (A5): size 0 is external; size n >= 1 is internal with children L and n-1-L, L
/// from the law.
///
/// Where the law asks for it, sizes up to `table_size` are drawn from alias tables of its exact pmf: one word
/// and one look-up in place of a beta or binomial variate. Most nodes are that small (97 of 100 in a BST), so
/// it decides the speed; the law is the same to within 2^-53. The tables are shared by copies.
template <class Law>
class SplitTree {
 public:
  using Label = Size;
  static constexpr std::string_view label_meaning = "internal nodes from it down";

  // 128 sizes are 132 kB: they stay in a second-level cache (bench/table_bench.cpp).
  static constexpr Size default_table_size = 128;

  explicit SplitTree(Law law, Size table_size = default_table_size) : law_(std::move(law)) {
    if constexpr (Law::uses_table) {
      table_size_ = table_size;
      build_tables();
    }
  }

  const Law& law() const { return law_; }

  bool is_external(Size n) const { return n == 0; }

  template <class Urbg>
  Pair<Size> children(Size n, Urbg& stream) const {
    const Size left = left_size(n, stream);
    return {left, n - 1 - left};
  }

 private:
  template <class Urbg>
  Size left_size(Size n, Urbg& stream) const {
    if (n == 1) return 0;
    if constexpr (Law::uses_table) {
      if (n <= table_size_) return draw_alias(std::span(cells_ + offset(n), n), stream);
    }
    return law_.left(n, stream);
  }

  static std::size_t offset(Size n) { return n * (n - 1) / 2; }

  void build_tables() {
    auto cells = std::make_shared<std::vector<AliasCell>>(offset(table_size_ + 1));
    for (Size n = 1; n <= table_size_; ++n)
      build_alias_cells(split_pmf(law_, n), std::span(*cells).subspan(offset(n), n));
    owner_ = std::move(cells);
    cells_ = owner_->data();
  }

  Law law_;
  Size table_size_ = 0;
  std::shared_ptr<const std::vector<AliasCell>> owner_;
  const AliasCell* cells_ = nullptr;
};

}  // namespace ramify
