// C33: data structures, growth processes and split trees that are the same random tree. The law of a tree is
// that of its splits; "distance" is that of two split laws in total variation, left and right not told apart,
// which no statistic here does, the largest over the sizes 2 to 64.
//   C33.1  beta(1,1) is the BST.
//   C33.2  Terminal growth is the BST, C33.3 segmental growth the uniform tree (A16): the growth, step by
//          step, moves the size of the left subtree, and either side grows as the whole does.
//   C33.4  beta(a,a) and beta(a,a+1) have the same splits: (f(x) + f(1-x))/2 is the same density.
//   C33.5  beta_multinomial(a,b), a, b -> infinity, splits like Bin(n-1,p), a digital search tree.
//   C33.6  So does PATRICIA (3.2.2): false at finite n (X16); C33.7 true as n -> infinity.
//   C33.8  An expression is evaluated with S + 1 registers at least: of every (order, registers) that trees
//   of
//          each size have, registers found by trying both orders of evaluation at every node.
#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <utility>
#include <vector>

#include "at_infinity.hpp"
#include "claim.hpp"
#include "exact_range.hpp"
#include <fmt/format.h>

#include "ramify/model/split_law.hpp"

namespace ramify {
namespace {

constexpr Size largest_compared = 64;
constexpr double row_error = 1e-9;  // of windows: 1e-10 relative
constexpr Size concentration = 400000, largest_root = 64;

/// P(left = i), i = 0..n-1.
using SplitOf = std::function<std::vector<double>(Size n)>;

SplitOf split_of(const char* model) {
  return [law = Model::parse(model)](Size n) { return split_pmf(law, n); };
}

/// Half the sum of |a(i) + a(n-1-i) - b(i) - b(n-1-i)|/2.
double distance(const SplitOf& a, const SplitOf& b, Size n) {
  const auto first = a(n), second = b(n);
  double sum = 0;
  for (Size i = 0; i < n; ++i)
    sum += std::abs(first[i] + first[n - 1 - i] - second[i] - second[n - 1 - i]) / 2;
  return sum / 2;
}

LargestOf largest_distance(const SplitOf& a, const SplitOf& b) {
  LargestOf largest;
  for (Size n = 2; n <= largest_compared; ++n) largest.add(distance(a, b, n), row_error);
  return largest;
}

/// Segments at which a tree may grow: of a subtree 1 and so many for each internal node; and the stem, which
/// puts the whole tree to one side of a new root.
struct Growth {
  double for_each_node, stem;
};
/// The split after n-1 steps of a growth, from one internal node on.
SplitOf split_by_growth(Growth growth) {
  return [growth](Size n) {
    std::vector<double> split{1};
    const auto weight = [&](Size size) { return growth.for_each_node * static_cast<double>(size) + 1; };
    for (Size size = 1; size < n; ++size) {
      std::vector<double> next(size + 1, 0.0);
      const double all = weight(0) + weight(size - 1) + growth.stem;
      next.front() += growth.stem / all / 2;
      next.back() += growth.stem / all / 2;
      for (Size left = 0; left < size; ++left) {
        next[left + 1] += split[left] * weight(left) / all;
        next[left] += split[left] * weight(size - 1 - left) / all;
      }
      split = std::move(next);
    }
    return split;
  };
}

/// Leaves, one more than internal nodes; segments, two a node and one, and the stem below the root.
constexpr Growth terminal_growth{1, 0}, segmental_growth{2, 1}, stemless_growth{2, 0};

Basis equal_laws(const LargestOf& largest, std::string method) {
  return largest.basis(EvidenceKind::exact, Standing::proved, largest_compared, std::move(method));
}

Basis tends_to(const Extrapolated& limit, double largest_n, std::string method) {
  return extrapolated(limit.value, limit.bound, largest_n, std::move(method), "nearer to the limit");
}

/// beta_multinomial(p s, (1-p) s) with p = 0.23, from Bin(n-1,p): c/s + O(1/s^2).
double distance_of_concentrated(Size s) {
  return largest_distance(split_of(fmt::format("beta_multinomial({},{})", 0.23 * static_cast<double>(s),
                                               0.77 * static_cast<double>(s))
                                       .c_str()),
                          split_of("dst(0.23)"))
      .value();
}

/// Of PATRICIA from Bin(n-1,p), n = root^2: c/root + O(1/n).
double distance_of_patricia(Size root) {
  return distance(split_of("patricia(0.23)"), split_of("dst(0.23)"), root * root);
}

using OrderAndRegisters = std::pair<int, int>;

OrderAndRegisters evaluated(const OrderAndRegisters& left, const OrderAndRegisters& right) {
  const auto [high, low] = std::minmax(left.first, right.first, std::greater<>());
  const int left_first = std::max(left.second, right.second + 1);
  const int right_first = std::max(right.second, left.second + 1);
  return {high + (high == low ? 1 : 0), std::min(left_first, right_first)};
}

/// The pairs of all trees of every size: those of a tree follow from those of its subtrees.
Basis registers_of_all_trees(const Evidence&) {
  std::vector<std::set<OrderAndRegisters>> known{{{0, 1}}};
  LargestOf worst;
  for (Size n = 1; n <= largest_compared; ++n) {
    std::set<OrderAndRegisters> pairs;
    for (Size left = 0; left < n; ++left)
      for (const auto& a : known[left])
        for (const auto& b : known[n - 1 - left]) pairs.insert(evaluated(a, b));
    for (const auto& [order, registers] : pairs) worst.add(registers - (order + 1), 0);
    known.push_back(std::move(pairs));
  }
  return equal_laws(
      worst, fmt::format("all trees to n = {}, by the pairs that their subtrees have", largest_compared));
}

Statement equivalence(int part, std::string text, std::string source, std::vector<NamedValue> rivals) {
  return {fmt::format("C33.{}", part),
          std::move(text),
          std::move(source),
          "distance of split laws, left and right alike",
          Relation::equals,
          "0",
          0,
          std::move(rivals),
          std::nullopt};
}

/// Two laws, and what another one is from the first.
ClaimPart same_law(int part, std::string text, const SplitOf& a, const SplitOf& b, std::string rival_name,
                   const SplitOf& rival) {
  std::vector<NamedValue> rivals{{std::move(rival_name), largest_distance(a, rival).value()}};
  return part_without_trees(
      equivalence(part, std::move(text), "K96 2.5, 5.1.6, App. B, C", std::move(rivals)),
      [a, b](const Evidence&) {
        return equal_laws(largest_distance(a, b),
                          fmt::format("split laws of every n from 2 to {}", largest_compared));
      });
}

std::vector<ClaimPart> binomial_parts() {
  const SplitOf patricia = split_of("patricia(0.23)"), binomial = split_of("dst(0.23)");
  const double finite = largest_distance(patricia, binomial).value();
  return {part_without_trees(
              equivalence(5, "beta_multinomial(a,b), a/(a+b) = 0.23, a, b -> infinity, is dst(0.23)",
                          "DK95; K96 3.2.2", {{"PATRICIA", finite}}),
              [](const Evidence&) {
                return tends_to(at_infinity(concentration, distance_of_concentrated), largest_compared,
                                fmt::format("distance at a + b = {}, {}, {}, the term in 1/(a+b) taken off",
                                            concentration / 4, concentration / 2, concentration));
              }),
          part_without_trees(equivalence(6, "patricia(0.23) splits like Bin(n-1,p)", "K96 3.2.2", {}),
                             [patricia, binomial](const Evidence&) {
                               return equal_laws(
                                   largest_distance(patricia, binomial),
                                   fmt::format("split laws of every n from 2 to {}", largest_compared));
                             }),
          part_without_trees(
              equivalence(7, "patricia(0.23) splits like Bin(n-1,p) as n -> infinity", "K96 3.2.2",
                          {{"as it is at n = 256", distance_of_patricia(16)}}),
              [](const Evidence&) {
                return tends_to(at_infinity(largest_root, distance_of_patricia), largest_root * largest_root,
                                fmt::format("distance at n = {}, {}, {}, the term in n^(-1/2) taken off",
                                            largest_root * largest_root / 16, largest_root * largest_root / 4,
                                            largest_root * largest_root));
              })};
}

std::vector<ClaimPart> equivalence_parts() {
  const SplitOf bst = split_of("bst"), catalan = split_of("catalan");
  std::vector<ClaimPart> parts{
      same_law(1, "beta(1,1) is the BST", bst, split_of("beta(1,1)"), "beta(1,1.1)", split_of("beta(1,1.1)")),
      same_law(2, "terminal growth is the BST", bst, split_by_growth(terminal_growth), "segmental growth",
               split_by_growth(segmental_growth)),
      same_law(3, "segmental growth is the uniform tree", catalan, split_by_growth(segmental_growth),
               "nothing grows out of the stem", split_by_growth(stemless_growth)),
      same_law(4, "beta(5,5) and beta(5,6) have the same splits", split_of("beta(5,5)"),
               split_of("beta(5,6)"), "beta(5,7)", split_of("beta(5,7)"))};
  for (auto& part : binomial_parts()) parts.push_back(std::move(part));
  Statement registers = equivalence(8, "largest |registers - (S + 1)| over all trees is 0",
                                    "K96 B.1.2; Ershov 1958", {{"S registers", 1}});
  registers.convention = "registers, one of a leaf; S, leaf order 0";
  parts.push_back(part_without_trees(std::move(registers), registers_of_all_trees));
  return parts;
}

}  // namespace

Claim equivalence_claim() {
  return {"C33",
          "Data structures and growth processes that are the same random tree",
          "K96 2.5, 3.2, App. B, C",
          equivalence_parts(),
          {}};
}

}  // namespace ramify
