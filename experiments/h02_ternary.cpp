// H2, last parts (Kruszewski 1996, 3.3.3, 3.3.4): white fir and sugar maple fork into three. Of n nodes X ~
// Bin(n,p) go to the third child, X-1 to the second and the rest to the first, "which maintains the correct
// bifurcation ratio" with p = 1/R; and, for the maple, with a p that depends on size and depth of the node.
//
// High orders have it: S_n/log n -> 1/log R, also where p is 1/R at sizes above 100 alone
// (ternary_orders_left proves it). Of the thesis' trees of 1000 nodes that is another matter: half of the
// firs reach one order more than the others, so that the ratio of a tree has two humps and the delta method
// says nothing; trees are grown instead, and the middle 99 of 100 of them is what is seen. Their counts have
// an exact law (ternary_orders.hpp), which is drawn.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>

#include "law_pictures.hpp"
#include "ternary_orders.hpp"
#include "ternary_recipe.hpp"
#include <boost/math/distributions/binomial.hpp>
#include <fmt/format.h>

#include "ramify/core/contract.hpp"
#include "ramify/model/preset.hpp"
#include "ramify/model/ternary.hpp"
#include "ramify/sample/tree_sampler.hpp"
#include "ramify/statistic/order_ratios.hpp"
#include "ramify/theory/bst_horton_ratio.hpp"

