#include "ramify/model/model.hpp"

#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/core/error.hpp"
#include "ramify/core/number.hpp"
#include "ramify/model/registry.hpp"
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

std::string problem_of(const ModelInfo& info, std::size_t i, std::string_view argument) {
  return fmt::format("{} with {} = '{}'", info.signature(), info.parameters[i].name, argument);
}

std::vector<double> read_parameters(const ModelInfo& info, const std::vector<std::string>& arguments) {
  std::vector<double> values;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const auto value = parse_real(arguments[i]);
    if (!value)
      throw Error(problem_of(info, i, arguments[i]), "not a finite number",
                  "write a number or a fraction, such as 0.23 or 1/4.35");
    values.push_back(*value);
  }
  return values;
}

bool needs_fractions(const ModelInfo& info) {
  return std::holds_alternative<FromFractions>(info.make);
}

/// The numbers as they are written, where they are needed so.
std::vector<Rational> read_fractions(const ModelInfo& info, const std::vector<std::string>& arguments) {
  std::vector<Rational> fractions;
  for (std::size_t i = 0; needs_fractions(info) && i < arguments.size(); ++i) {
    const auto fraction = Rational::parse(arguments[i]);
    if (!fraction)
      throw Error(problem_of(info, i, arguments[i]), "it is taken as written, and has more than 19 digits",
                  "write fewer");
    fractions.push_back(*fraction);
  }
  return fractions;
}

/// The shortest text that reads back as the same number.
std::string text_of(double value, const Rational& exact) {
  std::string decimal = format_exact(value);
  if (Rational::parse(decimal) == exact) return decimal;
  return fmt::format("{}/{}", exact.numerator, exact.denominator);
}

AnyModel model_of(const ModelInfo& info, std::span<const double> parameters,
                  std::span<const Rational> exact) {
  if (needs_fractions(info)) return std::get<FromFractions>(info.make)(parameters, exact);
  return std::get<FromNumbers>(info.make)(parameters);
}

std::string written(const ModelInfo& info, const std::vector<std::string>& arguments) {
  return arguments.empty() ? std::string(info.name)
                           : fmt::format("{}({})", info.name, fmt::join(arguments, ","));
}

}  // namespace

Model::Model(const ModelInfo& info, std::string text, std::vector<double> parameters, AnyModel kind)
    : info_(&info),
      text_(std::move(text)),
      parameters_(std::move(parameters)),
      kind_(std::make_shared<const AnyModel>(std::move(kind))) {}

Model Model::parse(std::string_view text) {
  const Call call = split_call(text);
  const ModelInfo& info = find_model(call.name);
  if (const auto* from_file = std::get_if<FromFile>(&info.make)) {
    const std::string path(trimmed(call.inside.value_or("")));
    if (path.empty())
      throw Error(fmt::format("model '{}' names no file", trimmed(text)), "it is read from one",
                  fmt::format("write {}, such as {}(law.csv)", info.signature(), info.name));
    return Model(info, fmt::format("{}({})", info.name, path), {}, (*from_file)(path));
  }
  const std::vector<std::string> arguments = split_arguments(call);
  if (arguments.size() != info.parameters.size())
    throw Error(fmt::format("model '{}' has {} parameter(s)", info.name, arguments.size()),
                fmt::format("{} takes {}", info.name, info.parameters.size()),
                fmt::format("write {}", info.signature()));
  if (const auto* from_texts = std::get_if<FromTexts>(&info.make))
    return Model(info, written(info, arguments), {}, (*from_texts)(arguments));
  std::vector<double> parameters = read_parameters(info, arguments);
  if (needs_fractions(info)) require_domain(info, parameters);  // none of these is a fraction
  AnyModel kind = model_of(info, parameters, read_fractions(info, arguments));
  return Model(info, written(info, arguments), std::move(parameters), std::move(kind));
}

Model Model::make(const ModelInfo& info, std::span<const double> parameters) {
  require_domain(info, parameters);
  std::vector<std::string> arguments;
  std::vector<Rational> exact;
  for (const double value : parameters) {
    if (needs_fractions(info)) exact.push_back(Rational::of(value));
    arguments.push_back(needs_fractions(info) ? text_of(value, exact.back()) : format_exact(value));
  }
  return Model(info, written(info, arguments), {parameters.begin(), parameters.end()},
               model_of(info, parameters, exact));
}

Model Model::made(const ModelInfo& info, std::string text, AnyModel kind) {
  return Model(info, std::move(text), {}, std::move(kind));
}

SplitCharacter Model::character() const {
  return std::visit([](const auto& law) { return law.character(); }, law());
}

WeightWindow Model::window(Size n, double cutoff) const {
  return std::visit([&](const auto& law) { return law.window(n, cutoff); }, law());
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
  const bool has_table = is_split() && std::holds_alternative<FromFile>(info_->make);
  if (n > largest_size() && has_table)
    throw Error(problem, fmt::format("its table ends at n = {}", largest_size()),
                "take a smaller n, or add the larger ones to the file");
  if (n > largest_size() && is_split())
    throw Error(problem,
                fmt::format("{} draws sizes up to {}: above, its arithmetic no longer reaches every index",
                            name(), largest_size()),
                "take a smaller n, or bst, which reaches 2^62");
  if (is_split()) return;
  if (n > largest_size())
    throw Error(problem, fmt::format("{} is defined for n up to {}", name(), largest_size()),
                "take a smaller n");
  grown().require_size(n);
  constexpr double most_nodes = 1e9;
  if (const double nodes = grown().expected_nodes(n); !(nodes <= most_nodes))
    throw Error(problem, fmt::format("trees of this model are stored, and have about {:.2g} nodes", nodes),
                fmt::format("take an n with {:.0g} or less", most_nodes));
}

std::uint64_t Model::content_hash() const {
  if (!is_split()) return grown().content_hash();
  const auto hash_of = [](const auto& law) -> std::uint64_t {
    if constexpr (requires { law.content_hash(); }) {
      return law.content_hash();
    } else {
      return 0;
    }
  };
  return std::visit(hash_of, law());
}

std::uint64_t Model::stream_cell(Size n) const {
  const std::string values = parameters_.empty() && content_hash() != 0
                                 ? fmt::format("{:016x}", content_hash())
                                 : fmt::format("{}", fmt::join(parameters_, ","));
  return hash_text(fmt::format("{}({})#{}", name(), values, n));
}

bool operator==(const Model& a, const Model& b) {
  if (a.is_split() && b.is_split()) return a.law() == b.law();
  return a.is_split() == b.is_split() && a.info_ == b.info_ && a.parameters_ == b.parameters_ &&
         a.content_hash() == b.content_hash();
}

}  // namespace ramify
