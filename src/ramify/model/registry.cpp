#include "ramify/model/registry.hpp"

#include <algorithm>
#include <cctype>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/core/error.hpp"
#include "ramify/core/nearest_name.hpp"
#include "ramify/core/number.hpp"
#include "ramify/random/hash.hpp"
#include "ramify/text/trimmed.hpp"

namespace ramify {
namespace {

constexpr std::string_view internal_nodes = "internal nodes";

std::vector<std::string> known_names() {
  std::vector<std::string> names;
  for (const auto& info : models()) names.emplace_back(info.name);
  return names;
}

const ModelInfo& find_model(const std::string& name) {
  const auto& all = models();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const ModelInfo& info) { return info.name == name; });
  if (found != all.end()) return *found;
  throw Error(fmt::format("unknown model '{}'", name), "no model has that name",
              did_you_mean(name, known_names()) + "see: ramify list models");
}

std::string without_space(std::string_view text) {
  std::string compact(text);
  std::erase_if(compact, [](unsigned char c) { return std::isspace(c) != 0; });
  return compact;
}

struct Call {
  std::string name;
  std::optional<std::string_view> inside;  ///< the parentheses; none of "name"
};

/// "name" or "name(...)".
Call split_call(std::string_view text) {
  const auto open = text.find('(');
  if (open == std::string_view::npos) return {without_space(text), std::nullopt};
  const std::string_view rest = trimmed(text.substr(open + 1));
  if (!rest.ends_with(')'))
    throw Error(fmt::format("model '{}'", trimmed(text)), "a '(' without its ')'",
                "write it like beta(10,80)");
  return {without_space(text.substr(0, open)), rest.substr(0, rest.size() - 1)};
}

std::vector<std::string> split_arguments(const Call& call) {
  std::vector<std::string> arguments;
  if (!call.inside) return arguments;
  const std::string inside = without_space(*call.inside);
  std::size_t begin = 0;
  for (;;) {
    const auto comma = inside.find(',', begin);
    arguments.push_back(inside.substr(begin, comma - begin));
    if (comma == std::string::npos) return arguments;
    begin = comma + 1;
  }
}

std::vector<double> read_parameters(const ModelInfo& info, const std::vector<std::string>& arguments) {
  if (arguments.size() != info.parameters.size())
    throw Error(fmt::format("model '{}' has {} parameter(s)", info.name, arguments.size()),
                fmt::format("{} takes {}", info.name, info.parameters.size()),
                fmt::format("write {}", info.signature()));
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

std::string ModelInfo::signature() const {
  return parameters.empty() ? std::string(name) : fmt::format("{}({})", name, fmt::join(parameters, ","));
}

const std::vector<ModelInfo>& models() {  // NOLINT(readability-function-size): a table
  static const std::vector<ModelInfo> all{
      {"bst",
       {},
       internal_nodes,
       "none",
       "random binary search tree: left uniform on 0..n-1",
       "A14; Devroye 1986",
       [](std::span<const double>) -> AnySplitLaw { return Bst(); }},
      {"beta",
       {"a", "b"},
       internal_nodes,
       "a, b > 0; n <= 2^50",
       "left = floor(nX), X ~ beta(a,b)",
       "A5, A8; Kruszewski 1996, 2.5.2",
       [](std::span<const double> v) -> AnySplitLaw { return Beta(v[0], v[1]); }},
      {"beta_multinomial",
       {"a", "b"},
       internal_nodes,
       "a, b > 0; n <= 2^50",
       "left ~ Bin(n-1,X), X ~ beta(a,b)",
       "A8; Devroye 1986, 1998",
       [](std::span<const double> v) -> AnySplitLaw { return BetaMultinomial(v[0], v[1]); }},
      {"split",
       {"x"},
       internal_nodes,
       "0 < x < 1; n <= 2^50",
       "deterministic: left = floor(nx)",
       "A6; Kruszewski 1996, 2.5.1",
       [](std::span<const double> v) -> AnySplitLaw { return FixedSplit(v[0]); }},
      {"dst",
       {"p"},
       internal_nodes,
       "0 < p < 1; n <= 2^50",
       "digital search tree: left ~ Bin(n-1,p); the thesis's binomial tree",
       "A11, X16",
       [](std::span<const double> v) -> AnySplitLaw { return Dst(v[0]); }},
      {"patricia",
       {"p"},
       internal_nodes,
       "0 < p < 1; n <= 2^50",
       "PATRICIA on n+1 strings: left = K-1, K ~ Bin(n+1,p) given 1 <= K <= n",
       "A13; Kruszewski 1996, 3.2.2",
       [](std::span<const double> v) -> AnySplitLaw { return Patricia(v[0]); }},
      {"catalan",
       {},
       internal_nodes,
       "n <= 2^50",
       "equiprobable binary tree: left = i with C_i C_(n-1-i) / C_n",
       "A15; Flajolet, Raoult, Vuillemin 1979",
       [](std::span<const double>) -> AnySplitLaw { return Catalan(); }},
      {"file",
       {"PATH"},
       internal_nodes,
       "a CSV file n,left,probability; n up to its largest",
       "a split law of one's own: P(left) for every n of a table",
       "docs/own-models.md",
       [](const std::filesystem::path& path) -> AnySplitLaw { return TabulatedSplit::read(path); }},
  };
  return all;
}

Model::Model(std::string text, std::string name, std::vector<double> parameters, AnySplitLaw law)
    : text_(std::move(text)),
      name_(std::move(name)),
      parameters_(std::move(parameters)),
      law_(std::move(law)) {}

Model Model::parse(std::string_view text) {
  const Call call = split_call(text);
  const ModelInfo& info = find_model(call.name);
  if (const auto* from_file = std::get_if<FromFile>(&info.make)) {
    const std::string path(trimmed(call.inside.value_or("")));
    if (path.empty())
      throw Error(fmt::format("model '{}' names no file", trimmed(text)), "its split law is read from one",
                  fmt::format("write {}, such as {}(law.csv)", info.signature(), info.name));
    return Model(fmt::format("{}({})", info.name, path), call.name, {}, (*from_file)(path));
  }
  const std::vector<std::string> arguments = split_arguments(call);
  std::vector<double> parameters = read_parameters(info, arguments);
  AnySplitLaw law = std::get<FromNumbers>(info.make)(parameters);
  return Model(without_space(text), call.name, std::move(parameters), std::move(law));
}

Size Model::largest_size() const {
  return std::visit([](const auto& law) { return law.largest_size(); }, law_);
}

void Model::require_size(Size n) const {
  if (n <= largest_size()) return;
  const std::string problem = fmt::format("n = {} for {}", n, text_);
  if (std::holds_alternative<TabulatedSplit>(law_))
    throw Error(problem, fmt::format("its table ends at n = {}", largest_size()),
                "take a smaller n, or add the larger ones to the file");
  throw Error(problem,
              fmt::format("{} draws sizes up to {}: above, its arithmetic no longer reaches every index",
                          name_, largest_size()),
              "take a smaller n, or bst, which reaches 2^62");
}

std::uint64_t Model::stream_cell(Size n) const {
  const auto* table = std::get_if<TabulatedSplit>(&law_);
  const std::string values = table != nullptr ? fmt::format("{:016x}", table->hash())
                                              : fmt::format("{}", fmt::join(parameters_, ","));
  return hash_text(fmt::format("{}({})#{}", name_, values, n));
}

}  // namespace ramify
