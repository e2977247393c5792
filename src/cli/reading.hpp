#pragma once

#include <string>
#include <vector>

#include "program.hpp"

#include "ramify/measure/measure_files.hpp"

namespace ramify::cli {

/// Declares --resolve, in the one way it is said everywhere.
void add_resolve(Verb& verb, std::string& resolve);

/// Files of trees, or of counts of streams, and how they are read: of the verbs that measure them.
struct Reading {
  std::vector<std::string> files;
  std::string format = "auto", leaf_order = "1", root, scale = "0", resolve;
  bool keep_unary = false;

  void add_to(Verb& verb);

  /// Throws Error for a value that is none of an option's.
  MeasureRequest request() const;
};

}  // namespace ramify::cli
