#include "ramify/shape/deviation_rule.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/random/normal_distribution.hpp>
#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/shape/degrees.hpp"
#include "ramify/shape/triangle.hpp"

namespace ramify {
namespace {

using Fork = ForkQuestion;
using Numbers = std::span<const double>;

constexpr double widest = 180;

/// The sum of a fact over the other children.
template <class Fact>
double of_siblings(const Fork& fork, std::size_t child, Fact fact) {
  double sum = 0;
  for (std::size_t i = 0; i < fork.children.size(); ++i)
    if (i != child) sum += fact(fork.children[i]);
  return sum;
}

/// The largest of a fact among the other children; that of the child where it has none.
template <class Fact>
double highest_sibling(const Fork& fork, std::size_t child, Fact fact) {
  double highest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < fork.children.size(); ++i)
    if (i != child) highest = std::max(highest, fact(fork.children[i]));
  return fork.children.size() == 1 ? fact(fork.children[child]) : highest;
}

DeviationRule same(Numbers c) {
  return [c = c[0]](const Fork&, std::size_t) { return c; };
}

DeviationRule by_role(Numbers c) {
  return [main = c[0], secondary = c[1]](const Fork& fork, std::size_t child) {
    return fork.children[child].is_main ? main : secondary;
  };
}

/// main, secondary or fork as a child's rank is above, below or that of its highest sibling.
template <class Rank>
DeviationRule by_rank(Numbers c, Rank rank) {
  return [main = c[0], secondary = c[1], even = c[2], rank](const Fork& fork, std::size_t child) {
    const double own = rank(fork.children[child]), other = highest_sibling(fork, child, rank);
    return own > other ? main : own < other ? secondary : even;
  };
}

double own_order(const NodeFacts& node) {
  return node.order;
}

double own_radius(const NodeFacts& node) {
  return node.radius;
}

double own_nodes(const NodeFacts& node) {
  return node.nodes;
}

DeviationRule by_order(Numbers c) {
  return by_rank(c, own_order);
}

DeviationRule by_log_nodes(Numbers c) {
  return by_rank(c, [](const NodeFacts& node) { return std::floor(std::log2(node.nodes)); });
}

DeviationRule viennot(Numbers c) {
  return [main = c[0], secondary = c[1], even = c[2]](const Fork& fork, std::size_t child) {
    const double own = own_order(fork.children[child]), other = highest_sibling(fork, child, own_order);
    if (own == other) return even;
    return own > other ? main * other / (own - 1) : secondary * (other - own) / (other - 1);
  };
}

DeviationRule murray(Numbers) {
  return [](const Fork& fork, std::size_t child) {
    if (fork.children.size() != 2)
      throw Error(fmt::format("the rule murray at a fork of {}", fork.children.size()),
                  "Murray's angle is of two branches", "take radius_gap or radius_share");
    return murray_angle(fork.mother.radius, fork.children[child].radius, fork.children[1 - child].radius);
  };
}

DeviationRule radius_gap(Numbers c) {
  return [c = c[0], main = c[1]](const Fork& fork, std::size_t child) {
    const NodeFacts& node = fork.children[child];
    return (node.is_main ? main * c : c) * (fork.mother.radius - node.radius) / fork.mother.radius;
  };
}

/// c times the others' part of a sum.
template <class Fact>
DeviationRule others_share(double c, Fact fact) {
  return [c, fact](const Fork& fork, std::size_t child) {
    const double others = of_siblings(fork, child, fact);
    return others == 0 ? 0 : c * others / (others + fact(fork.children[child]));
  };
}

DeviationRule radius_share(Numbers c) {
  return others_share(c[0], own_radius);
}

DeviationRule nodes_share(Numbers c) {
  return others_share(c[0], own_nodes);
}

DeviationRule by_depth(Numbers c) {
  return [c = c[0]](const Fork& fork, std::size_t child) { return c / (fork.children[child].depth() + 1); };
}

DeviationRule by_log_depth(Numbers c) {
  return [c = c[0]](const Fork& fork, std::size_t child) {
    return c / (std::log(fork.children[child].depth()) + 1);
  };
}

DeviationRule falling(Numbers c) {
  return [main = c[0], highest = c[1], step = c[2]](const Fork& fork, std::size_t child) {
    const NodeFacts& node = fork.children[child];
    return node.is_main ? main : std::max(highest - step * node.depth(), 0.0);
  };
}

DeviationRule by_level(Numbers c) {
  return [category = static_cast<int>(c[0]), main = c[1], highest = c[2], lowest = c[3], levels = c[4],
          peak = c[5]](const Fork& fork, std::size_t child) {
    if (fork.children[child].is_main) return main;
    const double tau = levels <= 1 ? 0 : std::min((fork.mother.depth() - 1) / (levels - 1), 1.0);
    return lowest + (highest - lowest) * level_share(category, tau, peak);
  };
}

DeviationRule normal(Numbers c) {
  return [mean = c[0], deviation = c[1]](const Fork& fork, std::size_t) {
    boost::random::normal_distribution<double> law(mean, deviation);
    return law(fork.chance);
  };
}

DeviationRule triangle_angles(Numbers c) {
  return [triangle = Triangle{c[0], c[1], c[2] != 0}](const Fork& fork, std::size_t child) {
    return triangle.angle(child, fork.mother.depth());
  };
}

/// By role, order or size beside the siblings.
std::vector<RuleInfo<DeviationRule>> deviations_by_rank() {
  const RuleConstant main{"main", -widest, widest};
  const RuleConstant secondary{"secondary", -widest, widest};
  const RuleConstant fork{"fork", -widest, widest};
  return {
      {"roles",
       {main, secondary},
       "main or secondary, as a child goes on with the main branch",
       "E10; Honda 1971",
       by_role},
      {"orders", {main, secondary, fork}, "by order above, below or that of the sibling", "E20", by_order},
      {"viennot",
       {main, secondary, fork},
       "main s/(k-1), secondary (s-k)/(s-1) or fork, k the order of the child, s of its sibling",
       "E17; Viennot et al. 1989",
       viennot},
      {"log_nodes",
       {main, secondary, fork},
       "by floor(log2 nodes) above, below or that of the sibling",
       "E18 with X8; Devroye and Kruszewski 1995, Figure 4",
       by_log_nodes}};
}

/// By parts of radii or sizes.
std::vector<RuleInfo<DeviationRule>> deviations_by_share() {
  const RuleConstant angle{"angle", -widest, widest};
  return {{"murray",
           {},
           "arccos((R^4 + r^4 - s^4)/(2 R^2 r^2)), r of the child, s of its sibling, R of the mother",
           "E4; Murray 1926, Kruszewski 1996, 2.3.3",
           murray},
          {"nodes_share",
           {angle},
           "angle times the siblings' part of all nodes below the fork",
           "E18 with X9; Devroye and Kruszewski 1995, Figure 4",
           nodes_share},
          {"radius_gap",
           {angle, {"main", 0, 1, 1}},
           "angle (R - r)/R, of the main child main times that: 0 or 1",
           "E23, E24; Kruszewski 1996, 3.3.3",
           radius_gap},
          {"radius_share",
           {angle},
           "angle times the siblings' part of the sum of radii",
           "E28; Kruszewski 1996, 5.1.4",
           radius_share}};
}

/// By depth, by chance, or always the same.
std::vector<RuleInfo<DeviationRule>> deviations_by_path() {
  const RuleConstant main{"main", -widest, widest};
  const RuleConstant angle{"angle", -widest, widest};
  return {{"constant", {angle}, "angle", "E9, E12, E16; Aono and Kunii 1984", same},
          {"depth",
           {angle},
           "angle/(depth + 1)",
           "E18 with X10; Devroye and Kruszewski 1995, Figure 4",
           by_depth},
          {"log_depth",
           {angle},
           "angle/(log depth + 1)",
           "E18 with X10; Devroye and Kruszewski 1995, Figure 4",
           by_log_depth},
          {"falling",
           {main, {"highest", 0, 1000}, {"step", 0, 1000}},
           "main, or max(highest - step depth, 0)",
           "E15 with X26; Kruszewski 1996, Figure 4.13",
           falling},
          {"levels",
           {{"category", 1, 5},
            main,
            {"highest", 0, widest},
            {"lowest", 0, widest},
            {"levels", 1, 1000},
            {"peak", 0.001, 0.5, 0.5}},
           "main, or from highest at the foot to lowest at the top in one of five ways",
           "E15 with X45; Aono and Kunii 1984, Tables 3 and 4",
           by_level},
          {"normal",
           {{"mean", 0, widest}, {"deviation", 0, widest}},
           "normal with that mean and standard deviation",
           "E26; Kruszewski 1996, 5.1.5",
           normal},
          {"triangle",
           {{"first", 1, 120}, {"second", 1, 120}, {"flip", 0, 1, 0}},
           "the angles of a triangle on the mother; with flip they change places at every even depth",
           "E7; Bosman 1957",
           triangle_angles}};
}

}  // namespace

