#include "ramify/report/plot_axis.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/core/number.hpp"

namespace ramify::detail {
namespace {

struct TicList {
  std::vector<std::string> entries;
  std::size_t labelled = 0;
};

/// Every 1, 2, .. 9 times a power of ten from low to high; labels on the digits given, and on each power.
TicList log_tics(double low, double high, std::string_view labelled_digits) {
  const int first = static_cast<int>(std::floor(std::log10(low)));
  const int last = static_cast<int>(std::floor(std::log10(high)));
  const bool plain = first >= -3 && last <= 4;
  TicList tics;
  for (int exponent = first; exponent <= last; ++exponent) {
    for (int digit = 1; digit <= 9; ++digit) {
      const std::string number = fmt::format("{}e{}", digit, exponent);
      const double value = parse_real(number).value_or(0);
      if (value < low || value > high) continue;
      if (labelled_digits.find(static_cast<char>('0' + digit)) == std::string_view::npos) {
        tics.entries.push_back(fmt::format("'' {} 1", number));
        continue;
      }
      ++tics.labelled;
      const std::string label = digit == 1 ? decade_label(exponent, plain)
                                : plain    ? format_summary(value)
                                           : fmt::format("{}·{}", digit, decade_label(exponent, false));
      tics.entries.push_back(fmt::format("'{}' {}", label, number));
    }
  }
  return tics;
}

/// Labels at equal steps of 1, 2 or 5 times a power of ten, 4 to 9 of them: for a log axis of less than a
/// decade.
TicList equal_tics(double low, double high) {
  const double wanted = (high - low) / 4;
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  const double step = wanted >= 5 * power ? 5 * power : wanted >= 2 * power ? 2 * power : power;
  TicList tics;
  for (double i = std::ceil(low / step); i * step <= high; ++i) {
    const std::string number = fmt::format("{:.6g}", i * step);
    tics.entries.push_back(fmt::format("'{0}' {0}", number));
    ++tics.labelled;
  }
  return tics;
}

}  // namespace

std::string decade_label(int exponent, bool plain) {
  if (plain) return format_summary(std::pow(10.0, exponent));
  static constexpr const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string label = exponent < 0 ? "10⁻" : "10";
  for (const char c : fmt::format("{}", std::abs(exponent))) label += digits[c - '0'];
  return label;
}

bool PlotAxis::holds(double value) const {
  return std::isfinite(value) && (!logarithmic_ || value > 0);
}

void PlotAxis::include(double value) {
  low_ = empty_ ? value : std::min(low_, value);
  high_ = empty_ ? value : std::max(high_, value);
  empty_ = false;
}

void PlotAxis::pad(double part) {
  if (logarithmic_) {
    const double room = low_ == high_ ? 2 : std::pow(high_ / low_, part);
    low_ /= room;
    high_ *= room;
  } else {
    const double around = low_ == 0 ? 1 : std::abs(low_) / 10;
    const double room = low_ == high_ ? around : (high_ - low_) * part;
    low_ -= room;
    high_ += room;
  }
}

std::string PlotAxis::script(std::string_view name) const {
  std::string text =
      fmt::format("set {}range [{:.6g}:{:.6g}]\nset format {} '%.10g'\n", name, low_, high_, name);
  if (!logarithmic_) {
    // Where the range is long gnuplot's own steps are whole anyway.
    if (tics_ == Tics::whole && high_ - low_ < 20) text += fmt::format("set {}tics 1\n", name);
    return text;
  }
  text += fmt::format("set logscale {}\n", name);
  TicList tics = log_tics(low_, high_, "1");
  if (tics.labelled < 3) tics = log_tics(low_, high_, "125");
  if (tics.labelled < 3) tics = equal_tics(low_, high_);
  return text + fmt::format("set {}tics ({})\n", name, fmt::join(tics.entries, ", "));
}

}  // namespace ramify::detail
