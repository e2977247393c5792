#pragma once

#include "ramify/law/bounded_law.hpp"

namespace ramify {

/// P(B_n = k), B_n the balance number. External nodes have 0. B16.
///
/// B = max(1 + B of the smaller child, B of the larger); 1 + the maximum where the sizes are equal.
class BalanceLaw : public BoundedLaw {
 public:
  explicit BalanceLaw(Size largest_n) : BoundedLaw({unequal, equal}, largest_n) {}

 private:
  static constexpr std::array<JoinTerm, 2> unequal{
      {{LawForm::at, -1, LawForm::below, 1}, {LawForm::below, -1, LawForm::at, 0}}};
  static constexpr std::array<JoinTerm, 2> equal{
      {{LawForm::at, -1, LawForm::below, 0}, {LawForm::below, -1, LawForm::at, -1}}};
};

}  // namespace ramify
