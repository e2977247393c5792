#include "support/split_table_file.hpp"

#include <fmt/format.h>

#include "ramify/core/number.hpp"

namespace ramify::test {

std::string split_table_of(const Model& model, Size largest) {
  std::string text = "n,left,probability\n";
  for (Size n = 2; n <= largest; ++n) {
    const auto pmf = split_pmf(model, n);
    for (Size left = 0; left < n; ++left)
      if (pmf[left] > 0) text += fmt::format("{},{},{}\n", n, left, format_exact(pmf[left]));
  }
  return text;
}

}  // namespace ramify::test
