#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/model/branching.hpp"
#include "ramify/model/flow_rate.hpp"
#include "ramify/model/galton_watson.hpp"
#include "ramify/model/kary.hpp"
#include "ramify/model/node_dependent.hpp"
#include "ramify/model/ramification.hpp"
#include "ramify/model/registry.hpp"
#include "ramify/model/ternary.hpp"
#include "ramify/model/trie.hpp"

namespace ramify {
namespace {

AnyModel matrix_model(const RamificationMatrix& matrix, std::string_view name) {
  return grown_model(Ramification(matrix, name));
}

template <class Kind>
AnyModel node_dependent(std::span<const std::string> formulas) {
  return grown_model(NodeDependent<Kind>(formulas));
}

}  // namespace

std::string ModelInfo::signature() const {
  return parameters.empty() ? std::string(name) : fmt::format("{}({})", name, fmt::join(parameters, ","));
}

const std::vector<ModelInfo>& models() {  // NOLINT(readability-function-size): a table
  static const std::vector<ModelInfo> all{
      {"bst",
       {},
       internal_nodes,
       "none",
       "random binary search tree: left uniform on 0..n-1",
       "A14; Devroye 1986",
       [](std::span<const double>) -> AnyModel { return AnySplitLaw(Bst()); }},
      {"beta",
       {"a", "b"},
       internal_nodes,
       "a, b > 0; n <= 2^50",
       "left = floor(nX), X ~ beta(a,b)",
       "A5, A8; Kruszewski 1996, 2.5.2",
       [](std::span<const double> v) -> AnyModel { return AnySplitLaw(Beta(v[0], v[1])); }},
      {"beta_multinomial",
       {"a", "b"},
       internal_nodes,
       "a, b > 0; n <= 2^50",
       "left ~ Bin(n-1,X), X ~ beta(a,b)",
       "A8; Devroye 1986, 1998",
       [](std::span<const double> v) -> AnyModel { return AnySplitLaw(BetaMultinomial(v[0], v[1])); }},
      {"split",
       {"x"},
       internal_nodes,
       "0 < x < 1; n <= 2^50",
       "deterministic: left = floor(nx)",
       "A6; Kruszewski 1996, 2.5.1",
       [](std::span<const double> v) -> AnyModel { return AnySplitLaw(FixedSplit(v[0])); }},
      {"dst",
       {"p"},
       internal_nodes,
       "0 < p < 1; n <= 2^50",
       "digital search tree: left ~ Bin(n-1,p); the thesis's binomial tree",
       "A11, X16",
       [](std::span<const double> v) -> AnyModel { return AnySplitLaw(Dst(v[0])); }},
      {"patricia",
       {"p"},
       internal_nodes,
       "0 < p < 1; n <= 2^50",
       "PATRICIA on n+1 strings: left = K-1, K ~ Bin(n+1,p) given 1 <= K <= n",
       "A13; Kruszewski 1996, 3.2.2",
       [](std::span<const double> v) -> AnyModel { return AnySplitLaw(Patricia(v[0])); }},
      {"catalan",
       {},
       internal_nodes,
       "n <= 2^50",
       "equiprobable binary tree: left = i with C_i C_(n-1-i) / C_n",
       "A15; Flajolet, Raoult, Vuillemin 1979",
       [](std::span<const double>) -> AnyModel { return AnySplitLaw(Catalan()); }},
      {"aldous",
       {"beta"},
       internal_nodes,
       "beta > -2; n <= 2^50",
       "beta-splitting: k of m = n+1 leaves left with weight f(k) f(m-k), f(k) = Gamma(beta+1+k)/k!",
       "Aldous 1996",
       [](std::span<const double> v) -> AnyModel { return AnySplitLaw(Aldous(v[0])); }},
      {"complete",
       {},
       internal_nodes,
       "none",
       "complete tree: every level full but the last, which is filled from the left",
       "A3; Knuth 1997, 2.3.4.5",
       [](std::span<const double>) -> AnyModel { return AnySplitLaw(Complete()); }},
      {"chain",
       {},
       internal_nodes,
       "none",
       "left = 0 or n-1 by the toss of a coin",
       "A4; Viennot 1990",
       [](std::span<const double>) -> AnyModel { return AnySplitLaw(Chain()); }},
      {"file",
       {"PATH"},
       internal_nodes,
       "a CSV file n,left,probability; n up to its largest",
       "a split law of one's own: P(left) for every n of a table",
       "docs/own-models.md",
       [](const std::filesystem::path& path) -> AnyModel { return AnySplitLaw(TabulatedSplit::read(path)); }},
      {"trie",
       {"p"},
       "strings",
       "0 < p < 1; n <= 2^50",
       "trie of n random bit strings, one-child nodes kept; patricia(p) is without them",
       "A12; Kruszewski 1996, B.1.1",
       [](std::span<const double> v) -> AnyModel { return grown_model(Trie(v[0])); },
       false},
      {"ternary",
       {"p"},
       internal_nodes,
       "0 < p <= 1/3; n <= 2^50",
       "three children of sizes n-1-X-max(X-1,0), max(X-1,0), X; X ~ Bin(n,p) given that all are >= 0",
       "A22, A23; Kruszewski 1996, 3.3.3",
       [](std::span<const double> v) -> AnyModel { return grown_model(Ternary(v[0])); },
       false,
       false},
      {"node_beta",
       {"A", "B"},
       internal_nodes,
       "formulas of d, size, n; A, B > 0; n <= 2^50",
       "left = floor(size X), X ~ beta(A,B), A and B formulas of the node",
       "A10; Kruszewski 1996, 2.5.5; docs/own-models.md",
       node_dependent<NodeBeta>,
       false},
      {"node_split",
       {"X"},
       internal_nodes,
       "a formula of d, size, n; 0 < X < 1; n <= 2^50",
       "left = floor(size X), X a formula of the node",
       "A6, A10; docs/own-models.md",
       node_dependent<NodeSplit>,
       false},
      {"node_dst",
       {"P"},
       internal_nodes,
       "a formula of d, size, n; 0 < P < 1; n <= 2^50",
       "left ~ Bin(size-1,P), P a formula of the node",
       "A11, A24; docs/own-models.md",
       node_dependent<NodeDst>,
       false},
      {"node_ternary",
       {"P"},
       internal_nodes,
       "a formula of d, size, n; 0 < P <= 1/3; n <= 2^50",
       "ternary(P), P a formula of the node",
       "A24; Kruszewski 1996, 3.3.4; docs/own-models.md",
       node_dependent<NodeTernary>,
       false,
       false},
      {"branching",
       {"p0", "p1", "p2"},
       "generations",
       "p0, p1, p2 >= 0, sum 1",
       "Galton-Watson process of 0, 1 or 2 children, limited to n generations",
       "A20; Kruszewski 1996, 4.2.5",
       [](std::span<const double> v) -> AnyModel { return grown_model(Branching(v[0], v[1], v[2])); },
       false},
      {"galton_watson",
       {"p0", "p1", "p2"},
       "nodes, external ones counted",
       "p0, p2 > 0, p1 >= 0, sum 1; n odd where p1 = 0",
       "Galton-Watson tree of 0, 1 or 2 children given its number of nodes",
       "A20; Dvoretzky and Motzkin 1947",
       [](std::span<const double> v) -> AnyModel {
         return std::make_shared<const GaltonWatson>(v[0], v[1], v[2]);
       },
       false},
      {"tokunaga",
       {"a", "c"},
       "order of the root, leaf order 0",
       "a, c > 0",
       "random self-similar tree with T_k = a c^(k-1) side branches k orders below",
       "Tokunaga 1978; Kovchegov and Zaliapin 2018",
       [](std::span<const double> v) -> AnyModel {
         return matrix_model(tokunaga_matrix(v[0], v[1]), "tokunaga(a,c)");
       },
       false},
      {"ramification",
       {"PATH"},
       "order of the root, leaf order 0",
       "a CSV file order,side,probability[,leaf_order]; n up to its largest order",
       "tree grown from a ramification matrix",
       "A17; Viennot et al. 1989; docs/own-models.md",
       [](const std::filesystem::path& path) -> AnyModel {
         return matrix_model(read_ramification_matrix(path), path.string());
       },
       false},
      {"hybrid",
       {"PATH_A", "PATH_B", "AAB.."},
       "order of the root, leaf order 0",
       "two matrices, and of which to take each row, the lowest order first",
       "ramification matrix with rows of two others",
       "A18; Kruszewski 1996, 4.2.4",
       [](std::span<const std::string> v) -> AnyModel {
         return matrix_model(
             hybrid_matrix(read_ramification_matrix(v[0]), read_ramification_matrix(v[1]), v[2]), v[2]);
       },
       false},
      {"markov",
       {"PATH"},
       "order of the root, leaf order 0",
       "a CSV file state,next,probability[,leaf_order]; n up to its largest state",
       "Markov chain as a ramification matrix: states are orders, transitions to higher ones left out",
       "A19; Le Mehaute 1991; docs/own-models.md",
       [](const std::filesystem::path& path) -> AnyModel {
         return matrix_model(read_markov_chain(path), path.string());
       },
       false},
      {"kary",
       {"k"},
       "levels, external nodes counted",
       "k = 2, 3, ..., 1000",
       "complete k-ary tree",
       "A25",
       [](std::span<const double> v) -> AnyModel { return grown_model(Kary(v[0])); },
       false,
       false},
      {"flow_rate",
       {"f"},
       "levels",
       "0 < f <= 1; n <= 50",
       "split(f/2) of size 2^n cut below level n",
       "A7, X20; Honda, Tomlinson and Fisher 1981",
       [](std::span<const double> v) -> AnyModel { return grown_model(FlowRate(v[0])); },
       false},
  };
  return all;
}

}  // namespace ramify
