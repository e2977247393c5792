#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "ramify/tree/grammar.hpp"

namespace ramify::test {

/// P(left = i), i = 0..n-1, by size.
using SplitPmf = std::function<std::vector<double>(Size n)>;

/// A law that is not the model's, and what slip would draw from it.
struct WrongLaw {
  std::string slip;
  SplitPmf law;
};

/// A model, its law, and the nearest mistakes: those told apart at every size, and those only small trees
/// show.
struct ModelCase {
  std::string model;
  SplitPmf law;
  std::vector<WrongLaw> wrong;
  std::vector<WrongLaw> wrong_when_small;

  friend std::ostream& operator<<(std::ostream& out, const ModelCase& one) { return out << one.model; }
};

const std::vector<ModelCase>& model_cases();

/// The model as part of a test's name.
std::string name_of(const ModelCase& model);

}  // namespace ramify::test
