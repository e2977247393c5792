#include "ramify/large/large_levels.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include <Eigen/Core>

#include "ramify/core/contract.hpp"
#include "ramify/core/error.hpp"

namespace ramify {
namespace {

constexpr double not_followed = 1e-100;
constexpr double surely = 1 - 4e-15;  // the weights of a row sum to 1 but for that

double dot(const double* values, const std::array<double, Stencil::width>& weights) {
  using Eight = Eigen::Matrix<double, static_cast<int>(Stencil::width), 1>;
  return Eigen::Map<const Eight>(values).dot(Eigen::Map<const Eight>(weights.data()));
}

}  // namespace

LargeLevels::LargeLevels(const LevelJoin& join, const SizeGrid& grid, const CompressedRows& rows,
                         const Table& table, const Cancellation& cancellation)
    : grid_(&grid), grows_(join.grows) {
  prepare(join, rows, cancellation);
  std::vector<double> last(grid.places(), grows_ ? 1 : 0), values(grid.places());
  fill_table(table, 0, last);
  keep(last);
  for (std::size_t level = 1;; ++level) {
    if (cancellation.requested()) throw Interrupted();
    const bool more = next(table, level, last, values);
    keep(values);
    if (!more) break;
    std::swap(last, values);
  }
}

std::size_t LargeLevels::Hash::operator()(const Weights& weights) const {
  std::uint64_t mixed = 0;
  for (const double w : weights) mixed = (mixed ^ std::bit_cast<std::uint64_t>(w)) * 0x9E3779B97F4A7C15U;
  return static_cast<std::size_t>(mixed ^ (mixed >> 32));
}

std::uint32_t LargeLevels::kept(const Stencil& stencil) {
  const auto [found, is_new] =
      known_weights_.try_emplace(stencil.weight, static_cast<std::uint32_t>(weights_.size()));
  if (is_new) weights_.push_back(stencil.weight);
  return found->second;
}

void LargeLevels::prepare(const LevelJoin& join, const CompressedRows& rows,
                          const Cancellation& cancellation) {
  for (std::size_t place = grid_->first_new_point(); place < grid_->places(); ++place) {
    if (cancellation.requested()) throw Interrupted();
    begin_.push_back(places_.size());
    const CompressedRow row = rows.row(grid_->leaves(place));
    for (const SplitPlace& split : row.places) {
      const double larger = row.leaves - split.smaller;
      const Stencil of_smaller = grid_->of_child(place, split.smaller, split.log_smaller),
                    of_larger = grid_->of_child(place, larger, split.log_larger);
      Place& added = places_.emplace_back(Place{static_cast<std::uint32_t>(of_smaller.first),
                                                static_cast<std::uint32_t>(of_larger.first), kept(of_smaller),
                                                kept(of_larger), split.weight, split.weight, split.weight});
      if (!join.share) continue;
      added.of_smaller *= join.share(split.smaller, row.leaves);
      added.of_larger *= join.share(larger, row.leaves);
      added.of_both = 0;
    }
  }
  begin_.push_back(places_.size());
}

double LargeLevels::joined(std::size_t place, const std::vector<double>& last) const {
  const std::size_t row = place - grid_->first_new_point();
  double sum = 0;
  for (std::size_t p = begin_[row]; p < begin_[row + 1]; ++p) {
    const Place& split = places_[p];
    const double smaller = dot(last.data() + split.smaller, weights_[split.smaller_weights]);
    const double larger = dot(last.data() + split.larger, weights_[split.larger_weights]);
    sum += split.of_smaller * smaller + split.of_larger * larger - split.of_both * smaller * larger;
  }
  return sum;
}

void LargeLevels::fill_table(const Table& table, std::size_t level, std::vector<double>& values) const {
  for (Size n = 0; n <= grid_->table_size(); ++n) values[n] = table(n, level);
  for (std::size_t place = grid_->first_point(); place < grid_->first_new_point(); ++place) {
    const Stencil stencil = grid_->in_table(grid_->leaves(place));
    values[place] = std::clamp(dot(values.data() + stencil.first, stencil.weight), 0.0, 1.0);
  }
}

/// A level from the last one; false where nothing can follow. Beyond the first sizes, in a row, where the
/// event is as good as sure (impossible, where it falls with the size), it is so at all.
bool LargeLevels::next(const Table& table, std::size_t level, const std::vector<double>& last,
                       std::vector<double>& values) const {
  fill_table(table, level, values);
  std::size_t settled = 0;
  for (std::size_t place = grid_->first_new_point(); place < values.size(); ++place) {
    if (settled > 2 * Stencil::width) {
      values[place] = grows_ ? 1 : 0;
    } else if (grows_ && last[place] < not_followed) {
      values[place] = 0;  // an event of level k is one of level k-1
    } else if (!grows_ && last[place] >= surely) {
      values[place] = 1;  // the other way round
    } else {
      values[place] = std::clamp(joined(place, last), 0.0, 1.0);
      const bool is_settled = grows_ ? values[place] >= surely : values[place] < not_followed;
      settled = is_settled ? settled + 1 : 0;
    }
  }
  return grows_ ? std::ranges::any_of(values, [](double v) { return v >= 1e-30; })
                : std::ranges::any_of(values, [](double v) { return v < surely; });
}

void LargeLevels::keep(const std::vector<double>& values) {
  const double below = grows_ ? 0 : 1, above = 1 - below;
  std::size_t first = 0, end = values.size();
  while (first < end && values[first] == below) ++first;
  while (end > first && values[end - 1] == above) --end;
  levels_.push_back({first,
                     {values.begin() + static_cast<std::ptrdiff_t>(first),
                      values.begin() + static_cast<std::ptrdiff_t>(end)}});
}

std::vector<double> LargeLevels::levels(double leaves) const {
  const Stencil stencil = grid_->anywhere(leaves);
  std::vector<double> found;
  for (const Level& level : levels_) {
    std::array<double, Stencil::width> values{};
    for (std::size_t r = 0; r < Stencil::width; ++r) {
      const std::size_t place = stencil.first + r;
      if (place < level.first)
        values[r] = grows_ ? 0 : 1;
      else if (place - level.first >= level.values.size())
        values[r] = grows_ ? 1 : 0;
      else
        values[r] = level.values[place - level.first];
    }
    found.push_back(std::clamp(dot(values.data(), stencil.weight), 0.0, 1.0));
  }
  return found;
}

}  // namespace ramify
