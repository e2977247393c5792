#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "ramify/large/size_grid.hpp"

namespace ramify {

/// P(V >= k) of a statistic at the places of a grid: for each place a window of values k between those that
/// are surely reached, where it is 1, and those that are not, where it is 0.
class TailTable {
 public:
  static constexpr std::size_t window = 256;

  explicit TailTable(std::size_t places) : spans_(places), tails_(places) {}

  /// The first value whose probability is kept: below and at k = certain it is 1.
  std::size_t certain(std::size_t place) const { return spans_[place].certain; }

  /// The last value whose probability is above 0.
  std::size_t last(std::size_t place) const { return spans_[place].last; }

  double at(std::size_t place, std::size_t k) const {
    if (k <= certain(place)) return 1;
    return k <= last(place) ? tails_[place][sure + (k - certain(place) - 1)] : 0;
  }

  /// Keeps P(V >= certain + 1), P(V >= certain + 2), ...; what is 1 to the last digit is not.
  void set(std::size_t place, std::size_t certain, const std::vector<double>& tail) {
    std::size_t is_sure = 0;
    while (is_sure < tail.size() && tail[is_sure] >= 1) ++is_sure;
    std::size_t count = std::min(window, tail.size() - is_sure);
    while (count > 0 && tail[is_sure + count - 1] == 0) --count;
    spans_[place] = {static_cast<std::uint32_t>(certain + is_sure),
                     static_cast<std::uint32_t>(certain + is_sure + count)};
    Tail& kept = tails_[place];
    kept.fill(0);
    std::fill_n(kept.begin(), sure, 1.0);
    std::copy_n(tail.begin() + static_cast<std::ptrdiff_t>(is_sure), count, kept.begin() + sure);
  }

  /// What stands at a place until it is set: a stencil that ends there gives it no weight.
  void expect(std::size_t place) {
    spans_[place] = spans_[place - 1];
    tails_[place] = tails_[place - 1];
  }

  /// out[i] = P(V >= first + i) by the stencil.
  void interpolate(const Stencil& stencil, std::size_t first, std::vector<double>& out) const {
    std::size_t lowest = certain(stencil.first), highest = lowest, last_of_all = 0;
    for (std::size_t r = 0; r < Stencil::width; ++r) {
      const Span span = spans_[stencil.first + r];
      lowest = std::min<std::size_t>(lowest, span.certain);
      highest = std::max<std::size_t>(highest, span.certain);
      last_of_all = std::max<std::size_t>(last_of_all, span.last);
    }
    if (last_of_all >= first && highest < first + sure && first + out.size() <= lowest + 1 + window) {
      add_all(stencil, first, out);
      return;
    }
    std::fill(out.begin(), out.end(), 0.0);
    if (last_of_all < first) return;
    for (std::size_t r = 0; r < Stencil::width; ++r)
      if (stencil.weight[r] != 0) add(stencil.weight[r], stencil.first + r, first, out);
  }

 private:
  static constexpr std::size_t sure = 8;  ///< values k = certain - 7..certain are kept too, each of P = 1
  struct Span {
    std::uint32_t certain = 0, last = 0;
  };
  using Tail = std::array<double, sure + window>;

  /// Where all that is asked for is kept at every place.
  void add_all(const Stencil& stencil, std::size_t first, std::vector<double>& out) const {
    std::array<const double*, Stencil::width> tails{};
    for (std::size_t r = 0; r < Stencil::width; ++r) {
      const std::size_t place = stencil.first + r;
      tails[r] = tails_[place].data() + (first + sure - certain(place) - 1);
    }
    const auto& w = stencil.weight;
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] = w[0] * tails[0][i] + w[1] * tails[1][i] + w[2] * tails[2][i] + w[3] * tails[3][i] +
               w[4] * tails[4][i] + w[5] * tails[5][i] + w[6] * tails[6][i] + w[7] * tails[7][i];
  }

  void add(double weight, std::size_t place, std::size_t first, std::vector<double>& out) const {
    const std::size_t end = first + out.size();
    const std::size_t certain_to = std::clamp(certain(place) + 1, first, end);
    const std::size_t known_to = std::clamp(last(place) + 1, first, end);
    for (std::size_t k = first; k < certain_to; ++k) out[k - first] += weight;
    for (std::size_t k = certain_to; k < known_to; ++k)
      out[k - first] += weight * tails_[place][sure + (k - certain(place) - 1)];
  }

  std::vector<Span> spans_;
  std::vector<Tail> tails_;
};

}  // namespace ramify