namespace ramify {
namespace {

struct TernarySpecies {
  const char* preset;
  const char* name;
  const char* source;
  double ratio;
};

constexpr std::array ternary_species{
    TernarySpecies{"white_fir", "the white fir", "K96 3.3.3", 4.8},
    TernarySpecies{"maple_forest", "the maple in the forest", "K96 3.3.4", 3.19},
    TernarySpecies{"maple_open", "the maple on open ground", "K96 3.3.4", 7.05},
    TernarySpecies{"maple_varying", "the maple in the forest", "K96 3.3.4", 3.19},
};

/// The model, or the name of the preset where that is a long formula.
std::string_view shown(const Preset& preset) {
  return Model::parse(preset.model).is(Ternary::info()) ? preset.model : preset.name;
}

Statement ratio_of_high_orders(std::size_t part, const TernarySpecies& species) {
  const double p = 1 / species.ratio, main = 1 - 2 * p;
  const double entropy = -main * std::log(main) - 2 * p * std::log(p);
  return {fmt::format("H2.{}", part),
          fmt::format("S_n ~ log(n)/log R, {}", shown(find_preset(species.preset))),
          species.source,
          "order of the root, leaf order 0, one more where two of three children tie",
          Relation::equals,
          fmt::format("1/log {}", species.ratio),
          1 / std::log(species.ratio),
          {{"1/log(1/(1-2p)), down the main child", -1 / std::log(main)},
           {"1/h, h the entropy of (1-2p, p, p): the depth", 1 / entropy},
           {"BST", 1 / std::log(bst_horton_ratio().value)}},
          std::nullopt};
}

/// S_n/log n at n = 10^300.
Basis between_ternary_bounds(double ratio) {
  constexpr double n = 1e300, chance = 1e-3;
  const double log_n = std::log(n);
  const auto [lower, upper] = ternary_orders_left(1 / ratio, n, chance);
  return {EvidenceKind::limit,
          Standing::proved,
          (lower + upper) / (2 * log_n),
          {lower / log_n, upper / log_n},
          n,
          fmt::format("{} <= S_n <= {} at n = {:g} but for a chance of {:g}, by the smallest and the largest "
                      "side child of every node (Hoeffding); both over log n go to the theory as n grows",
                      lower, upper, n, chance),
          ""};
}

/// The maple that grows elsewhere: the two "differ only in bifurcation ratio" (Table 3.9).
NamedValue other_species(const TernarySpecies& species) {
  const TernarySpecies &forest = ternary_species[1], &open = ternary_species[2];
  const TernarySpecies& other = species.ratio == forest.ratio ? open : forest;
  return {other.name, other.ratio};
}

Statement ratio_of_trees(std::size_t part, const TernarySpecies& species) {
  const Preset& preset = find_preset(species.preset);
  return {fmt::format("H2.{}", part),
          fmt::format("a tree of {} nodes, {}, has the ratio {} of {}, in 99 of 100", preset.n, shown(preset),
                      species.ratio, species.name),
          species.source,
          "streams, regression of log counts on all orders",
          Relation::equals,
          fmt::format("{}, measured", species.ratio),
          species.ratio,
          {other_species(species)},
          std::nullopt};
}

/// How many of so many values are given away at one end, so that what is left begins below the point that
/// `share` of all lie below, but for a chance.
std::size_t given_away(std::size_t values, double share, double chance) {
  const boost::math::binomial below(static_cast<double>(values), share);
  std::size_t given = 0;
  while (boost::math::cdf(below, static_cast<double>(given)) <= chance) ++given;
  RAMIFY_EXPECTS(given > 0);
  return given - 1;
}

std::vector<double> grown_ratios(const Preset& preset, std::size_t trees, const Cancellation& cancellation) {
  constexpr std::uint64_t seed = 1996;
  const Model model = Model::parse(preset.model);
  const auto sampler = make_tree_sampler({model, whole_trees(all_but_indices), preset.n, &cancellation});
  std::vector<double> ratios;
  TreeMeasures measures;
  for (std::uint64_t replicate = 0; replicate < trees; ++replicate) {
    sampler->sample(preset.n, {seed, model.stream_cell(preset.n)}, replicate, measures);
    ratios.push_back(order_ratios(std::span(measures.streams).first(measures.strahler + 1)).regression);
  }
  std::ranges::sort(ratios);
  return ratios;
}

/// Between which ratios 99 of 100 trees lie, at least, but for a chance of 1/1000.
Basis ratio_of_grown_trees(const Preset& preset, const Cancellation& cancellation) {
  constexpr std::size_t trees = 4000;
  const auto ratios = grown_ratios(preset, trees, cancellation);
  const std::size_t given = given_away(trees, 0.005, 0.0005);
  return {EvidenceKind::sampled,
          Standing::seen,
          (ratios[given] + ratios[trees - 1 - given]) / 2,
          {ratios[given], ratios[trees - 1 - given]},
          static_cast<double>(preset.n),
          fmt::format("ratio regressed on all orders of each of {} grown trees: all but {} at either end, "
                      "between which 99 of 100 trees lie but for a chance of 1/1000, and their middle",
                      trees, given),
          fmt::format("trees of more than {} nodes", preset.n)};
}

}  // namespace

std::vector<ClaimPart> ternary_recipe_parts(std::size_t first) {
  std::vector<ClaimPart> parts;
  for (const TernarySpecies& species : ternary_species)
    parts.push_back(part_without_trees(
        ratio_of_high_orders(first + parts.size(), species),
        [ratio = species.ratio](const Evidence&) { return between_ternary_bounds(ratio); }));
  for (const TernarySpecies& species : ternary_species)
    parts.push_back(part_without_trees(
        ratio_of_trees(first + parts.size(), species), [preset = species.preset](const Evidence& evidence) {
          return ratio_of_grown_trees(find_preset(preset), evidence.cancellation);
        }));
  return parts;
}

NamedPlot ternary_recipe_picture(const Cancellation& cancellation) {
  std::vector<OrderedCounts> series;
  for (const TernarySpecies& species : ternary_species) {
    const Preset& preset = find_preset(species.preset);
    auto means = ternary_stream_counts(Model::parse(preset.model), preset.n, cancellation).means;
    std::erase_if(means, [](double mean) { return mean < 1; });
    series.push_back({std::string(preset.name), std::move(means), species.ratio});
  }
  return ratio_picture({"H2_ternary", "Ternary trees of p = 1/R: their stream ratios", "M_k / M_(k+1)"},
                       "expected counts at n = 1000, exact; dashed: R = 1/p", series);
}

}  // namespace ramify
