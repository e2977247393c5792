#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "ramify/core/cancellation.hpp"
#include "ramify/law/graft_table.hpp"
#include "ramify/model/model.hpp"
#include "ramify/random/uniform.hpp"
#include "ramify/sample/mean_counts.hpp"

namespace ramify {

/// What is grafted on trees of mean counts: orders from their law, and the mean counts given them.
///
/// Every size of its own to some 270; beyond, from OrderGrid, at numbers of leaves that go up by a hundredth:
/// a subtree between two of them has the law of one or the other, by chances that make its mean number of
/// leaves right. Probabilities of orders are changed by less than 1e-4 (docs/grafting.md). A model without
/// large laws has every size of its own.
class MeanCountsTable {
 public:
  /// The largest size that is grafted, whatever n.
  static Size largest(const Model& model);

  /// Sizes 0..largest. Throws Interrupted. Cost: OrderGrid's, of some 0.1 s.
  MeanCountsTable(const Model& model, Size largest, const Cancellation& cancellation);

  Size sizes() const { return largest_ + 1; }

  /// Draws a whole tree of size 1 <= n < sizes(). Two or three words, O(1).
  template <class Urbg>
  MeanCounts::Value draw(Size n, Urbg& stream, MeanCounts& fold) const {
    const auto& drawn = table_.drawn(place(n, stream), stream);
    fold.add_tally(n, drawn.tally);
    return drawn.value;
  }

 private:
  using Table = GraftTable<MeanCounts::Value, MeanCounts::Tally>;

  void append_exact(const Model& model, Size last, const Cancellation& cancellation);
  void append_grid(const Model& model, const Cancellation& cancellation);

  template <class Urbg>
  std::size_t place(Size n, Urbg& stream) const {
    if (n < exact_) return n;
    const double leaves = static_cast<double>(n) + 1;
    const auto below =
        std::min(static_cast<std::size_t>(std::log(leaves / leaves_.front()) / step), leaves_.size() - 2);
    const double low = leaves_[below], high = leaves_[below + 1];
    return exact_ + below + (uniform_open(stream) * (high - low) < leaves - low ? 1 : 0);
  }

  static constexpr double step = 0.01;  ///< of log leaves

  Size largest_;
  Size exact_ = 0;              ///< sizes of their own
  std::vector<double> leaves_;  ///< of the places beyond
  Table table_;
};

}  // namespace ramify
