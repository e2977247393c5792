#include "ramify/compare/verdict.hpp"

namespace ramify {

std::string_view to_string(Outcome outcome) {
  switch (outcome) {
    case Outcome::reproduced:
      return "reproduced";
    case Outcome::refuted:
      return "refuted";
    case Outcome::inconclusive:
      break;
  }
  return "inconclusive";
}

}  // namespace ramify
