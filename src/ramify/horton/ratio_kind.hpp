#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace ramify {

/// How a ratio of neighbouring orders is taken from a sequence x_0..x_m.
enum class RatioKind : std::uint8_t { mean_ratio, pooled_ratio, regression, geometric };
inline constexpr std::array ratio_kinds{RatioKind::mean_ratio, RatioKind::pooled_ratio, RatioKind::regression,
                                        RatioKind::geometric};

/// "mean_ratio"
std::string_view name_of(RatioKind kind);

/// The ratio R of a sequence that rises like R^k: counts of streams from the highest order down, or mean
/// lengths, diameters, areas from the lowest up. mean_ratio, regression and geometric are those of
/// mean_ratios (stream_geometry.hpp); pooled_ratio is (x_1 + ... + x_m)/(x_0 + ... + x_(m-1)), of counts
/// alone. NaN where two values are not known, of pooled_ratio where any is not.
double ratio_of(RatioKind kind, std::span<const double> rising);

/// d log R / d log x_k, by central differences: what the delta method multiplies errors of the x_k with. 0 of
/// a value that is not known.
std::vector<double> log_slopes(RatioKind kind, std::span<const double> rising);

}  // namespace ramify
