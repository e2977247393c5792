#include "ramify/large/large_join.hpp"

#include <algorithm>
#include <array>

#include "ramify/core/contract.hpp"
#include "ramify/core/error.hpp"
#include "ramify/statistic/horton_strahler.hpp"

namespace ramify {
namespace {

// An upper tail that is not followed further: the balance number's front is pulled by it.
constexpr double hardly = 1e-100;

}  // namespace

LargeJoin::LargeJoin(const JoinRule& rule, const SizeGrid& grid, const CompressedRows& rows,
                     const BoundedLaw& table, const Cancellation& cancellation)
    : rule_(&rule), grid_(&grid), tails_(rule.tells_ties() ? residues : 1, TailTable(grid.places())) {
  RAMIFY_EXPECTS(!rule.takes_the_lower());
  fill_from(table);
  PlacedRows placed(grid, rows);
  for (std::size_t place = grid.first_new_point(); place < grid.places(); ++place) {
    if (cancellation.requested()) throw Interrupted();
    extend(place, placed);
  }
}

LargeJoin::Sums::Sums(std::size_t levels) : known(levels), not_own(levels) {
  below_own.fill(Values(levels));
  own.fill(Values(levels));
}

/// The sizes of the table, and the lead of the grid within it. Each residue has sizes of the others filled in
/// between its own.
void LargeJoin::fill_from(const BoundedLaw& table) {
  const std::size_t top = HortonStrahler::largest_order(table.sizes() - 1);
  Values tail(top);
  for (std::size_t p = 0; p < classes(); ++p) {
    for (Size n = 0; n <= grid_->table_size(); ++n) {
      const bool own = classes() == 1 || n % residues == p || n < residue_reach;
      for (std::size_t k = 1; k <= top; ++k) {
        const SizeSeries& from = table.all_sizes(LawForm::from, static_cast<std::ptrdiff_t>(k));
        tail[k - 1] =
            own ? from[n] : between_residues(n, static_cast<Residue>(p), [&from](Size m) { return from[m]; });
      }
      tails_[p].set(n, 0, tail);
    }
    for (std::size_t place = grid_->first_point(); place < grid_->first_new_point(); ++place) {
      tails_[p].interpolate(grid_->in_table(grid_->leaves(place)), 1, tail);
      tails_[p].set(place, 0, tail);
    }
  }
}

void LargeJoin::extend(std::size_t place, PlacedRows& rows) {
  std::size_t first = tails_[0].certain(place - 1), last = tails_[0].last(place - 1);
  for (TailTable& tails : tails_) {
    tails.expect(place);
    first = std::min(first, tails.certain(place - 1));
    last = std::max(last, tails.last(place - 1));
  }
  ++first;
  const std::size_t levels = last + 2 - first;
  std::vector<Sums> sums;
  for (std::size_t p = 0; p < classes(); ++p) {
    const auto residue = classes() == 1 ? std::nullopt : std::optional(static_cast<Residue>(p));
    sums.push_back(this->sums(rows.row(place, residue), first, levels));
  }
  std::vector<Values> solved(classes());
  for (std::size_t level = 0; level < levels; ++level) {
    const Values tail = solve(sums, level, solved);
    for (std::size_t p = 0; p < classes(); ++p)
      solved[p].push_back(tail[p] < hardly ? 0 : std::min(tail[p], 1.0));
  }
  for (std::size_t p = 0; p < classes(); ++p) tails_[p].set(place, first - 1, solved[p]);
}

LargeJoin::Sums LargeJoin::sums(const std::vector<PlacedSplit>& row, std::size_t first, std::size_t levels) {
  Sums sums(levels);
  smaller_from_.resize(levels + 1);
  larger_from_.resize(levels + 1);
  const auto add = [&](const PlacedSplit& split) {
    tails_[split.larger_residue].interpolate(split.larger.others, first - 1, larger_from_);
    add_terms(split, sums);
  };
  std::vector<PlacedSplit> merged;
  for (const PlacedSplit& split : row) {
    const TailTable& tails = tails_[split.smaller_residue];
    if (tails.last(split.smaller.first + Stencil::width - 1) < first - 1 && split.weight > 0) {
      merge(split, merged);
      continue;
    }
    tails.interpolate(split.smaller, first - 1, smaller_from_);
    add(split);
  }
  std::ranges::fill(smaller_from_, 0.0);
  for (const PlacedSplit& split : merged) add(split);
  return sums;
}

/// Splits whose smaller child has none of the values asked for are one, where the larger is read off the same
/// places.
void LargeJoin::merge(const PlacedSplit& split, std::vector<PlacedSplit>& merged) {
  const auto same = std::ranges::find_if(merged, [&split](const PlacedSplit& other) {
    return other.larger.others.first == split.larger.others.first && other.equal == split.equal &&
           other.larger_residue == split.larger_residue;
  });
  if (same == merged.end()) {
    merged.push_back(split);
    return;
  }
  const double weight = same->weight + split.weight, share = split.weight / weight;
  const auto mix = [share](double& of, double other) { of += share * (other - of); };
  for (std::size_t r = 0; r < Stencil::width; ++r)
    mix(same->larger.others.weight[r], split.larger.others.weight[r]);
  mix(same->larger.own, split.larger.own);
  mix(same->larger.not_own, split.larger.not_own);
  same->weight = weight;
}

/// One split in all the ways of the rule.
void LargeJoin::add_terms(const PlacedSplit& split, Sums& sums) const {
  const OwnStencil& larger = split.larger;
  const std::size_t levels = sums.known.size();
  auto& own = sums.own[split.larger_residue];
  auto& below_own = sums.below_own[split.larger_residue];
  for (double& w : sums.not_own) w += split.weight * larger.not_own;
  for (const JoinTerm& term : split.equal ? rule_->upper_equal : rule_->upper_unequal) {
    const double* s = smaller_from_.data() + 1 + term.smaller_shift;
    const double* l = larger_from_.data() + 1 + term.larger_shift;
    const bool s_from = term.smaller == LawForm::from, l_below = term.larger == LawForm::below;
    const bool refers = larger.own != 0 && term.larger != LawForm::any;
    const double w = split.weight, w_own = w * larger.own * (l_below ? -1 : 1);
    for (std::size_t i = 0; i < levels; ++i) {
      const double smaller = s_from ? s[i] : 1 - s[i];
      const double other = term.larger == LawForm::any ? 1 : l_below ? 1 - l[i] : l[i];
      sums.known[i] += w * smaller * other;
    }
    if (!refers) continue;
    auto& coefficient = term.larger_shift == 0 ? own : below_own;
    for (std::size_t i = 0; i < levels; ++i) coefficient[i] += w_own * (s_from ? s[i] : 1 - s[i]);
    if (term.larger_shift == 0)
      for (std::size_t i = 0; i < levels; ++i) sums.not_own[i] += w_own * (s_from ? 1 - s[i] : s[i]);
  }
}

/// P(V >= first + level) of every residue, those below being solved.
LargeJoin::Values LargeJoin::solve(const std::vector<Sums>& sums, std::size_t level,
                                   const std::vector<Values>& solved) {
  ResidueSystem system;
  for (std::size_t p = 0; p < sums.size(); ++p) {
    system.known[p] = sums[p].known[level];
    for (std::size_t q = 0; q < sums.size(); ++q) {
      system.known[p] += sums[p].below_own[q][level] * (level == 0 ? 1 : solved[q][level - 1]);
      system.own[p][q] = sums[p].own[q][level];
    }
    system.not_own[p] = sums[p].not_own[level];
  }
  const auto all = system.solve(sums.size());
  return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(sums.size())};
}

std::vector<double> LargeJoin::tail(double n) const {
  const TailTable& tails = tails_[classes() == 1 ? 0 : residue_of(n)];
  const Stencil stencil = grid_->anywhere(n + 1);
  std::size_t last = 0;
  for (std::size_t r = 0; r < Stencil::width; ++r) last = std::max(last, tails.last(stencil.first + r));
  Values tail(last + 1);
  tails.interpolate(stencil, 0, tail);
  return tail;
}

}  // namespace ramify
