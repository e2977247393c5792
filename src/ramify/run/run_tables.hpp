#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ramify/io/table.hpp"
#include "ramify/law/moments.hpp"
#include "ramify/run/cell_result.hpp"

namespace ramify {

/// The exact value beside a sampled mean, where a law is in reach: the mean, and how many standard errors the
/// sample lies off; of counts that few trees have what a normal variate as rare would
/// (compare/clumped_count.hpp).
struct ExactCheck {
  double exact_mean;
  double z;
};

/// Exact moments of one column of one model, at many more sizes than were sampled: what is drawn beneath the
/// points, which alone would hide how the mean oscillates between them.
struct ExactCurve {
  struct Point {
    double n;
    Moments moments;  ///< NaN where no law reaches, the variance also where only the mean is known
  };

  std::string model;
  StatisticColumn column;
  std::vector<Point> points;  ///< ascending n
};

/// A finished cell with its place in the plan (from 1) and, column by column, the exact checks.
struct CheckedCell {
  std::size_t number;
  CellResult result;
  std::vector<std::optional<ExactCheck>> checks;

  /// The largest |z| of the checks; nothing where there is none.
  std::optional<double> worst_z() const;
};

/// The cells of a run, held against exact laws, and the curves of these laws.
struct CheckedRun {
  std::vector<CheckedCell> cells;
  std::vector<ExactCurve> curves = {};  // NOLINT(readability-redundant-member-init): -Wextra wants it
};

/// summary.csv: a row for every column of every cell.
Table summary_table(const std::vector<CheckedCell>& cells);

/// orders.csv: mean counts and pooled ratios of every order, nodes and streams, leaf order 0.
Table orders_table(const std::vector<CheckedCell>& cells);

/// histograms.csv: how many trees had which value, where the support is small.
Table histograms_table(const std::vector<CheckedCell>& cells);

}  // namespace ramify
