#include "ramify/model/ramification.hpp"

#include <numeric>

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/core/number.hpp"
#include "ramify/model/model_info.hpp"
#include "ramify/random/hash.hpp"

namespace ramify {
namespace {

void require_row(const std::vector<double>& row, std::size_t order, std::string_view name) {
  const std::string problem = fmt::format("{}: row of order {}", name, order);
  require_distribution(problem, row);
  if (row.back() == 0)
    throw Error(problem, fmt::format("p({0},{0}) is 0: no stream of order {0} would ever end", order),
                "give the diagonal a positive probability");
}

constexpr std::string_view root_order = "order of the root, leaf order 0";

/// Internal nodes below and including a node of each order 0, 1, ...
std::vector<double> expected_internal(const RamificationMatrix& matrix) {
  std::vector<double> expected{0};
  for (const auto& row : matrix) {
    const double sides = std::inner_product(row.begin(), row.end() - 1, expected.begin(), 1.0);
    expected.push_back(sides / row.back() + 2 * expected.back());
  }
  return expected;
}

AnyModel grown_from(const RamificationMatrix& matrix, std::string_view name) {
  return grown_model(Ramification(matrix, name));
}

}  // namespace

Ramification::Ramification(const RamificationMatrix& matrix, std::string_view name) {
  auto filled = std::make_shared<Matrix>();
  for (std::size_t k = 1; k <= matrix.size(); ++k) {
    const auto& row = matrix[k - 1];
    require_row(row, k, name);
    build_alias_cells(row, filled->rows.emplace_back(row.size()));
    for (const double p : row) filled->hash = hash_text(format_exact(p) + ",", filled->hash);
  }
  for (const double internal : expected_internal(matrix)) filled->expected_nodes.push_back(2 * internal + 1);
  matrix_ = std::move(filled);
}

const ModelInfo& ramification_info() {
  static const ModelInfo info{
      .name = "ramification",
      .parameters = {{.name = "PATH"}},
      .given = "a CSV file order,side,probability[,leaf_order]; n up to its largest order",
      .n_counts = root_order,
      .description = "tree grown from a ramification matrix",
      .source = "A17; Viennot et al. 1989; docs/own-models.md",
      .make = [](const std::filesystem::path& path) -> AnyModel {
        return grown_from(read_ramification_matrix(path), path.string());
      },
      .is_split = false};
  return info;
}

const ModelInfo& tokunaga_info() {
  static const ModelInfo info{
      .name = "tokunaga",
      .parameters = {positive("a"), positive("c")},
      .n_counts = root_order,
      .description = "random self-similar tree with T_k = a c^(k-1) side branches k orders below",
      .source = "Tokunaga 1978; Kovchegov and Zaliapin 2018",
      .make = [](std::span<const double> v) -> AnyModel {
        require_domain(tokunaga_info(), v);
        return grown_from(tokunaga_matrix(v[0], v[1]), tokunaga_info().signature());
      },
      .is_split = false};
  return info;
}

const ModelInfo& markov_info() {
  static const ModelInfo info{
      .name = "markov",
      .parameters = {{.name = "PATH"}},
      .given = "a CSV file state,next,probability[,leaf_order]; n up to its largest state",
      .n_counts = root_order,
      .description =
          "Markov chain as a ramification matrix: states are orders, transitions to higher ones left "
          "out",
      .source = "A19; Le Mehaute 1991; docs/own-models.md",
      .make = [](const std::filesystem::path& path) -> AnyModel {
        return grown_from(read_markov_chain(path), path.string());
      },
      .is_split = false};
  return info;
}

const ModelInfo& hybrid_info() {
  static const ModelInfo info{
      .name = "hybrid",
      .parameters = {{.name = "PATH_A"}, {.name = "PATH_B"}, {.name = "AAB.."}},
      .given = "two matrices, and of which to take each row, the lowest order first",
      .n_counts = root_order,
      .description = "ramification matrix with rows of two others",
      .source = "A18; Kruszewski 1996, 4.2.4",
      .make = [](std::span<const std::string> v) -> AnyModel {
        return grown_from(hybrid_matrix(read_ramification_matrix(v[0]), read_ramification_matrix(v[1]), v[2]),
                          v[2]);
      },
      .is_split = false};
  return info;
}

}  // namespace ramify
