#include "ramify/model/registry.hpp"

#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/core/error.hpp"
#include "ramify/core/find_named.hpp"
#include "ramify/core/number.hpp"
#include "ramify/random/hash.hpp"
#include "ramify/text/trimmed.hpp"
#include "ramify/tree/largest_order.hpp"

namespace ramify {
namespace {

struct Call {
  std::string name;
  std::optional<std::string_view> inside;  ///< the parentheses; none of "name"
};

/// "name" or "name(...)".
Call split_call(std::string_view text) {
  const auto open = text.find('(');
  if (open == std::string_view::npos) return {std::string(trimmed(text)), std::nullopt};
  const std::string_view rest = trimmed(text.substr(open + 1));
  if (!rest.ends_with(')'))
    throw Error(fmt::format("model '{}'", trimmed(text)), "a '(' without its ')'",
                "write it like beta(10,80)");
  return {std::string(trimmed(text.substr(0, open))), rest.substr(0, rest.size() - 1)};
}

/// What stands between commas that are not inside parentheses.
std::vector<std::string> split_arguments(const Call& call) {
  std::vector<std::string> arguments;
  if (!call.inside) return arguments;
  int depth = 0;
  std::string argument;
  for (const char c : *call.inside) {
    if (c == '(') ++depth;
    if (c == ')') --depth;
    if (c == ',' && depth == 0)
      arguments.push_back(std::exchange(argument, {}));
    else
      argument += c;
  }
  arguments.push_back(argument);
  for (auto& each : arguments) each = std::string(trimmed(each));
  return arguments;
}

std::vector<double> read_parameters(const ModelInfo& info, const std::vector<std::string>& arguments) {
  std::vector<double> values;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const auto value = parse_real(arguments[i]);
    if (!value)
      throw Error(fmt::format("{} with {} = '{}'", info.signature(), info.parameters[i], arguments[i]),
                  "not a finite number", "write a number or a fraction, such as 0.23 or 1/4.35");
    values.push_back(*value);
  }
  return values;
}

}  // namespace

Model::Model(std::string text, std::string name, std::vector<double> parameters, AnyModel kind)
    : text_(std::move(text)),
      name_(std::move(name)),
      parameters_(std::move(parameters)),
      kind_(std::move(kind)) {}

Model Model::parse(std::string_view text) {
  const Call call = split_call(text);
  const ModelInfo& info = find_named(models(), &ModelInfo::name, call.name, "model");
  if (const auto* from_file = std::get_if<FromFile>(&info.make)) {
    const std::string path(trimmed(call.inside.value_or("")));
    if (path.empty())
      throw Error(fmt::format("model '{}' names no file", trimmed(text)), "it is read from one",
                  fmt::format("write {}, such as {}(law.csv)", info.signature(), info.name));
    return Model(fmt::format("{}({})", info.name, path), call.name, {}, (*from_file)(path));
  }
  const std::vector<std::string> arguments = split_arguments(call);
  if (arguments.size() != info.parameters.size())
    throw Error(fmt::format("model '{}' has {} parameter(s)", info.name, arguments.size()),
                fmt::format("{} takes {}", info.name, info.parameters.size()),
                fmt::format("write {}", info.signature()));
  const std::string written =
      arguments.empty() ? call.name : fmt::format("{}({})", call.name, fmt::join(arguments, ","));
  if (const auto* from_texts = std::get_if<FromTexts>(&info.make))
    return Model(written, call.name, {}, (*from_texts)(arguments));
  std::vector<double> parameters = read_parameters(info, arguments);
  AnyModel kind = std::get<FromNumbers>(info.make)(parameters);
  return Model(written, call.name, std::move(parameters), std::move(kind));
}

bool Model::counts_internal_nodes() const {
  return find_named(models(), &ModelInfo::name, name_, "model").n_counts == internal_nodes;
}

Size Model::largest_size() const {
  if (!is_split()) return grown().largest_size();
  return std::visit([](const auto& law) { return law.largest_size(); }, law());
}

std::size_t Model::largest_order(Size n) const {
  return is_split() ? largest_strahler_order(n + 1) : grown().largest_order(n);
}

void Model::require_size(Size n) const {
  const std::string problem = fmt::format("n = {} for {}", n, text_);
  const bool has_table = is_split() && std::holds_alternative<TabulatedSplit>(law());
  if (n > largest_size() && has_table)
    throw Error(problem, fmt::format("its table ends at n = {}", largest_size()),
                "take a smaller n, or add the larger ones to the file");
  if (n > largest_size() && is_split())
    throw Error(problem,
                fmt::format("{} draws sizes up to {}: above, its arithmetic no longer reaches every index",
                            name_, largest_size()),
                "take a smaller n, or bst, which reaches 2^62");
  if (is_split()) return;
  if (n > largest_size())
    throw Error(problem, fmt::format("{} is defined for n up to {}", name_, largest_size()),
                "take a smaller n");
  grown().require_size(n);
  constexpr double most_nodes = 1e9;
  if (const double nodes = grown().expected_nodes(n); !(nodes <= most_nodes))
    throw Error(problem, fmt::format("trees of this model are stored, and have about {:.2g} nodes", nodes),
                fmt::format("take an n with {:.0g} or less", most_nodes));
}

std::uint64_t Model::content_hash() const {
  if (!is_split()) return grown().content_hash();
  const auto* table = std::get_if<TabulatedSplit>(&law());
  return table != nullptr ? table->hash() : 0;
}

std::uint64_t Model::stream_cell(Size n) const {
  const std::string values = parameters_.empty() && content_hash() != 0
                                 ? fmt::format("{:016x}", content_hash())
                                 : fmt::format("{}", fmt::join(parameters_, ","));
  return hash_text(fmt::format("{}({})#{}", name_, values, n));
}

bool operator==(const Model& a, const Model& b) {
  if (a.is_split() && b.is_split()) return a.law() == b.law();
  return a.is_split() == b.is_split() && a.name_ == b.name_ && a.parameters_ == b.parameters_ &&
         a.content_hash() == b.content_hash();
}

}  // namespace ramify
