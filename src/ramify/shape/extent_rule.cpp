#include "ramify/shape/extent_rule.hpp"

#include <cmath>
#include <limits>

#include "ramify/random/uniform.hpp"
#include "ramify/shape/triangle.hpp"

namespace ramify {
namespace {

constexpr double no_end = std::numeric_limits<double>::infinity();

using Constants = std::span<const double>;
using Question = ExtentQuestion;

bool is_root(const NodeFacts& node) {
  return node.main + node.secondary == 1;
}

ExtentRule constant(Constants c) {
  return [c = c[0]](const Question&) { return c; };
}

ExtentRule leaves_power(Constants c) {
  return [c = c[0], x = c[1]](const Question& q) {
    return c * (x == 3 ? std::cbrt(q.node.leaves) : std::pow(q.node.leaves, 1 / x));
  };
}

ExtentRule radius_power(Constants c) {
  return [c = c[0], e = c[1]](const Question& q) {
    return c * (e == 1 ? q.node.radius : std::pow(q.node.radius, e));
  };
}

ExtentRule ratios(Constants c) {
  return [c = c[0], main = c[1], secondary = c[2], trunk = c[3]](const Question& q) {
    if (is_root(q.node)) return c * trunk;
    const bool is_on_trunk = q.node.depth() == 2;
    return q.of_mother * (q.node.is_main ? main : secondary) / (is_on_trunk ? trunk : 1);
  };
}

ExtentRule order_power(Constants c) {
  return [c = c[0], e = c[1]](const Question& q) { return c * std::pow(q.node.order, e); };
}

ExtentRule order_ratio(Constants c) {
  return [c = c[0], ratio = c[1]](const Question& q) {
    return c * std::pow(ratio, q.node.order - q.root.order);
  };
}

ExtentRule nodes_power(Constants c) {
  return [c = c[0], e = c[1]](const Question& q) { return c * std::pow(q.node.nodes, e); };
}

ExtentRule nodes_log(Constants c) {
  return [c = c[0]](const Question& q) { return c * std::log(q.node.nodes); };
}

ExtentRule depth_inverse(Constants c) {
  return [c = c[0], base = c[1], e = c[2]](const Question& q) {
    return c / (base + std::pow(q.node.depth(), e));
  };
}

ExtentRule depth_log_inverse(Constants c) {
  return [c = c[0], base = c[1]](const Question& q) { return c / (base + std::log(q.node.depth())); };
}

ExtentRule uniform(Constants c) {
  return [c = c[0], low = c[1], high = c[2]](const Question& q) {
    return c * (low + (high - low) * uniform_open(q.chance));
  };
}

ExtentRule legs(Constants c) {
  return [c = c[0], triangle = Triangle{c[1], c[2], c[3] != 0}](const Question& q) {
    return is_root(q.node) ? c : q.of_mother * triangle.leg(q.node.place, q.node.depth() - 1);
  };
}

/// By what is below a node, or by its radius.
std::vector<RuleInfo<ExtentRule>> extents_by_subtree() {
  return {{"constant", {{"c", 0, no_end}}, "c", "E25; Niklas 1986", constant},
          {"leaves_power",
           {{"c", 0, no_end}, {"exponent", 1, no_end, 3}},
           "c leaves^(1/exponent): what R^x = sum of the children's R^x comes to",
           "E2, E28, E36; Kruszewski 1996, 2.3.1",
           leaves_power},
          {"radius_power",
           {{"c", 0, no_end}, {"exponent", -10, 10, 1}},
           "c radius^exponent; of a length",
           "E3; Kruszewski 1996, 2.3.2",
           radius_power},
          {"order_power",
           {{"c", 0, no_end}, {"exponent", -10, 10, 1}},
           "c order^exponent, leaf order 1",
           "E17; Viennot et al. 1989",
           order_power},
          {"order_ratio",
           {{"c", 0, no_end}, {"ratio", 0, 10}},
           "c ratio^(order - order of the root)",
           "E17, E27 with X1; Kruszewski 1996, 5.1.6",
           order_ratio},
          {"nodes_power",
           {{"c", 0, no_end}, {"exponent", -10, 10, 0.5}},
           "c nodes^exponent",
           "E18; Devroye and Kruszewski 1995",
           nodes_power},
          {"nodes_log", {{"c", 0, no_end}}, "c log(nodes)", "E18; Devroye and Kruszewski 1995", nodes_log}};
}

/// By the way to a node, or by chance.
std::vector<RuleInfo<ExtentRule>> extents_by_path() {
  return {
      {"ratios",
       {{"c", 0, no_end}, {"main", 0, 10}, {"secondary", 0, 10}, {"trunk", 0.001, 1000, 1}},
       "c of the root; main or secondary times that of the mother as she was placed; the root's own times "
       "trunk",
       "E10, E12; Honda 1971, Aono and Kunii 1984",
       ratios},
      {"depth_inverse",
       {{"c", 0, no_end}, {"base", 0, no_end, 0}, {"exponent", -10, 10, 1}},
       "c/(base + depth^exponent)",
       "E18; Devroye and Kruszewski 1995, Figure 3",
       depth_inverse},
      {"depth_log_inverse",
       {{"c", 0, no_end}, {"base", 0.001, no_end, 1}},
       "c/(base + log depth)",
       "E18; Devroye and Kruszewski 1995, Figure 3",
       depth_log_inverse},
      {"uniform",
       {{"c", 0, no_end}, {"low", 0, no_end, 0.8}, {"high", 0, no_end, 1.2}},
       "c U, U uniform from low to high",
       "E26; Kruszewski 1996, 5.1.5",
       uniform},
      {"legs",
       {{"c", 0, no_end}, {"first", 1, 120}, {"second", 1, 120}, {"flip", 0, 1, 0}},
       "c of the root; times the leg on which a child stands of a triangle on its mother",
       "E7; Bosman 1957",
       legs}};
}

}  // namespace

const std::vector<RuleInfo<ExtentRule>>& extent_rules() {
  static const std::vector<RuleInfo<ExtentRule>> all = joined({extents_by_subtree(), extents_by_path()});
  return all;
}

}  // namespace ramify