double level_share(int category, double tau, double peak) {
  switch (category) {
    case 1:
      return 1 - tau;
    case 2:
      return 1 - tau * tau;
    case 3:
      return (1 - tau) * (1 - tau);
    case 4:
      return 1 - tau * tau * (3 - 2 * tau);
    default:
      return 1 - std::pow((tau - peak) / (1 - peak), 2);
  }
}

double murray_angle(double mother, double child, double sibling) {
  const double m = mother * mother, c = child * child, s = sibling * sibling;
  const double cosine = (m * m + c * c - s * s) / (2 * m * c);
  constexpr double rounding = 1e-9;
  if (!(std::abs(cosine) <= 1 + rounding))
    throw Error(fmt::format("Murray's angle of radii {:g} and {:g} on {:g}", child, sibling, mother),
                fmt::format("its cosine would be {:g}: radii must grow by an exponent of 2 or more", cosine),
                "raise the exponent of the radius, or take another rule for the deviation");
  return degrees(std::acos(std::clamp(cosine, -1.0, 1.0)));
}

const std::vector<RuleInfo<DeviationRule>>& deviation_rules() {
  static const std::vector<RuleInfo<DeviationRule>> all =
      joined({deviations_by_rank(), deviations_by_share(), deviations_by_path()});
  return all;
}

}  // namespace ramify
