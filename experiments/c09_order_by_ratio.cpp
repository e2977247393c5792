// C9, Fact 3.1 (Kruszewski 1996): where Horton's first law holds with ratio R, log_R n ~ S. The proof sums
// N_k = R^(S-k), and so has one of the top order: streams have that, nodes, which the thesis counts (3.1.2),
// do not.
//
// Of uniform trees both counts obey Horton's law in the limit, streams with ratio 4, nodes with 2; S ~ log_4
// n. Of random BSTs both ratios are 3.0438 and the fact holds of either.
#include <cmath>

#include "law_pictures.hpp"
#include "order_fraction.hpp"
#include <fmt/format.h>

#include "ramify/theory/horton_ratio_constant.hpp"

namespace ramify {
namespace {

constexpr double ratio_of_catalan_nodes = 2;

Statement order_by_ratio(std::string part, const Model& model, std::string_view counted, double ratio) {
  return {std::move(part),     fmt::format("S_n ~ log_R n, R of {}, {}", counted, model.text()),
          "K96 Fact 3.1",      "order of the root, leaf order 0",
          Relation::equals,    "1/log R",
          1 / std::log(ratio), {},
          std::nullopt};
}

/// The same ladder as those of C20 and C22.
ClaimPart order_part(Statement statement, const Model& model) {
  const GrowthLadder ladder{&statistic::strahler, GrowthLadder::Rungs::medians,
                            GrowthLadder::Approach::settles, 1e12};
  return part_without_trees(std::move(statement), growth_basis({model, ladder}));
}

ClaimPart ratio_part(std::string part, const Model& model, OrderCount::Of of, double ratio,
                     NamedValue rival) {
  const bool is_of_nodes = of == OrderCount::Of::nodes;
  const Statement statement{
      std::move(part),
      fmt::format("E {0}_3/E {0}_4 -> {1:g}: Horton's law of {2}, {3}", is_of_nodes ? "N" : "M", ratio,
                  is_of_nodes ? "nodes" : "streams", model.text()),
      "K96 Fact 3.1; Moon 1980",
      "leaf order 0",
      Relation::equals,
      is_of_nodes ? "2" : "4",
      ratio,
      {std::move(rival)},
      std::nullopt};
  constexpr std::size_t order = 3;
  return part_without_trees(statement, [model, of](const Evidence& evidence) {
    return middle_order_ratio(model, {of, order}, evidence.cancellation);
  });
}

/// Ratios of nodes and of streams settle at two numbers in uniform trees, at one in BSTs.
std::vector<NamedPlot> ratios_of_both_counts(const Evidence& evidence) {
  const auto of = [&](const char* model, OrderCount::Of count, double limit) {
    return OrderedCounts{fmt::format("{} of {}: to {:.5g}",
                                     count == OrderCount::Of::nodes ? "nodes" : "streams", model, limit),
                         expected_counts(Model::parse(model), count, evidence.cancellation), limit};
  };
  const double uniform = horton_ratio_constant(Model::parse("catalan")).value().value,
               grown = horton_ratio_constant(Model::parse("bst")).value().value;
  return {
      ratio_picture({"C9_ratios", "Horton's law of streams and of nodes", "X_k / X_(k+1)"},
                    "expected counts at n = 10^12; S_n ~ log_R n with the ratio of streams",
                    {of("catalan", OrderCount::Of::streams, uniform),
                     of("catalan", OrderCount::Of::nodes, ratio_of_catalan_nodes),
                     of("bst", OrderCount::Of::streams, grown), of("bst", OrderCount::Of::nodes, grown)})};
}

}  // namespace

Claim order_by_ratio_claim() {
  const Model catalan = Model::parse("catalan"), bst = Model::parse("bst");
  const double streams = horton_ratio_constant(catalan).value().value;
  const double of_streams = 1 / std::log(streams), of_nodes = 1 / std::log(ratio_of_catalan_nodes);
  Statement by_streams = order_by_ratio("C9.1", catalan, "streams", streams);
  by_streams.rivals = {{"1/log 2, the ratio of nodes", of_nodes},
                       {"1/log 3, terminal growth", 1 / std::log(3.0)}};
  Statement by_nodes = order_by_ratio("C9.2", catalan, "nodes", ratio_of_catalan_nodes);
  by_nodes.instead = NamedValue{"1/log 4, the ratio of streams", of_streams};
  Statement of_bst =
      order_by_ratio("C9.3", bst, "streams and nodes", horton_ratio_constant(bst).value().value);
  of_bst.rivals = {{"1/log 3, the first ratio", 1 / std::log(3.0)},
                   {"1/log 2, complete trees", 1 / std::log(2.0)}};
  return {
      "C9",
      "log_R n ~ S(T) where Horton's first law holds",
      "K96 Fact 3.1",
      {order_part(by_streams, catalan), order_part(by_nodes, catalan), order_part(of_bst, bst),
       ratio_part("C9.4", catalan, OrderCount::Of::streams, streams, {"2, nodes", ratio_of_catalan_nodes}),
       ratio_part("C9.5", catalan, OrderCount::Of::nodes, ratio_of_catalan_nodes, {"4, streams", streams})},
      {},
      ratios_of_both_counts};
}

}  // namespace ramify
