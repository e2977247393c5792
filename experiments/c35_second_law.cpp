// C35: Horton's second law and Murray's exponent of the lung (K96 5.1.2, 5.1.6; catalogue X1-X3). A tree
// whose diameters grow by R_D an order and whose counts fall by R_B keeps sum of D^x over its forks for x =
// log R_B/log R_D. Numbers are those that the thesis prints, each known to half a unit of its last digit;
// what follows from them is known to that.
//   C35.1  x = 3, Murray's (1926), of the bronchial tree: 2.74 and 1.40 allow 2.96 to 3.03.
//   C35.2  x = 3 of the pulmonary artery: 3.39 and 1.71 do not.
//   C35.3  The printed radius of order S, (D_17/2) 1.40^S, is D_17/2 at S = 17: false (X1), the exponent is S
//   - 17. C35.4  3*10^8 alveoli of a tree of 17 orders with R_B = 2.74: false (X3). C35.5  They are those of
//   the artery, 3.39^16.
//   C35.6  The expected diameter of order k is c_D^k, "c_D the diameter of an order one segment": false (X2),
//   it is c_D R_D^(k-1), and c_D^k has no unit of length.
// From C35.7 on vessels that were measured order by order (c35_measured.cpp).
#include <algorithm>
#include <cmath>
#include <iterator>

#include "claim.hpp"
#include "lung.hpp"
#include "measured_lung.hpp"
#include <fmt/format.h>

namespace ramify {
namespace {

constexpr double alveoli = 3e8;

/// What printed numbers allow, no tree measured anew.
Basis of_printed(double estimate, double lower, double upper, std::string method) {
  return {
      EvidenceKind::published,  Standing::seen, estimate,
      {lower, upper},           Basis::none,    std::move(method) + "; interval: the numbers' last digits",
      "ratios with more digits"};
}

Basis murray_exponent_of(const LungTree& tree) {
  const Interval counts = tree.bifurcation.interval(), diameters = tree.diameter.interval();
  return of_printed(std::log(tree.bifurcation.value) / std::log(tree.diameter.value),
                    std::log(counts.lower) / std::log(diameters.upper),
                    std::log(counts.upper) / std::log(diameters.lower),
                    fmt::format("log {}/log {}", tree.bifurcation.value, tree.diameter.value));
}

/// A ratio over so many steps from order to order.
Basis power_of(const Printed& ratio, int steps) {
  const Interval each = ratio.interval();
  return of_printed(std::pow(ratio.value, steps), std::pow(each.lower, steps), std::pow(each.upper, steps),
                    fmt::format("{}^{}", ratio.value, steps));
}

/// log10(c_D^17/D_17) with c_D = D_1 = D_17/R_D^16.
Basis printed_diameter(const LungTree& tree) {
  const auto log_ratio = [](double largest, double ratio) {
    return lung_orders * (std::log10(largest) - (lung_orders - 1) * std::log10(ratio)) - std::log10(largest);
  };
  const Interval largest = tree.largest_cm.interval(), ratios = tree.diameter.interval();
  return of_printed(log_ratio(tree.largest_cm.value, tree.diameter.value),
                    log_ratio(largest.lower, ratios.upper), log_ratio(largest.upper, ratios.lower),
                    fmt::format("{0} (log10 {1} - {2} log10 {3}) - log10 {1}", lung_orders,
                                tree.largest_cm.value, lung_orders - 1, tree.diameter.value));
}

Statement of_lung(int part, std::string text, std::string conventions, std::string formula, double theory) {
  return {fmt::format("C35.{}", part),
          std::move(text),
          "K96 5.1.6, Table 5.1",
          std::move(conventions),
          Relation::equals,
          std::move(formula),
          theory,
          {},
          std::nullopt};
}

std::vector<ClaimPart> second_law_parts() {
  constexpr const char* streams = "streams, orders 1 to 17, order 1 at the alveoli";
  Statement bronchial = of_lung(1, "log R_B/log R_D is 3, bronchial tree", streams, "3", 3);
  bronchial.rivals = {{"2, da Vinci", 2}, {"2.49, large trees, Murray 1927", 2.49}};
  Statement artery = of_lung(2, "log R_B/log R_D is 3, pulmonary artery", streams, "3", 3);
  Statement radius =
      of_lung(3, "(D_17/2) R_D^17, the radius of the largest segment as printed, over D_17/2 is 1",
              "order 17 at the largest segment", "1", 1);
  radius.instead = NamedValue{"R_D^17", std::pow(bronchial_tree.diameter.value, lung_orders)};
  Statement few = of_lung(4, "3*10^8 alveoli, R_B^16, bronchial tree", streams, "3*10^8", alveoli);
  Statement many = of_lung(5, "3*10^8 alveoli, R_B^16, pulmonary artery", streams, "3*10^8", alveoli);
  many.rivals = {{"one order more, R_B^17", std::pow(pulmonary_artery.bifurcation.value, lung_orders)}};
  const auto without_trees = [](Statement statement, auto basis) {
    return part_without_trees(std::move(statement), [basis](const Evidence&) { return basis(); });
  };
  const Statement diameter =
      of_lung(6, "log10 of c_D^17/D_17 is 0, c_D = D_1 in cm: the second law as printed, bronchial tree",
              "order 1 at the alveoli", "0", 0);
  std::vector<ClaimPart> parts{
      without_trees(bronchial, [] { return murray_exponent_of(bronchial_tree); }),
      without_trees(artery, [] { return murray_exponent_of(pulmonary_artery); }),
      without_trees(radius, [] { return power_of(bronchial_tree.diameter, lung_orders); }),
      without_trees(few, [] { return power_of(bronchial_tree.bifurcation, lung_orders - 1); }),
      without_trees(many, [] { return power_of(pulmonary_artery.bifurcation, lung_orders - 1); }),
      without_trees(diameter, [] { return printed_diameter(bronchial_tree); })};
  std::ranges::move(measured_second_law_parts(parts.size() + 1), std::back_inserter(parts));
  return parts;
}

}  // namespace

Claim second_law_claim() {
  return {"C35",
          "Horton's second law and Murray's exponent: diameters of the lung",
          "K96 5.1.2, 5.1.6",
          second_law_parts(),
          {}};
}

}  // namespace ramify
