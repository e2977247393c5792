#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ramify/core/error.hpp"
#include "ramify/fit/ratio_estimator.hpp"
#include "ramify/tree/grammar.hpp"

namespace ramify {

/// A size at which to fit, and where it comes from.
struct SizeChoice {
  Size n;              ///< internal nodes
  std::string source;  ///< "printed", "counted", "portion", "horton" or "user"
  std::string note;    ///< "from order 4", else empty
};

/// A ratio with half a unit of its last printed digit: 1.40 is 1.40 +- 0.005.
struct PrintedRatio {
  double value;
  double rounding;  ///< 0 where it was computed
};

/// One measured tree, or one published mean, reduced to what a fit of the bifurcation ratio needs.
struct RatioDatum {
  std::string name;
  SourceLocation where;
  /// What each estimator is to reproduce; none where the data cannot be a value of it. A printed ratio is
  /// offered to all, since publications seldom say which they mean; a table of stream counts has its own
  /// value of each streams estimator.
  std::array<std::optional<double>, ratio_estimator_count> observed;
  /// Likewise; of a table of counts its own pooled ratio and regression.
  std::array<std::optional<double>, law_estimator_count> observed_by_law;
  double ratio;  ///< R of the rule p = 1/R: the printed one, else the mean ratio of the streams
  std::vector<SizeChoice> sizes;  ///< none where the source prints no size
  PrintedRatio
      branching;  ///< R_B of the Murray exponent: the printed one, else the regression over the streams
  std::optional<PrintedRatio> diameter_ratio;  ///< R_D > 1
  std::string citation;
  std::string confidence;
  std::vector<std::string> warnings;  ///< one line each, for standard error
};

/// Reads measured data from a CSV file: one datum a row for a table of published ratios (columns name, ratio,
/// ...; docs/fitting.md), one datum a tree for a table of stream counts (order_counts.hpp), that of
/// `ramify measure` among them.
///
/// Throws Error with file:line:column for a column it does not know (the nearest named), a ratio that is not
/// above 2 (a stream of order k+1 begins where two of order k meet), orders that do not follow each other,
/// counts that do not fall.
std::vector<RatioDatum> read_ratio_data(const std::filesystem::path& path);

/// The text is a table of published ratios, or one of counts that lacks a column: its header has a ratio, an
/// order or a count.
bool is_ratio_table(std::string_view text);

/// The same from text; name is used in messages, and names the datum of a count table.
std::vector<RatioDatum> parse_ratio_data(std::string_view text, std::string_view name);

/// horton_size rounded; values above 2^62 are cut there (H5). R > 1, S >= 1
Size whole_horton_size(double ratio, std::uint64_t orders);

}  // namespace ramify
