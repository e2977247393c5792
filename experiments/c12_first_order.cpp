// C12, Oohata and Shidei (1971) as in Kruszewski 1996, 3.1.4: N_1/n ~ 1 - 1/R, N_1 the nodes of order 1.
//
// It follows from Horton's law where that holds from the first order on, N_1 = R^(S-1) of n = (R^S - 1)/(R -
// 1). It does not hold that far down: of random BSTs the first ratio of nodes is 1.674, of PATRICIA trees
// 1.656, where the limits are 3.0438 and 4.3478. Of uniform trees half the nodes have order 1: that is 1 -
// 1/R with the ratio of nodes, 2, and not with that of streams, 4.
#include <cmath>

#include "law_pictures.hpp"
#include "order_fraction.hpp"
#include <fmt/format.h>

#include "ramify/theory/horton_ratio_constant.hpp"

namespace ramify {
namespace {

constexpr const char* first_order_convention = "nodes of order 1, leaf order 0";

double limit_ratio_of(const Model& model) {
  return horton_ratio_constant(model).value().value;
}

Statement first_order(std::string part, const Model& model, std::string_view ratio_of, double ratio) {
  return {std::move(part),
          fmt::format("N_1/n ~ 1 - 1/R, R of {}, {}", ratio_of, model.text()),
          "K96 3.1.4; Oohata, Shidei 1971",
          first_order_convention,
          Relation::equals,
          "1 - 1/R",
          1 - 1 / ratio,
          {},
          std::nullopt};
}

ClaimPart first_order_part(Statement statement, const Model& model) {
  return part_without_trees(std::move(statement), [model](const Evidence& evidence) {
    return first_order_fraction(model, evidence.cancellation);
  });
}

/// N_1/n = 1 - 1/R wants N_1/N_2 = R: the ratio that the lowest orders are far from.
std::vector<NamedPlot> ratios_from_the_first_order(const Evidence& evidence) {
  const auto of = [&](const char* text, double ratio) {
    const Model model = Model::parse(text);
    auto nodes = expected_counts(model, OrderCount::Of::nodes, evidence.cancellation);
    nodes.erase(nodes.begin());  // external ones
    return OrderedCounts{fmt::format("{}: R = {:.5g}", text, ratio), std::move(nodes), ratio, 1};
  };
  constexpr double catalan_nodes = 2;
  return {
      ratio_picture({"C12_node_ratios", "Where Horton's law of nodes sets in", "N_k / N_(k+1)"},
                    "expected counts at n = 10^12; dashed: R, which N_1/n = 1 - 1/R takes for granted from "
                    "k = 1 on",
                    {of("bst", limit_ratio_of(Model::parse("bst"))), of("catalan", catalan_nodes),
                     of("patricia(0.23)", limit_ratio_of(Model::parse("patricia(0.23)")))})};
}

}  // namespace

Claim first_order_claim() {
  const Model bst = Model::parse("bst"), catalan = Model::parse("catalan"),
              patricia = Model::parse("patricia(0.23)");
  constexpr double catalan_nodes = 2;
  Statement of_bst = first_order("C12.1", bst, "streams and nodes", limit_ratio_of(bst));
  of_bst.instead = NamedValue{"(e^2 - 5)/4", (std::exp(2.0) - 5) / 4};
  Statement of_nodes = first_order("C12.2", catalan, "nodes", catalan_nodes);
  of_nodes.rivals = {{"3/4, R of streams", 1 - 1 / limit_ratio_of(catalan)},
                     {"1/3, cherries by nodes of the bst", 1 / 3.0}};
  Statement of_streams = first_order("C12.3", catalan, "streams", limit_ratio_of(catalan));
  of_streams.instead = NamedValue{"1/2", 1 - 1 / catalan_nodes};
  return {"C12",
          "N_1/n ~ 1 - 1/R: the share of the first order",
          "K96 3.1.4",
          {first_order_part(of_bst, bst), first_order_part(of_nodes, catalan),
           first_order_part(of_streams, catalan),
           first_order_part(first_order("C12.4", patricia, "streams and nodes", limit_ratio_of(patricia)),
                            patricia)},
          {},
          ratios_from_the_first_order};
}

}  // namespace ramify
