#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "ramify/core/rational.hpp"
#include "ramify/model/grown_model.hpp"
#include "ramify/model/parameter.hpp"
#include "ramify/model/split_laws.hpp"

namespace ramify {

/// What a model is: a split law, of whose trees ramify knows exact laws, or a tree that is grown whole.
using AnyModel = std::variant<AnySplitLaw, std::shared_ptr<const GrownModel>>;

/// How a model comes from what stands between the parentheses: from numbers, from numbers that are needed as
/// they are written, from texts between commas, or from a file.
using FromNumbers = AnyModel (*)(std::span<const double> parameters);
using FromFractions = AnyModel (*)(std::span<const double> parameters, std::span<const Rational> exact);
using FromTexts = AnyModel (*)(std::span<const std::string> texts);
using FromFile = AnyModel (*)(const std::filesystem::path& path);

/// What n counts, of models of which it counts that.
inline constexpr std::string_view internal_nodes = "internal nodes";

/// What a model says of itself: a line of `ramify list models`, and what reads it.
struct ModelInfo {
  std::string_view name;  ///< "beta"
  // NOLINTBEGIN(readability-redundant-member-init): -Wextra wants them where an aggregate leaves one out
  std::vector<Parameter> parameters = {};  ///< "a", "b"
  std::string_view given = {};             ///< what they are where they are no numbers
  std::string_view together = {};          ///< of their domain, what no interval of one of them says
  // NOLINTEND(readability-redundant-member-init)
  Size largest_n = max_size;  ///< where the same for all parameters
  std::string_view n_counts = internal_nodes;
  std::string_view description;  ///< the split law in a line
  std::string_view source;       ///< author year, catalogue number
  std::variant<FromNumbers, FromFractions, FromTexts, FromFile> make;
  bool is_split = true;   ///< as Model::is_split
  bool is_binary = true;  ///< no node has three children or more

  /// "beta(a,b)"
  std::string signature() const;

  /// "a, b > 0; n <= 2^50"
  std::string domain() const;
};

/// Throws Error unless every value is in the domain of its parameter. @param values  one for each parameter
void require_domain(const ModelInfo& info, std::span<const double> values);

}  // namespace ramify
