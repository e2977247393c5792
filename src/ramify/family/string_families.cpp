#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include <boost/math/special_functions/gamma.hpp>

#include "ramify/family/all_families.hpp"
#include "ramify/family/jet_likelihood.hpp"
#include "ramify/model/dst.hpp"
#include "ramify/model/patricia.hpp"

namespace ramify {
namespace {

double log_binomial(double trials, double k) {
  return boost::math::lgamma(trials + 1) - boost::math::lgamma(k + 1) - boost::math::lgamma(trials - k + 1);
}

/// Splits of strings by a first bit: k of `strings` are 0 with probability C(strings, k) p^k q^(strings-k).
///
/// With s <= l strings on the sides the two orders have p^s q^l + p^l q^s = (pq)^s (p^d + q^d), d = l-s: the
/// sums of s and of counts of every d are all that there is to know.
class StringLikelihood {
 public:
  /// @param added  strings of a child beside its internal nodes: 1 for those at the tips, 0 for those at
  /// nodes
  StringLikelihood(const ObservedSplits& observed, double added) {
    std::map<double, double> differences;
    for (const ObservedSplit& split : observed.splits()) {
      const double s = static_cast<double>(split.smaller) + added;
      const double l = static_cast<double>(split.larger) + added;
      smaller_ += split.count * s;
      constant_ -= split.count * log_binomial(s + l, s);
      differences[l - s] += split.count;
    }
    for (const auto& [difference, count] : differences)
      if (difference > 0) differences_.push_back({difference, count});
  }

  /// @param p  at most 1/2
  template <class T>
  T operator()(const T& log_p, const T& log_q) const {
    using std::exp;
    using std::log1p;
    T minus_log = constant_ - smaller_ * (log_p + log_q);
    const T log_odds = log_p - log_q;
    for (const auto& [difference, count] : differences_)
      minus_log -= count * (difference * log_q + log1p(exp(difference * log_odds)));
    return minus_log;
  }

 private:
  struct Difference {
    double difference, count;
  };

  double smaller_ = 0, constant_ = 0;
  std::vector<Difference> differences_;
};

/// Not all strings have the same bit: 1 - p^m - q^m, once for every node of m strings.
class Divided {
 public:
  explicit Divided(const ObservedSplits& observed) {
    for (const ObservedSplit& split : observed.splits()) {
      const double strings = static_cast<double>(split.size()) + 1;
      if (nodes_.empty() || nodes_.back().strings != strings) nodes_.push_back({strings, 0});
      nodes_.back().count += split.count;
    }
  }

  template <class T>
  T operator()(const T& log_p, const T& log_q) const {
    using std::exp;
    using std::expm1;
    using std::log;
    T sum(0.0);
    for (const auto& [strings, count] : nodes_)
      sum += count * log(-expm1(strings * log_q) - exp(strings * log_p));
    return sum;
  }

 private:
  struct Node {
    double strings, count;
  };

  std::vector<Node> nodes_;  // ascending sizes, as the splits come
};

/// The larger of p and 1-p has the same likelihood, and the smaller loses no digits.
template <class T>
T folded(const T& p) {
  return p > 0.5 ? 1.0 - p : p;
}

/// At 0.02 the limiting ratio is 50. Laws of lopsided splits take the longest.
FamilyParameter bit_probability() {
  return {"p", {SearchScale::Kind::logit, 0, 1}, 0.02, 0.98, {0.45, 0.3, 0.15, 0.05}};
}

constexpr std::string_view mirrored = "p and 1-p grow mirror images: p <= 1/2 is given";

}  // namespace

Family patricia_family() {
  return {.name = "patricia",
          .model = &Patricia::info(),
          .fixed = {},
          .parameters = {bit_probability()},
          .mirror = Mirror::reflected,
          .alike = mirrored,
          .of_splits = [](const ObservedSplits& splits) {
            return jet_likelihood<1>(patricia_family(), [strings = StringLikelihood(splits, 1),
                                                         divided = Divided(splits)](const auto& values) {
              using std::log, std::log1p;
              const auto p = folded(values[0]), log_p = log(p), log_q = log1p(-p);
              return strings(log_p, log_q) + divided(log_p, log_q);
            });
          }};
}

Family dst_family() {
  return {.name = "dst",
          .model = &Dst::info(),
          .fixed = {},
          .parameters = {bit_probability()},
          .mirror = Mirror::reflected,
          .alike = mirrored,
          .of_splits = [](const ObservedSplits& splits) {
            return jet_likelihood<1>(dst_family(),
                                     [strings = StringLikelihood(splits, 0)](const auto& values) {
                                       using std::log, std::log1p;
                                       const auto p = folded(values[0]), log_p = log(p), log_q = log1p(-p);
                                       return strings(log_p, log_q);
                                     });
          }};
}

}  // namespace ramify
