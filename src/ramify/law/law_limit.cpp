#include "ramify/law/law_limit.hpp"

namespace ramify {
namespace {

// Seconds at the limit, one core of 2020s server hardware, every statistic that ExactMeans knows.
Size limit(const Bst&) {
  return 4096;
}  // 0.9
Size limit(const Catalan&) {
  return 3000;
}  // 1.4: heights spread over 13 sqrt(n) values
Size limit(const Beta&) {
  return 1024;
}  // 0.5-1.5: two incomplete betas for every entry of a row
Size limit(const Dst&) {
  return 8192;
}  // 1: rows of O(sqrt n) entries
Size limit(const Patricia&) {
  return 8192;
}  // 1
Size limit(const FixedSplit&) {
  return 8192;
}  // 0.1

}  // namespace

Size law_limit(const Model& model) {
  return std::visit([](const auto& law) { return limit(law); }, model.law());
}

}  // namespace ramify
