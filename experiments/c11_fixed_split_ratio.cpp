// C11, Fact 3.3 (Kruszewski 1996): the bifurcation ratio of deterministic split trees is about 1/X. The
// argument there gives R >= 1/X alone; the other bound is that of the fill level.
//
// True of the middle orders of large trees: order k begins at size n_k = ceil(n_(k-1)/X) and there are some
// c n/n_k streams of it, where c swings with log(n/n_k) less and less. Not true of trees of botanical size:
// at n = 579 the lowest orders are those where ceil and floor count, and the topmost has few streams.
#include <cmath>

#include "claim.hpp"
#include "exact_range.hpp"
#include "law_pictures.hpp"
#include "one_way_trees.hpp"
#include <fmt/format.h>

#include "ramify/statistic/order_ratios.hpp"
#include "ramify/theory/depth_constant.hpp"
#include "ramify/theory/horton_ratio_constant.hpp"

namespace ramify {
namespace {

double claimed_ratio(const Model& model) {
  return horton_ratio_constant(model).value().value;
}

Statement limit_ratio(std::string part, const Model& model) {
  const double x = model.parameters().front();
  return {std::move(part),
          fmt::format("M_k/M_(k+1) ~ 1/X, {}", model.text()),
          "K96 Fact 3.3",
          "streams, middle orders",
          Relation::equals,
          "1/X",
          claimed_ratio(model),
          {{"1/(1-X), the larger child", 1 / (1 - x)},
           {"h/(X(1-X)), the first ratio of the PATRICIA tree",
            1 / (x * (1 - x) * depth_constant(model).value().value)},
           {"1/X + 1", claimed_ratio(model) + 1}},
          std::nullopt};
}

/// The ratios of orders 4..S-8 at n = 10^12, 10^13, ...: they swing about their limit.
Basis middle_ratios(const Model& model) {
  constexpr std::size_t lowest = 4, from_top = 8;
  constexpr Size smallest = 1'000'000'000'000, largest = 1'000'000'000'000'000;
  ExactRange seen;
  for (Size n = smallest; n <= largest; n *= 10) {
    const auto streams = one_way_counts(model, n).streams;
    for (std::size_t k = lowest; k + from_top < streams.size(); ++k)
      seen.add(static_cast<double>(streams[k]) / static_cast<double>(streams[k + 1]));
  }
  Basis basis =
      seen.basis(static_cast<double>(largest),
                 fmt::format("exact ratios of orders {}..S-{} at n = 10^12, 10^13, 10^14, 10^15: they "
                             "swing about the limit, which is taken to lie between them",
                             lowest, from_top));
  basis.evidence = EvidenceKind::limit;
  basis.standing = Standing::extrapolated;
  return basis;
}

/// n of Kruszewski's trees of X = 1/4.35.
constexpr Size botanical_size = 579;

Statement botanical_ratio(std::string part, const Model& model, std::string of) {
  return {std::move(part),
          fmt::format("mean of the ratios of {} = 1/X, {} at n = {}", of, model.text(), botanical_size),
          "K96 Fact 3.3, 3.2.2",
          "(1/S) sum of N_k/N_(k+1), k = 0..S-1",
          Relation::equals,
          "1/X",
          claimed_ratio(model),
          {},
          std::nullopt};
}

Basis mean_ratio(const std::vector<std::uint64_t>& counts) {
  constexpr double error = 1e-12;
  ExactRange ratio;
  ratio.add(order_ratios(counts).mean_ratio);
  return ratio.basis(static_cast<double>(botanical_size), "the one tree there is", error);
}

/// Large trees have 1/X in the middle; the tree of 579 nodes has no middle.
std::vector<NamedPlot> ratios_of_fixed_splits(const Evidence&) {
  const auto of = [](const char* text, Size n, const char* size, bool with_limit) {
    const Model model = Model::parse(text);
    const auto streams = one_way_counts(model, n).streams;
    OrderedCounts counts{fmt::format("{}, n = {}", text, size), {streams.begin(), streams.end()}};
    if (with_limit) counts.limit = claimed_ratio(model);
    return counts;
  };
  constexpr Size large = 1'000'000'000'000'000;
  return {ratio_picture({"C11_split_ratios", "Stream ratios of deterministic split trees", "M_k / M_(k+1)"},
                        "exact; dashed: 1/X",
                        {of("split(1/4.35)", large, "10^15", true), of("split(1/2.74)", large, "10^15", true),
                         of("split(1/4.35)", botanical_size, "579", false)})};
}

}  // namespace

Claim fixed_split_ratio_claim() {
  const Model botanical = Model::parse("split(1/4.35)");
  std::vector<ClaimPart> parts;
  for (const char* text : {"split(1/4.35)", "split(1/4)", "split(0.3)", "split(1/2.74)"}) {
    const Model model = Model::parse(text);
    parts.push_back(part_without_trees(limit_ratio(fmt::format("C11.{}", parts.size() + 1), model),
                                       [model](const Evidence&) { return middle_ratios(model); }));
  }
  parts.push_back(part_without_trees(
      botanical_ratio("C11.5", botanical, "nodes"),
      [botanical](const Evidence&) { return mean_ratio(one_way_counts(botanical, botanical_size).nodes); }));
  parts.push_back(
      part_without_trees(botanical_ratio("C11.6", botanical, "streams"), [botanical](const Evidence&) {
        return mean_ratio(one_way_counts(botanical, botanical_size).streams);
      }));
  return {"C11",
          "bifurcation ratio 1/X of deterministic split trees",
          "K96 Fact 3.3",
          parts,
          {},
          ratios_of_fixed_splits};
}

}  // namespace ramify
