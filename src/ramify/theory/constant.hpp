#pragma once

#include <string>

namespace ramify {

/// A constant of a model: one row of `ramify theory`.
struct Constant {
  std::string name;  ///< "depth"
  double value;      ///< of the model whose parameters are the doubles that were read
  double error;      ///< bound on |printed value - true value|: rounding to a double, printing, and what is
                     ///< before them
  std::string formula;  ///< what was computed
  std::string source;   ///< author year, catalogue number
};

}  // namespace ramify
