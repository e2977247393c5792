#include "ramify/model/tabulated_split.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "ramify/core/number.hpp"
#include "ramify/model/model_info.hpp"
#include "ramify/model/split_table.hpp"
#include "ramify/random/hash.hpp"
#include "ramify/text/text_file.hpp"

namespace ramify {

TabulatedSplit TabulatedSplit::read(const std::filesystem::path& path) {
  return parse(read_text_file(path), path.string());
}

TabulatedSplit TabulatedSplit::parse(std::string_view text, std::string_view name) {
  auto table = std::make_shared<Table>();
  table->begins = {0};  // n = 0 has no row
  for (const auto& [n, left, probability] : read_split_table(CsvData::parse(text, name))) {
    table->begins.resize(n + 1, table->lefts.size());
    table->lefts.push_back(left);
    table->probabilities.push_back(probability);
    table->hash = hash_text(fmt::format("{},{},{};", n, left, format_exact(probability)), table->hash);
  }
  table->begins.push_back(table->lefts.size());
  table->cells.resize(table->lefts.size());
  for (Size n = 1; n + 1 < table->begins.size(); ++n) {
    const std::size_t begin = table->begins[n], count = table->begins[n + 1] - begin;
    build_alias_cells(std::span(table->probabilities).subspan(begin, count),
                      std::span(table->cells).subspan(begin, count));
  }
  return TabulatedSplit(std::move(table));
}

WeightWindow TabulatedSplit::window(Size n, double) const {
  std::vector<double> weights(n, 0.0);
  const auto [begin, count] = row(n);
  for (std::size_t i = begin; i < begin + count; ++i) weights[table_->lefts[i]] = table_->probabilities[i];
  return {0, std::move(weights)};
}

/// Whatever it holds: it may be chains. Between the first and the last entry of a row may be zeros: they cost
/// as much.
SplitCharacter TabulatedSplit::character() const {
  const Size reach = std::min<Size>(largest_size(), 2048);
  return {UnknownFraction(), false, {.nanoseconds = 8}, {reach, reach}};
}

const ModelInfo& TabulatedSplit::info() {
  static const ModelInfo info{.name = "file",
                              .parameters = {{.name = "PATH"}},
                              .given = "a CSV file n,left,probability; n up to its largest",
                              .description = "a split law of one's own: P(left) for every n of a table",
                              .source = "docs/own-models.md",
                              .make = [](const std::filesystem::path& path) -> AnyModel {
                                return AnySplitLaw(TabulatedSplit::read(path));
                              }};
  return info;
}

bool operator==(const TabulatedSplit& a, const TabulatedSplit& b) {
  return a.table_ == b.table_ ||
         (a.table_->begins == b.table_->begins && a.table_->lefts == b.table_->lefts &&
          a.table_->probabilities == b.table_->probabilities);
}

}  // namespace ramify
