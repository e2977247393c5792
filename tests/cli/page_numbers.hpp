#pragma once

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace ramify::test {

/// The cells of a row of a table in Markdown.
inline std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line.substr(1));
  for (std::string cell; std::getline(stream, cell, '|');) {
    const auto begin = cell.find_first_not_of(" `"), end = cell.find_last_not_of(" `");
    cells.push_back(begin == std::string::npos ? "" : cell.substr(begin, end - begin + 1));
  }
  return cells;
}

/// One in the last digit of a printed number: 0.01 of "3.14", 1e5 of "1.2e6".
inline double last_digit(const std::string& printed) {
  const auto power = printed.find('e'), point = printed.find('.');
  const std::string digits = printed.substr(0, power);
  const double decimals = point == std::string::npos ? 0 : static_cast<double>(digits.size() - point - 1);
  const double exponent = power == std::string::npos ? 0 : std::stod(printed.substr(power + 1));
  return std::pow(10, exponent - decimals);
}

/// Whether a printed number is this one, rounded.
inline bool is_rounded(const std::string& printed, double value) {
  return std::abs(std::stod(printed) - value) <= 0.501 * last_digit(printed);
}

}  // namespace ramify::test
