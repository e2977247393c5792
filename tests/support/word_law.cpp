#include "support/word_law.hpp"

#include <cmath>

#include "support/sanitized.hpp"
#include "support/seed.hpp"
#include <fmt/format.h>

#include "ramify/model/registry.hpp"
#include "ramify/tree/parenthesis_word.hpp"

namespace ramify::test {

WordLaw side_by_side(const std::vector<WordLaw>& laws) {
  WordLaw joined{{"", 1.0}};
  for (const WordLaw& law : laws) {
    WordLaw longer;
    for (const auto& [left, p] : joined)
      for (const auto& [right, q] : law) longer[left + right] += p * q;
    joined = std::move(longer);
  }
  return joined;
}

void add_node(const WordLaw& below, double weight, WordLaw& law) {
  for (const auto& [word, p] : below)
    if (weight > 0) law[word.empty() ? "E" : "(" + word + ")"] += weight * p;
}

double binomial(unsigned n, unsigned k, double p) {
  return std::exp(std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0) + k * std::log(p) +
                  (n - k) * std::log(1 - p));
}

WordLaw ternary_law(const std::function<double(double depth)>& p_at, unsigned size, unsigned depth) {
  if (size == 0) return {{"E", 1.0}};
  const double p = p_at(depth);
  double sum = 0;
  for (unsigned third = 0; third <= size / 2; ++third) sum += binomial(size, third, p);
  WordLaw law;
  for (unsigned third = 0; third <= size / 2; ++third) {
    const unsigned second = third > 0 ? third - 1 : 0;
    add_node(side_by_side({ternary_law(p_at, size - 1 - second - third, depth + 1),
                           ternary_law(p_at, second, depth + 1), ternary_law(p_at, third, depth + 1)}),
             binomial(size, third, p) / sum, law);
  }
  return law;
}

Goodness words_against(const std::string& text, Size n, const WordLaw& law, const std::string& what) {
  const Model model = Model::parse(text);
  const Cancellation never;
  std::map<std::string, std::uint64_t> seen;
  for (std::uint64_t replicate = 0; replicate < replicates(60'000); ++replicate) {
    Stream stream({seed_of("grown words"), model.stream_cell(n)}, replicate);
    ++seen[to_parentheses(model.grown().grow(n, stream, never))];
  }
  std::vector<std::uint64_t> counts;
  std::vector<double> probabilities;
  double rest = 1;
  for (const auto& [word, p] : law) {
    counts.push_back(seen[word]);
    probabilities.push_back(p);
    rest -= p;
    seen.erase(word);
  }
  counts.push_back(0);
  for (const auto& [word, count] : seen) counts.back() += count;
  constexpr double rounding = 1e-9;
  probabilities.push_back(rest > rounding ? rest : 0);
  return chi_square(fmt::format("{} n = {}, {} trees{}", text, n, law.size(), what), counts, probabilities);
}

}  // namespace ramify::test
