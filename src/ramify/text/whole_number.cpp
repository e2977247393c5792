#include "ramify/text/whole_number.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "ramify/core/number.hpp"
#include "ramify/text/trimmed.hpp"

namespace ramify {
namespace {

constexpr std::size_t most_digits = 40;

std::string_view without_leading_zeros(std::string_view digits) {
  return digits.substr(std::min(digits.find_first_not_of('0'), digits.size() - 1));
}

/// Digits with at most one decimal mark among them; nothing where there are others, or no digit.
struct Mantissa {
  std::string digits;
  std::size_t decimals = 0;
};

std::optional<Mantissa> mantissa_of(std::string_view text) {
  Mantissa mantissa;
  bool has_mark = false;
  for (const char c : text) {
    if (is_digit(c)) {
      mantissa.digits += c;
      if (has_mark) ++mantissa.decimals;
    } else if ((c == '.' || c == ',') && !has_mark) {
      has_mark = true;
    } else {
      return std::nullopt;
    }
  }
  if (mantissa.digits.empty()) return std::nullopt;
  return mantissa;
}

std::optional<int> exponent_of(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  int exponent = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), exponent);
  if (status != std::errc() || end != text.data() + text.size() || exponent < -40 || exponent > 40)
    return std::nullopt;
  return exponent;
}

/// Digits times a power of ten; nothing where that is no whole number.
std::optional<std::string> shifted(std::string digits, int power) {
  if (power >= 0) return digits.append(static_cast<std::size_t>(power), '0');
  const auto cut = std::min(digits.size(), static_cast<std::size_t>(-power));
  const std::string_view fraction = std::string_view(digits).substr(digits.size() - cut);
  if (fraction.find_first_not_of('0') != std::string_view::npos) return std::nullopt;
  digits.resize(digits.size() - cut);
  return digits.empty() ? "0" : digits;
}

}  // namespace

std::optional<std::string> whole_number(std::string_view field) {
  std::string_view text = trimmed(field);
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  const std::size_t mark = text.find_first_of("eE");
  const auto mantissa = mantissa_of(text.substr(0, mark));
  if (!mantissa || mantissa->digits.size() > most_digits) return std::nullopt;
  const auto exponent =
      mark == std::string_view::npos ? std::optional(0) : exponent_of(text.substr(mark + 1));
  if (!exponent) return std::nullopt;
  const auto digits = shifted(mantissa->digits, *exponent - static_cast<int>(mantissa->decimals));
  if (!digits) return std::nullopt;
  const std::string_view plain = without_leading_zeros(*digits);
  if (plain.size() > most_digits) return std::nullopt;
  return (negative && plain != "0" ? "-" : "") + std::string(plain);
}

bool is_missing(std::string_view field) {
  constexpr std::array<std::string_view, 11> words{"",     "na",   "<na>", "n/a",    "#n/a", "nan",
                                                   "-nan", "none", "null", "<null>", "nil"};
  constexpr std::size_t longest = 6;
  const std::string_view text = trimmed(field);
  if (text.size() > longest) return false;
  std::string lower;
  for (const char c : text) lower += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return std::ranges::find(words, lower) != words.end();
}

std::string_view IdKeys::operator()(std::string_view id) {
  const std::string_view text = trimmed(id);
  if (text.empty()) return text;
  if (std::ranges::all_of(text, is_digit)) return without_leading_zeros(text);
  if (!is_digit(text.front()) && text.find_first_of("+-.,") != 0) return text;
  auto number = whole_number(text);
  if (!number) return text;
  if (*number == text) return text;
  return own_.emplace_back(*std::move(number));
}

}  // namespace ramify
