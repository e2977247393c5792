#include "ramify/large/compressed_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/LU>

#include "ramify/core/compensated_sum.hpp"
#include "ramify/core/contract.hpp"
#include "ramify/large/counting_rule.hpp"

namespace ramify {
namespace {

constexpr double ends = 48;               // leaves of a child that are summed one by one
constexpr double ends_of_residues = 128;  // the same where only every fourth size is known; a multiple of 4
constexpr double whole_to = 2000;         // leaves of a child, at most, on panels of whole numbers
constexpr double near_the_middle =
    0.47;                             // share where they end in small sizes: about 1/2 odd derivatives vanish
constexpr double widest_whole = 0.7;  // log of the ratio of such a panel's ends
constexpr double ties_to =
    1e14;  // leaves: beyond, ties of a binomial law weigh less than 1e-7, and a kink there 1e-14
constexpr double density_from = 1e17;  // leaves: shares of whole numbers are those of a density, to rounding

double log_sum(double a, double b) {
  const double high = std::max(a, b);
  if (std::isinf(high)) return high;
  return high + std::log1p(std::exp(-std::abs(a - b)));
}

/// log P(left, right) of any law.
LogWeight log_weight_of(const RealSplit& split) {
  if (const auto* smooth = std::get_if<SmoothSplit>(&split)) return smooth->log_weight;
  const auto binomial = std::get<BinomialSplit>(split);
  return [binomial](double left, double right) {
    const double trials = left + right - binomial.fewer;
    return BinomialSplit::log_weight(trials, binomial.p, left - binomial.at_least - binomial.p * trials);
  };
}

RealSplit real_split_of(const Model& model) {
  if (!model.is_split()) return {};
  return std::visit(
      []<class Law>(const Law& law) -> RealSplit {
        if constexpr (requires { law.real_split(); }) {
          return law.real_split();
        } else {
          return {};
        }
      },
      model.law());
}

constexpr int end_nodes = 8;
using EndValues = Eigen::Matrix<double, end_nodes, 1>;

/// Weights of values at whole distances `at` for the first, third and fifth derivative at 0: exact for
/// degree 7.
struct EndRule {
  EndValues at, first, third, fifth;
};

EndRule end_rule(const std::array<double, end_nodes>& at) {
  EndRule rule;
  Eigen::Matrix<double, end_nodes, end_nodes> powers;
  for (int r = 0; r < end_nodes; ++r) {
    rule.at[r] = at[static_cast<std::size_t>(r)];
    for (int d = 0; d < end_nodes; ++d) powers(d, r) = std::pow(rule.at[r], d);
  }
  const auto solver = powers.fullPivLu();
  rule.first = solver.solve(EndValues::Unit(1));
  rule.third = solver.solve(EndValues(6 * EndValues::Unit(3)));
  rule.fifth = solver.solve(EndValues(120 * EndValues::Unit(5)));
  return rule;
}

}  // namespace

/// Collects the places of one row.
class CompressedRows::Builder {
 public:
  Builder(const RealSplit& split, double leaves, std::optional<Residue> residue, double negligible)
      : log_weight_(log_weight_of(split)), leaves_(leaves), residue_(residue), negligible_(negligible) {
    const auto* smooth = std::get_if<SmoothSplit>(&split);
    scaled_ = smooth != nullptr && !smooth->sums_to_one;
    if (scaled_) reference_ = std::max(log_weight_(1, leaves - 1), log_weight_(leaves / 2, leaves / 2));
  }

  /// P of both splits, left and right exchanged.
  double weight(double smaller) const {
    const double larger = leaves_ - smaller;
    return std::exp(log_sum(log_weight_(smaller, larger), log_weight_(larger, smaller)) - reference_);
  }

