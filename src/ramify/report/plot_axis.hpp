#pragma once

#include <string>

namespace ramify::detail {

/// The range of an axis: widened value by value, then by a margin.
class PlotAxis {
 public:
  enum class Tics { any, whole };

  explicit PlotAxis(bool logarithmic, Tics tics = Tics::any) : logarithmic_(logarithmic), tics_(tics) {}

  bool holds(double value) const;
  void include(double value);
  /// Room around the values, as a part of their range on the axis.
  void pad(double part);
  /// No room below: bars stand on the axis.
  void begin_at(double low) { low_ = low; }

  double low() const { return low_; }
  double high() const { return high_; }

  /// gnuplot commands for the axis "x" or "y": range, scale and tics.
  std::string script(std::string_view name) const;

 private:
  bool logarithmic_;
  Tics tics_;
  bool empty_ = true;
  double low_ = 0;
  double high_ = 0;
};

/// A power of ten as a label: "100", or "10⁶" where plain is false.
std::string decade_label(int exponent, bool plain);

}  // namespace ramify::detail
