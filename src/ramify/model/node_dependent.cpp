#include "ramify/model/node_dependent.hpp"

#include <algorithm>
#include <initializer_list>

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/model/model_info.hpp"

namespace ramify {
namespace {

/// 1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 15, ... and last, last >= 1.
std::vector<Size> trial_steps(Size last) {
  std::vector<Size> steps;
  for (Size step = 1; step < last; step += std::max<Size>(1, step / 4)) steps.push_back(step);
  steps.push_back(last);
  return steps;
}

/// Those of the law, under the names of the formulas that stand for them.
std::vector<Parameter> formula_parameters(const ModelInfo& law,
                                          std::initializer_list<std::string_view> names) {
  std::vector<Parameter> parameters = law.parameters;
  std::transform(names.begin(), names.end(), parameters.begin(), parameters.begin(),
                 [](std::string_view name, Parameter parameter) {
                   parameter.name = name;
                   return parameter;
                 });
  return parameters;
}

template <class Kind>
AnyModel make_model(std::span<const std::string> formulas) {
  return grown_model(NodeDependent<Kind>(formulas));
}

}  // namespace

std::vector<Formula> read_formulas(const ModelInfo& info, std::span<const std::string> texts) {
  std::vector<Formula> formulas;
  for (std::size_t i = 0; i < texts.size(); ++i)
    formulas.emplace_back(texts[i], fmt::format("{}: {}", info.name, info.parameters[i].name));
  return formulas;
}

double value_at(const ModelInfo& info, std::vector<Formula>& formulas, std::size_t i, const NodePlace& node) {
  const double value = formulas[i](node);
  const Parameter& parameter = info.parameters[i];
  if (parameter.accepts(value)) return value;
  throw Error(fmt::format("{}: {} = '{}' is {} at d = {}, size = {}, n = {}", info.name, parameter.name,
                          formulas[i].text(), value, node.depth, node.size, node.n),
              fmt::format("it {}", parameter.requirement()),
              "change the formula, or bound it with min, max or a ? b : c");
}

std::vector<NodePlace> trial_places(Size n) {
  std::vector<NodePlace> places;
  if (n < 2) return places;
  // A node of depth d has d-1 nodes above it.
  for (const Size depth : trial_steps(n - 1))
    for (const Size size : trial_steps(n - depth + 1))
      if (size >= 2 && (depth > 1 || size == n)) places.push_back({size, depth, n});
  return places;
}

const ModelInfo& NodeBeta::info() {
  static const ModelInfo info{
      .name = "node_beta",
      .parameters = formula_parameters(Beta::info(), {"A", "B"}),
      .given = "formulas of d, size, n",
      .largest_n = max_double_size,
      .description = "left = floor(size X), X ~ beta(A,B), A and B formulas of the node",
      .source = "A10; Kruszewski 1996, 2.5.5; docs/own-models.md",
      .make = make_model<NodeBeta>,
      .is_split = false};
  return info;
}

const ModelInfo& NodeSplit::info() {
  static const ModelInfo info{.name = "node_split",
                              .parameters = formula_parameters(FixedSplit::info(), {"X"}),
                              .given = "a formula of d, size, n",
                              .largest_n = max_double_size,
                              .description = "left = floor(size X), X a formula of the node",
                              .source = "A6, A10; docs/own-models.md",
                              .make = make_model<NodeSplit>,
                              .is_split = false};
  return info;
}

const ModelInfo& NodeDst::info() {
  static const ModelInfo info{.name = "node_dst",
                              .parameters = formula_parameters(Dst::info(), {"P"}),
                              .given = "a formula of d, size, n",
                              .largest_n = max_double_size,
                              .description = "left ~ Bin(size-1,P), P a formula of the node",
                              .source = "A11, A24; docs/own-models.md",
                              .make = make_model<NodeDst>,
                              .is_split = false};
  return info;
}

const ModelInfo& NodeTernary::info() {
  static const ModelInfo info{.name = "node_ternary",
                              .parameters = formula_parameters(Ternary::info(), {"P"}),
                              .given = "a formula of d, size, n",
                              .largest_n = max_double_size,
                              .description = "ternary(P), P a formula of the node",
                              .source = "A24; Kruszewski 1996, 3.3.4; docs/own-models.md",
                              .make = make_model<NodeTernary>,
                              .is_split = false,
                              .is_binary = false};
  return info;
}

}  // namespace ramify
