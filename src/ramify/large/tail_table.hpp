#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "ramify/large/size_grid.hpp"

namespace ramify {

/// P(V >= k) of a statistic at the places of a grid: for each place a window of values k between those that
/// are surely reached, where it is 1, and those that are not, where it is 0.
class TailTable {
 public:
  static constexpr std::size_t window = 96;

  explicit TailTable(std::size_t places) : rows_(places) {}

  /// The first value whose probability is kept: below and at k = certain it is 1.
  std::size_t certain(std::size_t place) const { return rows_[place].certain; }

  /// The last value whose probability is above 0.
  std::size_t last(std::size_t place) const {
    const Row& row = rows_[place];
    std::size_t count = window;
    while (count > 0 && row.tail[count - 1] == 0) --count;
    return row.certain + count;
  }

  double at(std::size_t place, std::size_t k) const {
    const Row& row = rows_[place];
    if (k <= row.certain) return 1;
    return k - row.certain <= window ? row.tail[k - row.certain - 1] : 0;
  }

  /// Keeps P(V >= certain + 1), P(V >= certain + 2), ...; what is 1 to the last digit is not.
  void set(std::size_t place, std::size_t certain, const std::vector<double>& tail) {
    Row& row = rows_[place];
    std::size_t sure = 0;
    while (sure < tail.size() && tail[sure] >= 1) ++sure;
    row.certain = certain + sure;
    row.tail.fill(0);
    const std::size_t count = std::min(window, tail.size() - sure);
    std::copy_n(tail.begin() + static_cast<std::ptrdiff_t>(sure), count, row.tail.begin());
  }

  /// out[i] = P(V >= first + i) by the stencil.
  void interpolate(const Stencil& stencil, std::size_t first, std::vector<double>& out) const {
    std::fill(out.begin(), out.end(), 0.0);
    for (std::size_t r = 0; r < Stencil::width; ++r)
      if (stencil.weight[r] != 0) add(stencil.weight[r], rows_[stencil.first + r], first, out);
  }

 private:
  struct Row {
    std::size_t certain = 0;
    std::array<double, window> tail{};
  };

  static void add(double weight, const Row& row, std::size_t first, std::vector<double>& out) {
    const std::size_t end = first + out.size();
    const std::size_t sure = std::clamp(row.certain + 1, first, end);
    const std::size_t known = std::clamp(row.certain + 1 + window, first, end);
    for (std::size_t k = first; k < sure; ++k) out[k - first] += weight;
    if (sure == known) return;
    const double* tail = row.tail.data() + (sure - row.certain - 1);
    double* o = out.data() + (sure - first);
    for (std::size_t i = 0, count = known - sure; i < count; ++i) o[i] += weight * tail[i];
  }

  std::vector<Row> rows_;
};

}  // namespace ramify
