#include "support/grown_cases.hpp"

#define RAMIFY_MATRIX RAMIFY_SOURCE_DIR "/data/ramification_bst.csv"

namespace ramify::test {

const std::vector<GrownCase>& grown_cases() {
  static const std::vector<GrownCase> cases{
      {"trie(0.3)", 300},
      {"ternary(0.2)", 300},
      {"node_beta(d,1)", 200},
      {"node_split(1/(1+d))", 200},
      {"node_dst(0.3)", 200},
      {"node_ternary(0.2)", 200},
      {"branching(0.2,0.3,0.5)", 12},
      {"galton_watson(0.3,0.4,0.3)", 301},
      {"tokunaga(1,2)", 4},
      {"ramification(" RAMIFY_MATRIX ")", 5},
      {"hybrid(" RAMIFY_MATRIX "," RAMIFY_MATRIX ",ABABA)", 5},
      {"markov(" RAMIFY_SOURCE_DIR "/tests/golden/chain.csv)", 5},
      {"kary(3)", 5},
      {"flow_rate(0.5)", 7},
  };
  return cases;
}

}  // namespace ramify::test
