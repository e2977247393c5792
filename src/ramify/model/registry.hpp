#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "ramify/model/aldous.hpp"
#include "ramify/model/beta.hpp"
#include "ramify/model/beta_multinomial.hpp"
#include "ramify/model/bst.hpp"
#include "ramify/model/catalan.hpp"
#include "ramify/model/chain.hpp"
#include "ramify/model/complete.hpp"
#include "ramify/model/dst.hpp"
#include "ramify/model/fixed_split.hpp"
#include "ramify/model/grown_model.hpp"
#include "ramify/model/patricia.hpp"
#include "ramify/model/tabulated_split.hpp"

namespace ramify {

/// The split law of any model; std::visit gives the concrete type, so nothing is virtual for each node.
using AnySplitLaw = std::variant<Bst, Beta, BetaMultinomial, FixedSplit, Dst, Patricia, Catalan, Aldous,
                                 Complete, Chain, TabulatedSplit>;

/// What a model is: a split law, of whose trees ramify knows exact laws, or a tree that is grown whole.
using AnyModel = std::variant<AnySplitLaw, std::shared_ptr<const GrownModel>>;

/// How a model comes from what stands between the parentheses: from numbers, from texts between commas, or
/// from a file.
using FromNumbers = AnyModel (*)(std::span<const double> parameters);
using FromTexts = AnyModel (*)(std::span<const std::string> texts);
using FromFile = AnyModel (*)(const std::filesystem::path& path);

/// What n counts, of models of which it counts that.
inline constexpr std::string_view internal_nodes = "internal nodes";

/// What `ramify list models` says of a model.
struct ModelInfo {
  std::string_view name;                     ///< "beta"
  std::vector<std::string_view> parameters;  ///< "a", "b"
  std::string_view n_counts;                 ///< what n counts
  std::string_view domain;                   ///< of the parameters
  std::string_view description;              ///< the split law in a line
  std::string_view source;                   ///< author year, catalogue number
  std::variant<FromNumbers, FromTexts, FromFile> make;
  bool is_split = true;   ///< as Model::is_split
  bool is_binary = true;  ///< no node has three children or more

  /// "beta(a,b)"
  std::string signature() const;
};

/// All models, in the order they are listed.
const std::vector<ModelInfo>& models();

/// A model with its parameters, as written on a command line or in a config.
class Model {
 public:
  /// "bst", "beta(10,80)", "patricia(1/4.35)", "node_beta(d,max(d,2))"; white space around each part is
  /// ignored. "file(PATH)" reads the file now; PATH is all between the first ( and the last ). Throws Error
  /// for an unknown name (nearest names given), a wrong number of parameters, a parameter that is no number,
  /// no formula or out of its domain, a file that does not hold what the model needs.
  static Model parse(std::string_view text);

  /// The model as written, without white space (but that of a path).
  const std::string& text() const { return text_; }
  const std::string& name() const { return name_; }
  /// Numbers; none of a file or of formulas.
  const std::vector<double>& parameters() const { return parameters_; }

  /// False of a tree that is grown whole: no exact law is known, nothing is grafted.
  bool is_split() const { return std::holds_alternative<AnySplitLaw>(kind_); }
  /// Of a split model.
  const AnySplitLaw& law() const { return std::get<AnySplitLaw>(kind_); }
  /// Of any other.
  const GrownModel& grown() const { return *std::get<std::shared_ptr<const GrownModel>>(kind_); }

  /// n counts the internal nodes of a tree.
  bool counts_internal_nodes() const;

  Size largest_size() const;

  /// The largest Horton-Strahler order, leaf order 0, of its trees.
  std::size_t largest_order(Size n) const;

  /// Throws Error where n is larger than the model can draw, or there is no such tree.
  void require_size(Size n) const;

  /// Hash of (model, n): the cell half of a StreamKey. Depends on the values of the parameters and the
  /// content of a file, not on how they are written or where it is.
  std::uint64_t stream_cell(Size n) const;

  /// Same law, however it is written.
  friend bool operator==(const Model& a, const Model& b);

 private:
  Model(std::string text, std::string name, std::vector<double> parameters, AnyModel kind);
  std::uint64_t content_hash() const;

  std::string text_;
  std::string name_;
  std::vector<double> parameters_;
  AnyModel kind_;
};

}  // namespace ramify