  /// A place between whole numbers: all residues of it alike.
  void add(double smaller, double log_share, double factor) {
    add_weighed(factor * weight(smaller), smaller, log_share);
  }
  void add(double smaller, double factor) { add(smaller, std::log(smaller / leaves_), factor); }
  void add_weighed(double w, double smaller, double log_share) {
    if (std::abs(w) < negligible_) return;
    if (!residue_) {
      put(w, smaller, log_share, 0);
      return;
    }
    for (Residue q = 0; q < residues; ++q) put(w / residues, smaller, log_share, q);
  }

  /// A whole number of leaves.
  void add_whole(double smaller) {
    const double w = weight(smaller);
    if (w < negligible_) return;
    put(w, smaller, std::log(smaller / leaves_), static_cast<Residue>(std::fmod(smaller - 1, residues)));
  }

  /// Where the sums over whole numbers of every residue become integrals from half a number above
  /// ends_of_residues on: that of residue q begins at ends_of_residues + 1 + q, and stands for an integral
  /// from residues/2 below.
  void add_begin_of_residues() {
    if (!residue_) return;
    const double smaller = ends_of_residues + 0.5, w = weight(smaller),
                 log_share = std::log(smaller / leaves_);
    for (Residue q = 0; q < residues; ++q) put(w * (1.5 - q) / residues, smaller, log_share, q);
  }

  /// The same where smaller children end, half a number above the last: its parity follows from the residue
  /// of n.
  void add_end_of_residues() {
    const double smaller = last_smaller() * (1 - 1e-12);  // below a tie
    const double w = weight(smaller), log_share = std::log(smaller / leaves_);
    const int last = *residue_ % 2 == 1 ? (*residue_ - 1) / 2 - 1 : *residue_ / 2 - 1;
    for (Residue q = 0; q < residues; ++q)
      put(((q - last) % 2 == 0 ? 0.5 : -0.5) * w / residues, smaller, log_share, q);
  }

  /// Euler and Maclaurin where the sum over whole numbers ends below: g'/24 - 7 g'''/5760 + 31 g'''''/967680
  /// of what is summed.
  void add_lower_end(double smaller) {
    static const auto rule = end_rule({-4, -3, -2, -1, 1, 2, 3, 4});
    add_end(smaller, 1, rule);
  }

  /// And less of it where smaller children end; from below, for beyond them another child is the smaller one.
  void add_upper_end() {
    static const auto rule = end_rule({-1, -2, -3, -4, -5, -6, -7, -8});
    if (leaves_ < 1e12) add_end(last_smaller(), -1, rule);  // beyond it is below rounding
  }

  /// The split of an even n-1 into equal children, of the parity that the residue of n tells.
  void add_tie() {
    if (*residue_ % 2 == 0) return;
    const double w = weight(leaves_ / 2) / 2;
    for (const int q : {(*residue_ - 1) / 2, (*residue_ - 1) / 2 + 2}) {
      put(w / 2, leaves_ / 2, -std::numbers::ln2, static_cast<Residue>(q % residues));
      places_.back().equal = true;
    }
  }

  /// Where integrals over the smaller child end: half a number above the last that is smaller.
  double last_smaller() const { return residue_ && *residue_ % 2 == 1 ? leaves_ / 2 - 0.5 : leaves_ / 2; }

  CompressedRow finished() {
    std::vector<double> weights;
    for (const SplitPlace& place : places_) weights.push_back(place.weight);
    const double sum = compensated_sum(weights);
    for (SplitPlace& place : places_) place.weight /= sum;
    return {leaves_, std::move(places_), scaled_ ? 0 : std::abs(sum - 1)};
  }

 private:
  /// The sibling of a child of residue q has the residue of n - 1 - q.
  void put(double w, double smaller, double log_share, Residue q) {
    places_.push_back({w, smaller, log_share, std::log1p(-std::exp(log_share))});
    if (!residue_) return;
    places_.back().smaller_residue = q;
    places_.back().larger_residue = static_cast<Residue>((*residue_ + 2 * residues - 1 - q) % residues);
  }

