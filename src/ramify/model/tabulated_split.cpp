#include "ramify/model/tabulated_split.hpp"

#include <fmt/format.h>

#include "ramify/core/number.hpp"
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

std::vector<double> TabulatedSplit::pmf(Size n) const {
  std::vector<double> weights(n, 0.0);
  const auto [begin, count] = row(n);
  for (std::size_t i = begin; i < begin + count; ++i) weights[table_->lefts[i]] = table_->probabilities[i];
  return weights;
}

bool operator==(const TabulatedSplit& a, const TabulatedSplit& b) {
  return a.table_ == b.table_ ||
         (a.table_->begins == b.table_->begins && a.table_->lefts == b.table_->lefts &&
          a.table_->probabilities == b.table_->probabilities);
}

}  // namespace ramify
