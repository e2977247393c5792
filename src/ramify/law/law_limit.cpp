#include "ramify/law/law_limit.hpp"

#include <algorithm>

namespace ramify {
namespace {

struct Limit {
  Size all_laws;
  Size order_moments;
};

// Seconds on one core of 2020s server hardware: of all laws that ExactMeans knows, and of OrderMoments.
Limit limit(const Bst&) {
  return {8192, 2048};  // 2.4, 0.6
}
Limit limit(const Catalan&) {
  return {3000, 2048};  // 1.3, 0.7: heights and depths spread over 13.6 sqrt(n) values
}
Limit of_fraction(double a, double b) {
  const bool wide = std::min(a, b) < 0.1;         // chains: depths spread over n/2 values
  return {wide ? Size{2048} : Size{4096}, 2048};  // 2.5 at a = b = 0.01, 2.2 at 0.1, 0.5 at 2; 0.7
}
Limit limit(const Beta& law) {
  return of_fraction(law.a(), law.b());
}
Limit limit(const BetaMultinomial& law) {
  return of_fraction(law.a(), law.b());
}
Limit of_fraction(double p) {
  const bool lopsided = std::min(p, 1 - p) < 0.01;     // depths spread over thousands of values
  return {lopsided ? Size{4096} : Size{16384}, 4096};  // 0.6-1.4, 0.8; split 0.1, 0.2
}
Limit limit(const Dst& law) {
  return of_fraction(law.p());
}
Limit limit(const Patricia& law) {
  return of_fraction(law.p());
}
/// Whatever it holds: it may be chains.
Limit limit(const TabulatedSplit& law) {
  const Size all = std::min<Size>(law.largest_size(), 2048);
  return {all, all};
}
Limit limit(const FixedSplit& law) {
  return of_fraction(law.x());
}
Limit limit(const Aldous& law) {
  return of_fraction(law.beta() + 1, law.beta() + 1);
}
Limit limit(const Complete&) {
  return of_fraction(0.5);
}
Limit limit(const Chain&) {
  return {16384, 4096};  // one entry a row, one value a size
}

}  // namespace

Size law_limit(const Model& model) {
  return std::visit([](const auto& law) { return limit(law).all_laws; }, model.law());
}

Size order_moments_limit(const Model& model) {
  return std::visit([](const auto& law) { return limit(law).order_moments; }, model.law());
}

}  // namespace ramify
