#include "claim.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <mutex>
#include <sstream>

#include "verdicts.hpp"
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/core/contract.hpp"
#include "ramify/core/error.hpp"
#include "ramify/core/find_named.hpp"

namespace ramify {
namespace {

std::string spoken_of(const Claim& claim) {
  std::vector<std::string> models;
  for (const auto& part : claim.parts)
    if (part.model && std::ranges::find(models, part.model->text()) == models.end())
      models.push_back(part.model->text());
  return fmt::format("{}", fmt::join(models, ", "));
}

void require_trees_taken(const Claim& claim, const RunConfig& config) {
  if (!claim.takes_trees())
    throw Error(fmt::format("{}: claim {}", config.path, claim.id), "it is decided without trees",
                "take it out of the config");
}

void require_models(const Claim& claim, const RunConfig& config) {
  for (const auto& group : config.groups)
    for (const auto& model : group.models)
      if (!claim.speaks_of(model))
        throw Error(fmt::format("{}: claim {} with model {}", config.path, claim.id, model.text()),
                    fmt::format("its parts are of {}", spoken_of(claim)),
                    "take the model, or the claim, out of the config");
}

/// The sizes of a model in all groups of a config.
std::size_t sizes_of(const Model& model, const RunConfig& config) {
  std::size_t sizes = 0;
  for (const auto& group : config.groups)
    sizes += group.sizes.size() * static_cast<std::size_t>(std::ranges::count(group.models, model));
  return sizes;
}

void require_sizes(const Claim& claim, const RunConfig& config) {
  for (const auto& group : config.groups)
    for (const auto& model : group.models)
      if (const std::size_t sizes = sizes_of(model, config); sizes < claim_sizes)
        throw Error(
            fmt::format("{}: claim {} with {} sizes of {}", config.path, claim.id, sizes, model.text()),
            fmt::format("{} or more are held against the laws", claim_sizes), "add sizes to n");
}

void require_trees(const Claim& claim, const RunConfig& config) {
  for (const auto& group : config.groups)
    for (const Size n : group.sizes)
      if (const std::uint64_t trees = group.replicates.count(n); trees < claim_trees)
        throw Error(
            fmt::format("{}: claim {} with {} replicate(s) at n = {}", config.path, claim.id, trees, n),
            "the error of a mean is taken from the spread of its trees",
            fmt::format("take {} or more", claim_trees));
}

void require_statistics(const Claim& claim, const RunConfig& config) {
  for (const auto& part : claim.parts)
    if (part.statistic != nullptr && !config.statistics.contains(*part.statistic))
      throw Error(fmt::format("{}: claim {} without '{}'", config.path, claim.id, part.statistic->name),
                  "it is of that statistic", "add it to statistics");
}

void require_needs(const Claim& claim, const RunConfig& config) {
  require_trees_taken(claim, config);
  require_statistics(claim, config);
  require_models(claim, config);
  require_sizes(claim, config);
  require_trees(claim, config);
}

/// A claim before it is made.
struct Numbered {
  std::string_view id;
  Claim (*make)();
};

constexpr std::array catalogue{Numbered{"C1", external_nodes_claim},
                               Numbered{"C2", largest_order_claim},
                               Numbered{"C3", extreme_orders_claim},
                               Numbered{"C4", stream_bounds_claim},
                               Numbered{"C6", depth_claim},
                               Numbered{"C7", height_claim},
                               Numbered{"C8", split_moments_claim},
                               Numbered{"C9", order_by_ratio_claim},
                               Numbered{"C10", fixed_split_order_claim},
                               Numbered{"C11", fixed_split_ratio_claim},
                               Numbered{"C12", first_order_claim},
                               Numbered{"C13", patricia_order_claim},
                               Numbered{"C14", trie_balance_claim},
                               Numbered{"C15", fair_fill_claim},
                               Numbered{"C16", trie_fill_claim},
                               Numbered{"C17", patricia_fill_claim},
                               Numbered{"C18", bst_fill_claim},
                               Numbered{"C19", bst_balance_claim},
                               Numbered{"C20", bst_order_claim},
                               Numbered{"C21", mean_split_order_claim},
                               Numbered{"C22", catalan_order_claim},
                               Numbered{"C23", growth_ratio_claim},
                               Numbered{"C24", lung_claim},
                               Numbered{"C33", equivalence_claim},
                               Numbered{"C35", second_law_claim},
                               Numbered{"H2", recipe_claim}};

/// Made once; any thread.
const Claim& made(const Numbered& numbered) {
  static std::mutex mutex;
  static std::map<std::string_view, Claim> all;  // its elements stay where they are
  const std::scoped_lock lock(mutex);
  auto place = all.find(numbered.id);
  if (place == all.end()) place = all.emplace(numbered.id, numbered.make()).first;
  RAMIFY_EXPECTS(place->second.id == numbered.id);
  return place->second;
}

/// "C20" of "C20.2": parts are decided together.
std::string whole_claim(const std::string& id) {
  const auto point = id.find('.');
  const bool has_part = point != std::string::npos && point + 1 < id.size() &&
                        id.find_first_not_of("0123456789", point + 1) == std::string::npos;
  return has_part ? id.substr(0, point) : id;
}

/// The claim of an id in either case. Throws Error for one that is not there, and for a part that it has not.
const Claim& find_claim(std::string id) {
  std::ranges::transform(id, id.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  const std::string whole = whole_claim(id);
  const Claim& claim = made(find_named(catalogue, &Numbered::id, whole, "claim"));
  const auto is_it = [&](const ClaimPart& part) { return part.statement.part == id; };
  if (id != whole && std::ranges::none_of(claim.parts, is_it))
    throw Error(fmt::format("claim {}", id),
                fmt::format("the parts of {} end with {}", whole, claim.parts.back().statement.part),
                "see: ramify list claims");
  return claim;
}

}  // namespace

std::vector<const Claim*> claims_among(const std::function<bool(std::string_view id)>& is_wanted) {
  std::vector<const Claim*> found;
  for (const Numbered& numbered : catalogue)
    if (is_wanted(numbered.id)) found.push_back(&made(numbered));
  return found;
}

std::vector<const Claim*> claims() {
  return claims_among([](std::string_view) { return true; });
}

std::vector<const Claim*> find_claims(std::string_view ids) {
  std::vector<const Claim*> found;
  std::string text(ids);
  std::ranges::replace(text, ',', ' ');
  std::istringstream words{text};
  for (std::string id; words >> id;) found.push_back(&find_claim(id));
  return found;
}

std::vector<const Claim*> served_claims(const RunConfig& config) {
  const auto served = find_claims(config.claim.value_or(""));
  for (const Claim* claim : served) require_needs(*claim, config);
  return served;
}

ClaimPart part_without_trees(Statement statement, std::function<Basis(const Evidence&)> basis) {
  return {std::move(statement), std::nullopt, nullptr, std::move(basis)};
}

bool Claim::takes_trees() const {
  return std::ranges::any_of(parts, [](const ClaimPart& part) { return part.model.has_value(); });
}

bool Claim::speaks_of(const Model& model) const {
  return std::ranges::find(parts, model, &ClaimPart::model) != parts.end();
}

Table claim_table() {
  Table table(
      {"claim", "part", "statement", "source", "convention", "relation", "formula", "theory", "rivals"});
  for (const Claim* claim : claims())
    for (const auto& [statement, model, statistic, basis] : claim->parts)
      table.add(Row()
                    .texts({claim->id, statement.part, statement.text, statement.source, statement.convention,
                            to_string(statement.relation), statement.formula})
                    .summary(statement.theory)
                    .text(in_words(statement.rivals)));
  return table;
}

}  // namespace ramify
