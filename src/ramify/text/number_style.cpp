#include "ramify/text/number_style.hpp"

#include <algorithm>
#include <array>

#include "ramify/core/number.hpp"
#include "ramify/text/trimmed.hpp"
#include "ramify/text/whole_number.hpp"

namespace ramify {
namespace {

bool all_digits(std::string_view text) {
  return std::ranges::all_of(text, is_digit);
}

/// "1", "12" or "123", then groups of three digits, the mark between them; there is one at least.
bool is_grouped(std::string_view text, std::string_view mark) {
  std::size_t end = text.find(mark);
  if (end == std::string_view::npos || end == 0 || end > 3 || text.front() == '0') return false;
  if (!all_digits(text.substr(0, end))) return false;
  while (end < text.size()) {
    const std::size_t begin = end + mark.size();
    end = std::min(text.find(mark, begin), text.size());
    if (end - begin != 3 || !all_digits(text.substr(begin, 3))) return false;
  }
  return true;
}

std::string without(std::string_view text, std::string_view mark) {
  std::string kept;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(mark, begin), text.size());
    kept += text.substr(begin, end - begin);
    begin = end + mark.size();
  }
  return kept;
}

/// What stands in front of an exponent, without a sign and without marks of thousands that are no decimal
/// marks.
struct Parts {
  std::string sign, whole, exponent;
};

Parts parts_of(std::string_view field) {
  std::string_view text = trimmed(field);
  Parts parts;
  if (text.starts_with('-') || text.starts_with('+')) {
    if (text.front() == '-') parts.sign = "-";
    text.remove_prefix(1);
  }
  const std::size_t e = std::min(text.find_first_of("eE"), text.size());
  parts.exponent = text.substr(e);
  text = text.substr(0, e);
  // Blanks (also those of UTF-8 that do not break a line), apostrophes, low lines.
  constexpr std::array<std::string_view, 6> marks{" ", "'", "_", "\xC2\xA0", "\xE2\x80\xAF", "\xE2\x80\x99"};
  parts.whole = text;
  for (const std::string_view mark : marks) {
    const std::string_view integer = text.substr(0, text.find_first_of(".,"));
    if (!is_grouped(integer, mark)) continue;
    parts.whole = without(integer, mark) + std::string(text.substr(integer.size()));
    break;
  }
  return parts;
}

enum class Mark { none, point, comma, open, broken };

/// The decimal mark of a number, as far as the number itself tells: none where it has no mark, open where one
/// mark may be either, broken where it is no number. What has an exponent has no marks of thousands.
Mark decimal_mark(const Parts& parts, char& open_mark) {
  const std::string_view text = parts.whole;
  const auto points = std::ranges::count(text, '.'), commas = std::ranges::count(text, ',');
  if (points == 0 && commas == 0) return Mark::none;
  if (points > 0 && commas > 0) {
    const bool point_last = text.rfind('.') > text.rfind(',');
    const std::size_t last = std::max(text.rfind('.'), text.rfind(','));
    if ((point_last ? points : commas) != 1) return Mark::broken;
    if (!is_grouped(text.substr(0, last), point_last ? "," : ".")) return Mark::broken;
    return point_last ? Mark::point : Mark::comma;
  }
  const char mark = points > 0 ? '.' : ',';
  const bool grouped = is_grouped(text, std::string_view(&mark, 1));
  if (points + commas > 1) {
    if (!grouped) return Mark::broken;
    return mark == '.' ? Mark::comma : Mark::point;  // thousands: the other mark is the decimal one
  }
  open_mark = mark;
  if (grouped && parts.exponent.empty()) return Mark::open;
  return mark == '.' ? Mark::point : Mark::comma;
}

}  // namespace

void NumberStyle::see(std::string_view field) {
  char open = 0;
  const Mark mark = decimal_mark(parts_of(field), open);
  if (mark == Mark::point) decimal_point_ = true;
  if (mark == Mark::comma) decimal_comma_ = true;
}

bool NumberStyle::two_ways(std::string_view field, bool whole) const {
  char open = 0;
  if (decimal_mark(parts_of(field), open) != Mark::open) return false;
  if (decimal_point_ && decimal_comma_) return true;
  if (open == ',') return !decimal_point_ && !decimal_comma_;
  return whole && !decimal_comma_;
}

std::optional<std::string> NumberStyle::plain(std::string_view field) const {
  Parts parts = parts_of(field);
  char open = 0;
  Mark mark = decimal_mark(parts, open);
  if (mark == Mark::broken) return std::nullopt;
  if (mark == Mark::open) {
    if (two_ways(field, false)) return std::nullopt;
    mark = decimal_comma_ ? Mark::comma : Mark::point;
  }
  if (mark == Mark::point) parts.whole = without(parts.whole, ",");
  if (mark == Mark::comma) {
    parts.whole = without(parts.whole, ".");
    std::ranges::replace(parts.whole, ',', '.');
  }
  return parts.sign + parts.whole + parts.exponent;
}

std::optional<double> NumberStyle::real(std::string_view field) const {
  const auto number = plain(field);
  return number ? parse_real(*number) : std::nullopt;
}

std::optional<std::uint64_t> NumberStyle::count(std::string_view field) const {
  if (two_ways(field, true)) return std::nullopt;
  const auto number = plain(field);
  if (!number) return std::nullopt;
  const auto digits = whole_number(*number);
  return parse_count(digits ? *digits : *number);
}

}  // namespace ramify
