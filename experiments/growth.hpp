#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "claim.hpp"

#include "ramify/estimate/limit_slope.hpp"
#include "ramify/theory/constant.hpp"

namespace ramify {

/// The claim that X_n grows like a constant of the model times log n, of several models: as data.
struct GrowthLaw {
  std::string_view source;
  std::string_view statement;  ///< without the model
  std::string_view convention;
  std::optional<Constant> (*constant)(const Model&);
  /// Values that somebody might believe; one that is the theory of this very model is left out.
  std::vector<NamedValue> (*rivals)(const Model&);
};

/// A model and how its constant is found.
struct GrowthCase {
  Model model;
  GrowthLadder ladder;
};

/// The rest of the table of the catalogue, beside the splits of which trees are taken.
inline constexpr std::array beta_grid{"beta(0.1,0.1)", "beta(0.5,0.5)", "beta(2,2)",
                                      "beta(100,100)", "beta(1,5)",     "beta(2,8)"};

/// Parts C6.1, C6.2, ..., one for each case.
std::vector<ClaimPart> growth_parts(std::string_view claim, const GrowthLaw& law,
                                    const std::vector<GrowthCase>& cases);

/// The same, of one ladder: trees are taken of the models that are sampled, beta_grid is judged by laws
/// alone.
/// @param largest_of_grid  the ladder's largest n there
std::vector<ClaimPart> growth_parts_with_grid(std::string_view claim, const GrowthLaw& law,
                                              const std::vector<const char*>& sampled, GrowthLadder ladder,
                                              double largest_of_grid);

/// Its basis is the limit of that ladder.
std::function<Basis(const Evidence&)> growth_basis(const GrowthCase& growth);

/// A plot as a claim names it.
struct PlotNames {
  std::string_view stem, title, y_label;
};

/// Mean against n with error bars and its exact curve, model by model, the growth law that the part claims
/// drawn through the last point (its slope is the claim, its height is not).
/// @param parts  one for each model that is drawn
NamedPlot growth_plot(const PlotNames& names, const std::vector<ClaimPart>& parts,
                      const std::vector<ModelCells>& models);

/// The sampled means of a column of a model.
std::vector<PlotPoint> sampled_means(const ModelCells& model, const StatisticColumn& column);

/// A claim that is growth_parts and their growth_plot.
Claim growth_claim(Claim claim, const PlotNames& plot);

}  // namespace ramify
