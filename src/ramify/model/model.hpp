#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ramify/model/model_info.hpp"

namespace ramify {

/// A model with its parameters, as written on a command line or in a config, or made of numbers. Copies share
/// what it is.
class Model {
 public:
  /// "bst", "beta(10,80)", "patricia(1/4.35)", "node_beta(d,max(d,2))"; white space around each part is
  /// ignored. "file(PATH)" reads the file now; PATH is all between the first ( and the last ). Throws Error
  /// for an unknown name (nearest names given), a wrong number of parameters, a parameter that is no number,
  /// no formula or out of its domain, a file that does not hold what the model needs.
  static Model parse(std::string_view text);

  /// The model of these numbers, one for each parameter; a double stands for the fraction Rational::of says
  /// where fractions are needed. Throws Error where one is out of its domain.
  /// @param info  of a model of numbers, lives as long as the model
  static Model make(const ModelInfo& info, std::span<const double> parameters);

  /// A model that no text can name, made of data: a ramification matrix that was measured.
  /// @param info  of the models of its kind, lives as long as the model
  /// @param text  what stands for it in tables
  static Model made(const ModelInfo& info, std::string text, AnyModel kind);

  /// The model as written, without white space (but that of a path).
  const std::string& text() const { return text_; }
  const ModelInfo& info() const { return *info_; }
  std::string_view name() const { return info_->name; }
  /// One of the models of that name: model.is(Ternary::info()).
  bool is(const ModelInfo& info) const { return info_ == &info; }
  /// Numbers; none of a file or of formulas.
  const std::vector<double>& parameters() const { return parameters_; }

  /// False of a tree that is grown whole: no exact law is known, nothing is grafted.
  bool is_split() const { return std::holds_alternative<AnySplitLaw>(*kind_); }
  /// Of a split model.
  const AnySplitLaw& law() const { return std::get<AnySplitLaw>(*kind_); }
  SplitCharacter character() const;
  /// P(left = i), of a split model (SplitLaw, split_law.hpp).
  WeightWindow window(Size n, double cutoff) const;
  /// Of any other.
  const GrownModel& grown() const { return *std::get<std::shared_ptr<const GrownModel>>(*kind_); }

  /// n counts the internal nodes of a tree.
  bool counts_internal_nodes() const { return info_->n_counts == internal_nodes; }

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
  Model(const ModelInfo& info, std::string text, std::vector<double> parameters, AnyModel kind);
  std::uint64_t content_hash() const;

  const ModelInfo* info_;
  std::string text_;
  std::vector<double> parameters_;
  std::shared_ptr<const AnyModel> kind_;
};

}  // namespace ramify