  void add_end(double smaller, double sign, const EndRule& rule) {
    const double h = std::min(smaller / 200, 0.04 * std::sqrt(leaves_));
    for (int r = 0; r < end_nodes; ++r)
      add(smaller + h * rule.at[r],
          sign * (rule.first[r] / (24 * h) - 7 * rule.third[r] / (5760 * std::pow(h, 3)) +
                  31 * rule.fifth[r] / (967680 * std::pow(h, 5))));
  }

  LogWeight log_weight_;
  double leaves_;
  std::optional<Residue> residue_;
  double negligible_;
  bool scaled_ = false;
  double reference_ = 0;
  std::vector<SplitPlace> places_;
};

bool CompressedRows::exist(const Model& model) {
  return !std::holds_alternative<std::monostate>(real_split_of(model));
}

CompressedRows::CompressedRows(const Model& model, double step, double largest_leaves, LeftOut left_out)
    : split_(real_split_of(model)),
      step_(step),
      negligible_(left_out == LeftOut::below_1e_20 ? 1e-20 : 1e-42) {
  RAMIFY_EXPECTS(exist(model));
  const SplitFraction fraction = model.character().fraction;
  if (const auto* beta = std::get_if<BetaFraction>(&fraction)) {
    a_ = beta->a;
    b_ = beta->b;
    if (beta->is_density()) {
      mean_ = a_ / (a_ + b_);
      deviation_ = std::sqrt(mean_ * (1 - mean_) / (a_ + b_ + 1));
    }
  } else if (const auto* none = std::get_if<NoFraction>(&fraction)) {
    a_ = b_ = -none->depth_exponent;
    negligible_ = 1e-42;
  } else if (const auto* constant = std::get_if<ConstantFraction>(&fraction)) {
    mean_ = constant->p;
    deviation_ = std::sqrt(mean_ * (1 - mean_) / std::min(largest_leaves, ties_to));
  }
  edges_ = {-std::numbers::ln2};
  const double lowest = std::min(0.0, std::log(whole_to / largest_leaves)) - widest_whole;
  while (edges_.back() > lowest) edges_.push_back(edges_.back() - panel_width(edges_.back()));
  far_from_ = far_from(largest_leaves);
  if (far_from_ > largest_leaves) return;
  for (Residue q = 0; q < residues; ++q) far_[q] = row_in_full(far_from_, q);
  far_[residues] = row_in_full(far_from_, std::nullopt);
}

/// Infinity where no row up to the largest is far.
double CompressedRows::far_from(double largest_leaves) const {
  constexpr double never = std::numeric_limits<double>::infinity();
  if (std::holds_alternative<BinomialSplit>(split_)) return never;  // the scatter of shares falls with n
  for (double leaves = density_from; leaves <= largest_leaves; leaves *= 10) {
    const CompressedRow row = row_in_full(leaves, std::nullopt);
    if (std::ranges::all_of(row.places, [](const SplitPlace& place) { return place.smaller > whole_to; }))
      return leaves;
  }
  return never;
}

/// The widest panel, in the log of the share, on which ten points do.
double CompressedRows::panel_width(double log_share) const {
  const double share = std::exp(log_share), depth = -std::numbers::ln2 - log_share;
  double width = std::min(widest_whole, 16 * step_) * (1 + depth / 3);
  for (const double mean : {mean_, 1 - mean_})
    width = std::min(width, std::max(2 * deviation_, std::abs(share - mean) / 2) / share);
  for (const auto& [a, b] : {std::pair(a_, b_), std::pair(b_, a_)}) {
    const double slope = std::abs(a * (1 - share) - b * share) / (1 - share);
    // Where the weight at the ends is most of it, all of its panels count.
    if (a <= 0) width = std::min(width, 4 / slope);
    const double spread = 2 * std::sqrt(share * (1 - share) / (a + b + 1)) / share;
    if (a > 0) width = std::min(width, std::max(8 / slope, spread));
  }
  return width;
}

CompressedRow CompressedRows::binomial_row(const BinomialSplit& split, double leaves,
                                           std::optional<Residue> residue) const {
  constexpr int reach = 20;  // half standard deviations: a weight of e^-50
  Builder row(split_, leaves, residue, negligible_);
  const double trials = leaves - split.fewer;
  const double step = std::sqrt(trials * split.p * (1 - split.p)) / 2;
  for (int m = -reach; m <= reach; ++m) {
    // What is as far off weighs less than e^-18, where rows begin as early as those of stream_counts.
    if (std::min(trials * split.p + m * step, trials * (1 - split.p) - m * step) < 1) continue;
    const double w = step * std::exp(BinomialSplit::log_weight(trials, split.p, m * step));
    const double left = trials * split.p + m * step + split.at_least;
    const double smaller = std::min(left, leaves - left);
    row.add_weighed(w, smaller, std::log(smaller / leaves));
  }
  return row.finished();
}

/// From whole_below down to the last that is summed by itself.
void CompressedRows::add_whole_panels(Builder& row, double leaves, double last_alone,
                                      double whole_below) const {
  double high = whole_below;
  while (high > last_alone + 1) {
    const double width = std::min(widest_whole, panel_width(std::log(high / leaves)));
    const double low = std::max(last_alone + 1, std::floor(high * std::exp(-width)));
    const double count = high - low;
    if (count <= rule_points + 2) {
      for (double x = low; x < high; ++x) row.add(x, 1);
    } else {
      for (const RuleNode& node : counting_rule(count)) row.add(low + node.at, node.weight);
    }
    high = low;
  }
}

/// Between two shares, in logs; those of whole panels are the same at all sizes.
void CompressedRows::add_panels(Builder& row, double leaves, double bottom, double top) const {
  for (std::size_t e = 1; e < edges_.size() && top > bottom; ++e) {
    const double next = std::max(edges_[e], bottom);
    if (next >= top) continue;
    for (const RuleNode& node : unit_rule()) {
      const double log_share = next + (top - next) * node.at;
      const double smaller = leaves * std::exp(log_share);
      row.add(smaller, log_share, node.weight * (top - next) * smaller);
    }
    top = next;
  }
}

CompressedRow CompressedRows::row(double leaves, std::optional<Residue> residue) const {
  if (!is_far(leaves)) return row_in_full(leaves, residue);
  CompressedRow row = far_[residue.value_or(residues)];
  const double scale = leaves / row.leaves;
  row.leaves = leaves;
  for (SplitPlace& place : row.places) place.smaller *= scale;
  return row;
}

CompressedRow CompressedRows::row_in_full(double leaves, std::optional<Residue> residue) const {
  RAMIFY_EXPECTS(leaves >= 4 * (residue ? ends_of_residues : ends));
  if (const auto* binomial = std::get_if<BinomialSplit>(&split_)) {
    const double deviation = std::sqrt(mean_ * (1 - mean_) * leaves);
    const bool ties = leaves <= ties_to && std::abs(mean_ - 0.5) * leaves < 14 * deviation;
    if (!residue || !ties) return binomial_row(*binomial, leaves, residue);
  }
  Builder row(split_, leaves, residue, negligible_);
  const double whole_below = std::floor(std::min(whole_to, near_the_middle * leaves));
  const double last_alone = residue ? ends_of_residues : ends;
  for (double smaller = 1; smaller <= last_alone; ++smaller) row.add_whole(smaller);
  row.add_begin_of_residues();
  add_whole_panels(row, leaves, last_alone, whole_below);
  row.add_lower_end(whole_below - 0.5);
  add_panels(row, leaves, std::log((whole_below - 0.5) / leaves), std::log(row.last_smaller() / leaves));
  if (residue) {
    row.add_upper_end();
    row.add_end_of_residues();
    row.add_tie();
  }
  return row.finished();
}

}  // namespace ramify
