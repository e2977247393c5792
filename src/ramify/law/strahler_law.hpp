#pragma once

#include "ramify/law/bounded_law.hpp"

namespace ramify {

/// P(S_n = k), S_n the Horton-Strahler number. External nodes have order 0. B6.
///
/// S = k where one child has order k and the other less, or both have k-1.
class StrahlerLaw : public BoundedLaw {
 public:
  explicit StrahlerLaw(Size largest_n) : BoundedLaw({ways, ways}, largest_n) {}

 private:
  static constexpr std::array<JoinTerm, 3> ways{{{LawForm::at, 0, LawForm::below, 0},
                                                 {LawForm::below, 0, LawForm::at, 0},
                                                 {LawForm::at, -1, LawForm::at, -1}}};
};

}  // namespace ramify
