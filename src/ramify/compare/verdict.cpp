#include "ramify/compare/verdict.hpp"

namespace ramify {

std::string_view to_string(Decision decision) {
  switch (decision) {
    case Decision::reproduced:
      return "reproduced";
    case Decision::refuted:
      return "refuted";
    case Decision::inconclusive:
      break;
  }
  return "inconclusive";
}

std::string_view SamplerCheck::word() const {
  if (!takes_trees) return "-";
  if (means == 0) return "not sampled";
  return failed() ? "failed" : "ok";
}

}  // namespace ramify
