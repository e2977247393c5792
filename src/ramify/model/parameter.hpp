#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>

namespace ramify {

/// The numbers between two ends; an end may belong to it or not.
struct Domain {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool holds_low = false;
  bool holds_high = false;

  bool contains(double x) const {
    return (x > low || (holds_low && x == low)) && (x < high || (holds_high && x == high));
  }

  friend bool operator==(const Domain&, const Domain&) = default;
};

/// What stands between the commas of a model, and which values it may have.
struct Parameter {
  std::string_view name;  ///< "a"
  Domain domain = {};     ///< of a number; of texts and files all
  // NOLINTBEGIN(readability-redundant-member-init): -Wextra wants them where an aggregate leaves one out
  std::string_view remedy = {};  ///< what to give in place of a value out of the domain
  std::string_view reason = {};  ///< why the domain ends where it does, if it needs one
  // NOLINTEND(readability-redundant-member-init)
  bool is_whole = false;

  bool accepts(double value) const;

  /// "must lie in (0,1)", "must be a finite number above 0"
  std::string requirement() const;
};

/// 0 < value < 1.
constexpr Parameter probability(std::string_view name) {
  return {name, {0, 1}, "give a number strictly between 0 and 1, such as 0.23 or 1/4.35"};
}

/// Positive and finite.
constexpr Parameter positive(std::string_view name) {
  return {name, {.low = 0}, "give a positive number, such as 10"};
}

/// Of a beta law. Beyond 1e9 a rejection that compares differences of order 1/shape would decide by rounding
/// (at 1e16 it is all noise, at 1e100 it never ends), and below 1e-9 X is 0 or 1 in any tree that fits into a
/// machine: there `split`, dst and `chain` are the laws to take.
constexpr Parameter beta_shape(std::string_view name) {
  return {name,
          {.low = 1e-9, .high = 1e9, .holds_low = true, .holds_high = true},
          "give a number from 1e-9 to 1e9, such as 10"};
}

/// Throws Error unless the parameter accepts the value. model is the way it is written, "dst(p)".
void require_domain(std::string_view model, const Parameter& parameter, double value);

/// "a, b > 0", "p0, p2 > 0, p1 >= 0", "0 < p <= 1/3": parameters of one domain together; nothing of those
/// that accept all.
std::string describe_domains(std::span<const Parameter> parameters);

/// The sum of the probabilities. Throws Error, beginning with `problem`, unless they are >= 0 and sum to 1
/// within 1e-9.
double require_distribution(std::string_view problem, std::span<const double> probabilities);

}  // namespace ramify
