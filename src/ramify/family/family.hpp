#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ramify/family/observed_bi_orders.hpp"
#include "ramify/family/observed_splits.hpp"
#include "ramify/family/split_likelihood.hpp"
#include "ramify/model/model.hpp"

namespace ramify {

/// How a parameter becomes the number that is searched, in which domains have no ends nearby and likelihoods
/// are nearly parabolas.
struct SearchScale {
  enum class Kind {
    plain,      ///< x
    log_above,  ///< log(x - low)
    logit,      ///< log((x - low) / (high - x))
  };
  Kind kind = Kind::plain;
  double low = 0, high = 1;  ///< the ends that the scale moves to infinity

  double of(double x) const;
  double back(double searched) const;

  /// The derivative of back.
  double slope(double searched) const;
};

/// A free parameter of a family.
struct FamilyParameter {
  std::string_view name;  ///< as the model has it: "p"
  SearchScale scale;
  double lowest, highest;      ///< where it is searched
  std::vector<double> starts;  ///< where a search begins: one at least in the basin of every optimum
};

/// Which parameters grow trees that nobody can tell apart, where left and right mean nothing.
enum class Mirror {
  none,
  reflected,  ///< p and 1-p, on a scale about 1/2
  exchanged,  ///< (a,b) and (b,a)
};

/// A family without parameters that is another at these values: the same split law at every size, where left
/// and right mean nothing.
struct NestedFamily {
  std::string_view name;
  std::vector<double> values;
};

/// What a tree is given of which a family has the likelihood: likelihoods given different things cannot be
/// compared.
enum class Given {
  size,   ///< its internal nodes
  order,  ///< the order of its root: trees that are grown by order
};

/// "n", "order"
std::string_view name_of(Given given);

/// A family of models that is fitted: a model with free parameters, or one without any, to compare with.
///
/// One small file each in this folder; families() lists them.
struct Family {
  std::string_view name;  ///< "patricia", "aldous(-1)"
  const ModelInfo* model;
  std::vector<double> fixed;  ///< the model's parameters where none is free
  std::vector<FamilyParameter> parameters;
  Mirror mirror = Mirror::none;
  std::string_view alike;  ///< what the data cannot tell, in a sentence; empty where all can be told

  // NOLINTBEGIN(readability-redundant-member-init): -Wextra wants them where an aggregate leaves one out
  /// The likelihood of the splits of whole trees, given their sizes; none of a family without a law.
  SplitLikelihood (*of_splits)(const ObservedSplits& splits) = nullptr;

  Given given = Given::size;
  /// The likelihood of whole trees given their orders, in place of that; none where the estimates are known
  /// in closed form.
  SplitLikelihood (*of_bi_orders)(const ObservedBiOrders& observed) = nullptr;
  std::string_view closed_form = {};  ///< what these are, in a line; empty where parameters are searched
  // NOLINTEND(readability-redundant-member-init)

  /// The simpler families that it holds, exactly; those that it only tends to are none.
  // NOLINTNEXTLINE(readability-redundant-member-init): -Wextra wants it where an aggregate leaves it out
  std::vector<NestedFamily> nested = {};

  /// Of values of the free parameters. Throws Error where one is out of the model's domain.
  Model at(std::span<const double> values) const;

  /// No law is known: what its counts of streams are like is found by growing trees.
  bool is_simulated() const { return given == Given::size && of_splits == nullptr; }

  /// Free parameters and what is searched, one for one.
  std::vector<double> searched(std::span<const double> values) const;
  std::vector<double> values(std::span<const double> searched) const;

  /// Every start of one parameter with every start of the others, on the scale that is searched.
  std::vector<std::vector<double>> starts() const;
};

/// All families given the size that have a law, those with parameters first.
std::span<const Family> families();

/// All, those of families() first.
const std::vector<Family>& all_families();

/// Of all. Throws Error for an unknown name, nearest names given.
const Family& find_family(std::string_view name);

}  // namespace ramify
