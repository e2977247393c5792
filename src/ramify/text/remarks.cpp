#include "ramify/text/remarks.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/text/located_error.hpp"
#include "ramify/text/source_text.hpp"

namespace ramify {

std::string counted(std::size_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

void Remarks::ignore(std::string_view noun, std::string_view which, std::size_t count) {
  if (count == 0) return;
  const auto found = std::ranges::find_if(
      counted_, [&](const Counted& part) { return part.noun == noun && part.which == which; });
  if (found != counted_.end()) {
    found->count += count;
  } else {
    counted_.push_back({std::string(noun), std::string(which), count});
  }
}

void Remarks::ignore_named(std::string_view noun, std::string_view name) {
  auto found = std::ranges::find(named_, noun, &Named::noun);
  if (found == named_.end()) found = named_.insert(named_.end(), {std::string(noun), {}});
  std::string said = one_line(excerpt(name));
  if (std::ranges::find(found->names, said) == found->names.end()) found->names.push_back(std::move(said));
}

void Remarks::doubt(std::string sentence) {
  if (std::ranges::find(doubts_, sentence) == doubts_.end()) doubts_.push_back(std::move(sentence));
}

std::vector<std::string> Remarks::lines(std::string_view file) const {
  constexpr std::size_t most_names = 8, most_doubts = 20;
  std::vector<std::string> lines, parts;
  for (std::size_t i = 0; i < std::min(doubts_.size(), most_doubts); ++i)
    lines.push_back(one_line(fmt::format("{}: {}", file, doubts_[i])));
  if (doubts_.size() > most_doubts)
    lines.push_back(one_line(fmt::format("{}: {} more such remarks", file, doubts_.size() - most_doubts)));
  for (const Counted& part : counted_)
    parts.push_back(
        fmt::format("{}{}{}", counted(part.count, part.noun), part.which.empty() ? "" : " ", part.which));
  for (const auto& [noun, names] : named_) {
    const std::size_t given = std::min(names.size(), most_names);
    std::string part =
        fmt::format("{}{} {}", noun, names.size() == 1 ? "" : "s",
                    fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(given), ", "));
    if (given < names.size()) part += fmt::format(" and {} more", names.size() - given);
    parts.push_back(std::move(part));
  }
  if (!parts.empty()) lines.push_back(one_line(fmt::format("{}: ignored: {}", file, fmt::join(parts, ", "))));
  return lines;
}

}  // namespace ramify
