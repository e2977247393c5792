#include "support/model_cases.hpp"

#include <cctype>

#include "support/reference_laws.hpp"

namespace ramify::test {
namespace {

SplitPmf beta(double a, double b) {
  return [=](Size n) { return beta_law(n, a, b); };
}
SplitPmf short_beta(double a, double b) {
  return [=](Size n) { return short_beta_law(n, a, b); };
}
SplitPmf beta_multinomial(double a, double b) {
  return [=](Size n) { return beta_multinomial_law(n, a, b); };
}
SplitPmf long_beta_multinomial(double a, double b) {
  return [=](Size n) { return long_beta_multinomial_law(n, a, b); };
}
SplitPmf dst(double p) {
  return [=](Size n) { return dst_law(n, p); };
}
SplitPmf patricia(double p) {
  return [=](Size n) { return patricia_law(n, p); };
}
SplitPmf short_patricia(double p) {
  return [=](Size n) { return short_patricia_law(n, p); };
}
SplitPmf thesis_binomial(double p) {
  return [=](Size n) { return thesis_binomial_law(n, p); };
}
SplitPmf aldous(double beta) {
  return [=](Size n) { return aldous_law(n, beta); };
}
SplitPmf short_aldous(double beta) {
  return [=](Size n) { return short_aldous_law(n, beta); };
}
SplitPmf ford(double a) {
  return [=](Size n) { return ford_law(n, a); };
}
SplitPmf short_ford(double a) {
  return [=](Size n) { return short_ford_law(n, a); };
}
SplitPmf split(double x) {
  return [=](Size n) { return split_law(n, x); };
}

std::vector<ModelCase> floor_models() {
  return {
      {"bst", uniform_law, {{"left = 0..n-2", short_uniform_law}, {"catalan", catalan_law}}, {}},
      {"beta(1,1)", uniform_law, {{"beta(1,1.1)", beta(1, 1.1)}}, {{"(n-1)X", short_beta(1, 1)}}},
      {"beta(10,80)", beta(10, 80), {{"a and b swapped", beta(80, 10)}}, {{"(n-1)X", short_beta(10, 80)}}},
      {"beta(2,5)", beta(2, 5), {{"a and b swapped", beta(5, 2)}}, {{"(n-1)X", short_beta(2, 5)}}},
      {"beta(0.3,0.2)",
       beta(0.3, 0.2),
       {{"a and b swapped", beta(0.2, 0.3)}},
       {{"(n-1)X", short_beta(0.3, 0.2)}}},
      {"beta(0.01,0.01)", beta(0.01, 0.01), {{"b doubled", beta(0.01, 0.02)}}, {}},
      {"beta(1000,1000)",
       beta(1000, 1000),
       {{"a one too many in 100", beta(1010, 1000)}},
       {{"(n-1)X", short_beta(1000, 1000)}}},
      {"split(0.25)", split(0.25), {{"1-x", split(0.75)}}, {}},
  };
}

std::vector<ModelCase> multinomial_models() {
  return {
      {"beta_multinomial(1,1)", uniform_law, {{"b = 1.1", beta_multinomial(1, 1.1)}}, {}},
      {"beta_multinomial(2,5)",
       beta_multinomial(2, 5),
       {{"a and b swapped", beta_multinomial(5, 2)}, {"X constant", dst(2.0 / 7)}},
       {{"Bin(n,X)", long_beta_multinomial(2, 5)}, {"floor model", beta(2, 5)}}},
      {"beta_multinomial(0.3,0.2)",
       beta_multinomial(0.3, 0.2),
       {{"a and b swapped", beta_multinomial(0.2, 0.3)}},
       {{"Bin(n,X)", long_beta_multinomial(0.3, 0.2)}, {"floor model", beta(0.3, 0.2)}}},
      {"beta_multinomial(0.01,0.01)",
       beta_multinomial(0.01, 0.01),
       {{"b doubled", beta_multinomial(0.01, 0.02)}},
       {}},
      {"beta_multinomial(1000,1000)",
       beta_multinomial(1000, 1000),
       {{"a one too many in 20", beta_multinomial(1050, 1000)}, {"floor model", beta(1000, 1000)}},
       {{"Bin(n,X)", long_beta_multinomial(1000, 1000)}}},
  };
}

std::vector<ModelCase> string_models() {
  return {
      {"dst(0.23)",
       dst(0.23),
       {{"patricia", patricia(0.23)}, {"1-p", dst(0.77)}},
       {{"Bin(n,p)", thesis_binomial(0.23)}}},
      {"dst(1/2)",
       dst(0.5),
       {{"p = 0.49", dst(0.49)}},
       {{"patricia", patricia(0.5)}, {"Bin(n,p)", thesis_binomial(0.5)}}},
      {"dst(0.01)", dst(0.01), {{"1-p", dst(0.99)}}, {{"patricia", patricia(0.01)}}},
      {"patricia(1/4.35)",
       patricia(1 / 4.35),
       {{"dst", dst(1 / 4.35)}, {"1-p", patricia(1 - 1 / 4.35)}},
       {{"n strings", short_patricia(1 / 4.35)}}},
      {"patricia(0.7)",
       patricia(0.7),
       {{"1-p", patricia(0.3)}},
       {{"dst", dst(0.7)}, {"n strings", short_patricia(0.7)}}},
      {"patricia(0.001)",
       patricia(0.001),
       {{"dst", dst(0.001)}, {"1-p", patricia(0.999)}},
       {{"n strings", short_patricia(0.001)}}},
      {"catalan", catalan_law, {{"bst", uniform_law}, {"C_i C_(n-2-i)", short_catalan_law}}, {}},
  };
}

std::vector<ModelCase> aldous_models() {
  return {
      {"aldous(-1.999)", aldous(-1.999), {}, {{"chain", chain_law}, {"beta = -1.99", aldous(-1.99)}}},
      {"aldous(-1.9)", aldous(-1.9), {{"beta = -1.85", aldous(-1.85)}}, {{"n leaves", short_aldous(-1.9)}}},
      {"aldous(-3/2)", catalan_law, {{"beta = -1.4", aldous(-1.4)}}, {{"n leaves", short_catalan_law}}},
      {"aldous(-1)",
       aldous(-1),
       {{"beta = -0.8", aldous(-0.8)}, {"bst", uniform_law}},
       {{"n leaves", short_aldous(-1)}}},
      {"aldous(-0.5)",
       aldous(-0.5),
       {{"empty sides too", beta_multinomial(0.5, 0.5)}},
       {{"n leaves", short_aldous(-0.5)}}},
      {"aldous(-0.01)", aldous(-0.01), {{"beta = 0.2", aldous(0.2)}}, {{"n leaves", short_aldous(-0.01)}}},
      {"aldous(0)", uniform_law, {{"beta = -0.2", aldous(-0.2)}}, {{"n leaves", short_uniform_law}}},
      {"aldous(10)",
       aldous(10),
       {{"beta = 5", aldous(5)}},
       {{"n leaves", short_aldous(10)}, {"empty sides too", beta_multinomial(11, 11)}}},
      {"aldous(1e9)", patricia(0.5), {{"p = 0.49", patricia(0.49)}}, {{"dst", dst(0.5)}}},
  };
}

std::vector<ModelCase> ford_models() {
  return {
      {"ford(0)", uniform_law, {{"alpha = 0.05", ford(0.05)}}, {{"n leaves", short_uniform_law}}},
      {"ford(0.01)", ford(0.01), {{"alpha = 0.05", ford(0.05)}}, {}},
      {"ford(0.3)",
       ford(0.3),
       {{"alpha = 0.35", ford(0.35)}, {"the first term alone", aldous(-1.3)}},
       {{"n leaves", short_ford(0.3)}}},
      {"ford(1/2)", catalan_law, {{"alpha = 0.55", ford(0.55)}}, {{"n leaves", short_catalan_law}}},
      {"ford(0.8)",
       ford(0.8),
       {{"alpha = 0.85", ford(0.85)}},
       {{"n leaves", short_ford(0.8)}, {"the first term alone", aldous(-1.8)}}},
      {"ford(0.999)", ford(0.999), {}, {{"chain", chain_law}, {"alpha = 0.99", ford(0.99)}}},
      {"ford(1)", chain_law, {{"on the left", left_chain_law}}, {}},
  };
}

std::vector<ModelCase> extreme_shapes() {
  return {
      {"complete",
       complete_law,
       {{"filled from the right", right_complete_law}, {"the last node on the right", short_complete_law}},
       {}},
      {"chain", chain_law, {{"on the left", left_chain_law}, {"bst", uniform_law}}, {}},
  };
}

}  // namespace

const std::vector<ModelCase>& model_cases() {
  static const std::vector<ModelCase> cases = [] {
    auto all = floor_models();
    for (const auto& more :
         {multinomial_models(), string_models(), aldous_models(), ford_models(), extreme_shapes()})
      all.insert(all.end(), more.begin(), more.end());
    return all;
  }();
  return cases;
}

std::string name_of(const ModelCase& model) {
  std::string name;
  for (const char c : model.model) name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return name;
}

}  // namespace ramify::test
