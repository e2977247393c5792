#pragma once

#include <random>
#include <string>
#include <vector>

namespace ramify::test {

/// Writes a small file of trees in other ways that mean the same: line ends, separators, quotes, order of
/// columns, forms of numbers, comments where the format has them.
class Mutator {
 public:
  explicit Mutator(std::uint32_t seed) : random_(seed) {}

  /// @param name  of the file: its ending says what it is (newick, swc, mtg, csv; txt: numbers without a
  /// header)
  std::string mutated(const std::string& name, const std::string& text);

 private:
  using Rows = std::vector<std::vector<std::string>>;

  std::string newick(const std::string& text);
  std::string points(const std::string& text);
  std::string table(const std::string& text, bool has_header);
  std::string mtg(const std::string& text);

  std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }
  bool maybe(double p) { return std::bernoulli_distribution(p)(random_); }
  std::string whole(const std::string& number);
  std::string real(const std::string& number, char decimal);
  std::string missing();
  std::string joined(const Rows& rows, char separator, double quotes);
  std::string with_line_ends(const std::string& text);

  std::mt19937 random_;
};

}  // namespace ramify::test
