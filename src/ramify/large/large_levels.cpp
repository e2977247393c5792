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
constexpr double not_felt = 1e-17;     // beside 1
constexpr double adds_little = 1e-22;  // of P of the size itself: some thousand places, P of the next level
constexpr double surely = 1 - 4e-15;   // the weights of a row sum to 1 but for that

std::size_t moved(std::size_t place, std::int32_t offset) {
  return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(place) + offset);
}

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

std::uint32_t LargeLevels::kept(const Weights& weights) {
  const auto [found, is_new] =
      known_weights_.try_emplace(weights, static_cast<std::uint32_t>(weights_.size()));
  if (is_new) weights_.push_back(weights);
  return found->second;
}

void LargeLevels::prepare(const LevelJoin& join, const CompressedRows& rows,
                          const Cancellation& cancellation) {
  bool last_is_far = false;
  for (std::size_t place = grid_->first_new_point(); place < grid_->places(); ++place) {
    if (cancellation.requested()) throw Interrupted();
    const double leaves = grid_->leaves(place);
    // Near the upper end of the grid the stencils are moved inside.
    const bool is_far = rows.is_far(leaves) && place + Stencil::width < grid_->places();
    if (!is_far || !last_is_far) rows_.push_back(prepared(join, rows.row(leaves), place));
    row_of_.push_back(static_cast<std::uint32_t>(rows_.size() - 1));
    last_is_far = is_far;
  }
}

LargeLevels::Row LargeLevels::prepared(const LevelJoin& join, const CompressedRow& row, std::size_t place) {
  struct Term {
    Offset first;
    Weights weights;
  };
  Row prepared;
  std::vector<Term> terms;
  const auto add = [&](const Stencil& stencil, double weight) {
    const auto first = static_cast<Offset>(stencil.first) - static_cast<Offset>(place);
    Term& term = terms.emplace_back(Term{first, stencil.weight});
    for (double& w : term.weights) w *= weight;
    return first;
  };
  for (const SplitPlace& split : row.places) {
    const double larger = row.leaves - split.smaller;
    const Stencil of_smaller = grid_->of_child(place, split.smaller, split.log_smaller),
                  of_larger = grid_->of_child(place, larger, split.log_larger);
    const auto share = [&](double child) { return join.share ? join.share(child, row.leaves) : 1.0; };
    const Offset at_smaller = add(of_smaller, split.weight * share(split.smaller));
    const Offset at_larger = add(of_larger, split.weight * share(larger));
    if (!join.share)
      prepared.products.push_back(
          {at_smaller, at_larger, kept(of_smaller.weight), kept(of_larger.weight), split.weight});
  }
  std::ranges::sort(prepared.products, std::ranges::greater(), &Product::smaller);
  const auto [low, high] = std::ranges::minmax(terms, {}, &Term::first);
  prepared.first = low.first;
  prepared.linear.resize(static_cast<std::size_t>(high.first - low.first) + Stencil::width);
  for (const Term& term : terms)
    for (std::size_t r = 0; r < Stencil::width; ++r)
      prepared.linear[static_cast<std::size_t>(term.first - low.first) + r] += term.weights[r];
  return prepared;
}

/// Children below the place `first` add nothing.
double LargeLevels::joined(std::size_t place, std::size_t first, const std::vector<double>& last) const {
  const Row& row = rows_[row_of_[place - grid_->first_new_point()]];
  const std::size_t begin = moved(place, row.first),
                    skipped = std::min(first > begin ? first - begin : 0, row.linear.size());
  const auto length = static_cast<Eigen::Index>(row.linear.size() - skipped);
  const Eigen::Map<const Eigen::VectorXd> linear(row.linear.data() + skipped, length),
      values(last.data() + begin + skipped, length);
  return linear.dot(values) - products(row, place, last);
}

double LargeLevels::products(const Row& row, std::size_t place, const std::vector<double>& last) const {
  double sum = 0;
  for (const Product& product : row.products) {
    const std::size_t smaller = moved(place, product.smaller), larger = moved(place, product.larger);
    if (smaller + Stencil::width <= felt_from_ || larger >= felt_to_) break;
    sum += product.weight * dot(last.data() + smaller, weights_[product.smaller_weights]) *
           dot(last.data() + larger, weights_[product.larger_weights]);
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
                       std::vector<double>& values) {
  const auto is_felt = [](double p) { return p >= not_felt; };
  felt_from_ = static_cast<std::size_t>(std::ranges::find_if(last, is_felt) - last.begin());
  felt_to_ = static_cast<std::size_t>(std::ranges::find_if(last.rbegin(), last.rend(), is_felt).base() -
                                      last.begin());
  fill_table(table, level, values);
  std::size_t settled = 0, first = grid_->first_new_point();  // places below it stand for sizes above it too
  for (std::size_t place = grid_->first_new_point(); place < values.size(); ++place) {
    if (settled > 2 * Stencil::width) {
      values[place] = grows_ ? 1 : 0;
    } else if (grows_ && last[place] < not_followed) {
      values[place] = 0;  // an event of level k is one of level k-1
    } else if (!grows_ && last[place] >= surely) {
      values[place] = 1;  // the other way round
    } else {
      if (grows_)  // a small child adds little to a tail that falls fast
        while (last[first] < adds_little * last[place]) ++first;
      const bool is_skipped = first > grid_->first_new_point();
      values[place] = std::clamp(joined(place, is_skipped ? first : 0, last), 0.0, 1.0);
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
