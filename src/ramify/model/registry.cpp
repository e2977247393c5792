#include "ramify/model/registry.hpp"

#include <algorithm>
#include <bit>
#include <cctype>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/core/error.hpp"
#include "ramify/core/nearest_name.hpp"
#include "ramify/core/number.hpp"
#include "ramify/model/branching.hpp"
#include "ramify/model/flow_rate.hpp"
#include "ramify/model/galton_watson.hpp"
#include "ramify/model/kary.hpp"
#include "ramify/model/ramification.hpp"
#include "ramify/model/ternary.hpp"
#include "ramify/model/trie.hpp"
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
       [](std::span<const double>) -> AnyModel { return AnySplitLaw(Bst()); }},
      {"beta",
       {"a", "b"},
       internal_nodes,
       "a, b > 0; n <= 2^50",
       "left = floor(nX), X ~ beta(a,b)",
       "A5, A8; Kruszewski 1996, 2.5.2",
       [](std::span<const double> v) -> AnyModel { return AnySplitLaw(Beta(v[0], v[1])); }},
      {"beta_multinomial",
       {"a", "b"},
       internal_nodes,
       "a, b > 0; n <= 2^50",
       "left ~ Bin(n-1,X), X ~ beta(a,b)",
       "A8; Devroye 1986, 1998",
       [](std::span<const double> v) -> AnyModel { return AnySplitLaw(BetaMultinomial(v[0], v[1])); }},
      {"split",
       {"x"},
       internal_nodes,
       "0 < x < 1; n <= 2^50",
       "deterministic: left = floor(nx)",
       "A6; Kruszewski 1996, 2.5.1",
       [](std::span<const double> v) -> AnyModel { return AnySplitLaw(FixedSplit(v[0])); }},
      {"dst",
       {"p"},
       internal_nodes,
       "0 < p < 1; n <= 2^50",
       "digital search tree: left ~ Bin(n-1,p); the thesis's binomial tree",
       "A11, X16",
       [](std::span<const double> v) -> AnyModel { return AnySplitLaw(Dst(v[0])); }},
      {"patricia",
       {"p"},
       internal_nodes,
       "0 < p < 1; n <= 2^50",
       "PATRICIA on n+1 strings: left = K-1, K ~ Bin(n+1,p) given 1 <= K <= n",
       "A13; Kruszewski 1996, 3.2.2",
       [](std::span<const double> v) -> AnyModel { return AnySplitLaw(Patricia(v[0])); }},
      {"catalan",
       {},
       internal_nodes,
       "n <= 2^50",
       "equiprobable binary tree: left = i with C_i C_(n-1-i) / C_n",
       "A15; Flajolet, Raoult, Vuillemin 1979",
       [](std::span<const double>) -> AnyModel { return AnySplitLaw(Catalan()); }},
      {"aldous",
       {"beta"},
       internal_nodes,
       "beta > -2; n <= 2^50",
       "beta-splitting: k of m = n+1 leaves left with weight f(k) f(m-k), f(k) = Gamma(beta+1+k)/k!",
       "Aldous 1996",
       [](std::span<const double> v) -> AnyModel { return AnySplitLaw(Aldous(v[0])); }},
      {"complete",
       {},
       internal_nodes,
       "none",
       "complete tree: every level full but the last, which is filled from the left",
       "A3; Knuth 1997, 2.3.4.5",
       [](std::span<const double>) -> AnyModel { return AnySplitLaw(Complete()); }},
      {"chain",
       {},
       internal_nodes,
       "none",
       "left = 0 or n-1 by the toss of a coin",
       "A4; Viennot 1990",
       [](std::span<const double>) -> AnyModel { return AnySplitLaw(Chain()); }},
      {"file",
       {"PATH"},
       internal_nodes,
       "a CSV file n,left,probability; n up to its largest",
       "a split law of one's own: P(left) for every n of a table",
       "docs/own-models.md",
       [](const std::filesystem::path& path) -> AnyModel { return AnySplitLaw(TabulatedSplit::read(path)); }},
      {"trie",
       {"p"},
       "strings",
       "0 < p < 1; n <= 2^50",
       "trie of n random bit strings, one-child nodes kept; patricia(p) is without them",
       "A12; Kruszewski 1996, B.1.1",
       [](std::span<const double> v) -> AnyModel { return grown_model(Trie(v[0])); },
       false},
      {"ternary",
       {"p"},
       internal_nodes,
       "0 < p <= 1/3; n <= 2^50",
       "three children of sizes n-1-X-max(X-1,0), max(X-1,0), X; X ~ Bin(n,p) given that all are >= 0",
       "A22, A23; Kruszewski 1996, 3.3.3",
       [](std::span<const double> v) -> AnyModel { return grown_model(Ternary(v[0])); },
       false},
      {"branching",
       {"p0", "p1", "p2"},
       "generations",
       "p0, p1, p2 >= 0, sum 1",
       "Galton-Watson process of 0, 1 or 2 children, limited to n generations",
       "A20; Kruszewski 1996, 4.2.5",
       [](std::span<const double> v) -> AnyModel { return grown_model(Branching(v[0], v[1], v[2])); },
       false},
      {"galton_watson",
       {"p0", "p1", "p2"},
       "nodes, external ones counted",
       "p0, p2 > 0, p1 >= 0, sum 1; n odd where p1 = 0",
       "Galton-Watson tree of 0, 1 or 2 children given its number of nodes",
       "A20; Dvoretzky and Motzkin 1947",
       [](std::span<const double> v) -> AnyModel {
         return std::make_shared<const GaltonWatson>(v[0], v[1], v[2]);
       },
       false},
      {"tokunaga",
       {"a", "c"},
       "order of the root, leaf order 0",
       "a, c > 0",
       "random self-similar tree with T_k = a c^(k-1) side branches k orders below",
       "Tokunaga 1978; Kovchegov and Zaliapin 2018",
       [](std::span<const double> v) -> AnyModel { return grown_model(Ramification::tokunaga(v[0], v[1])); },
       false},
      {"ramification",
       {"PATH"},
       "order of the root, leaf order 0",
       "a CSV file order,side,probability[,leaf_order]; n up to its largest order",
       "tree grown from a ramification matrix",
       "A17; Viennot et al. 1989; docs/own-models.md",
       [](const std::filesystem::path& path) -> AnyModel { return grown_model(Ramification::read(path)); },
       false},
      {"kary",
       {"k"},
       "levels, external nodes counted",
       "k = 2, 3, ..., 1000",
       "complete k-ary tree",
       "A25",
       [](std::span<const double> v) -> AnyModel { return grown_model(Kary(v[0])); },
       false},
      {"flow_rate",
       {"f"},
       "levels",
       "0 < f <= 1; n <= 50",
       "split(f/2) of size 2^n cut below level n",
       "A7, X20; Honda, Tomlinson and Fisher 1981",
       [](std::span<const double> v) -> AnyModel { return grown_model(FlowRate(v[0])); },
       false},
  };
  return all;
}

Model::Model(std::string text, std::string name, std::vector<double> parameters, AnyModel kind)
    : text_(std::move(text)),
      name_(std::move(name)),
      parameters_(std::move(parameters)),
      kind_(std::move(kind)) {}

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
  AnyModel kind = std::get<FromNumbers>(info.make)(parameters);
  return Model(without_space(text), call.name, std::move(parameters), std::move(kind));
}

bool Model::counts_internal_nodes() const {
  return find_model(name_).n_counts == internal_nodes;
}

Size Model::largest_size() const {
  if (!is_split()) return grown().largest_size();
  return std::visit([](const auto& law) { return law.largest_size(); }, law());
}

std::size_t Model::largest_order(Size n) const {
  // A strict binary tree of order k has 2^k external nodes at least.
  return is_split() ? static_cast<std::size_t>(std::bit_width(n + 1)) - 1 : grown().largest_order(n);
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
