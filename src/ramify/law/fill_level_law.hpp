#pragma once

#include "ramify/law/bounded_law.hpp"

namespace ramify {

/// P(F_n = k), F_n the fill level: 1 + the minimum over the children; external nodes are counted, the root
/// is level 0. B18.
class FillLevelLaw : public BoundedLaw {
 public:
  explicit FillLevelLaw(Size largest_n) : BoundedLaw({ways, ways}, largest_n) {}

 private:
  static constexpr std::array<JoinTerm, 2> ways{
      {{LawForm::at, -1, LawForm::from, -1}, {LawForm::from, 0, LawForm::at, -1}}};
};

}  // namespace ramify
