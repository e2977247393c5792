#include <cmath>
#include <numbers>
#include <vector>

#include "ramify/family/all_families.hpp"
#include "ramify/family/jet_likelihood.hpp"
#include "ramify/family/log_rising.hpp"
#include "ramify/family/split_sizes.hpp"
#include "ramify/model/ford.hpp"

namespace ramify {
namespace {

/// Of m leaves k go left with probability
///   V(k) V(m-k) / V(m) [alpha/2 + (1 - 2 alpha) k (m-k) / (m (m-1))],
///   V(k) = (1-alpha) (2-alpha) ... (k-1-alpha) / k!   (model/ford.hpp).
class FordLikelihood {
 public:
  explicit FordLikelihood(const ObservedSplits& observed) : sizes_(observed) {
    for (const ObservedSplit& split : observed.splits()) {
      const double k = static_cast<double>(split.smaller) + 1, other = static_cast<double>(split.larger) + 1;
      brackets_.push_back({k * other / ((k + other) * (k + other - 1)), split.count});
      constant_ += split.count * std::log(k * other / (k + other));
      if (!split.is_even()) constant_ -= split.count * std::numbers::ln2;
    }
  }

  template <class T>
  T operator()(const T& alpha) const {
    using std::log;
    const LogRising<T> grown(-alpha);  // k V(k), k the number of leaves, of k-1 internal nodes
    T minus_log(constant_);
    for (std::size_t i = 0; i < sizes_.sizes.size(); ++i)
      minus_log += (sizes_.nodes[i] - sizes_.children[i]) * grown(sizes_.sizes[i]);
    const T lopsided = alpha / 2.0, even = 1.0 - 2.0 * alpha;
    for (const auto& [product, count] : brackets_) minus_log -= count * log(lopsided + even * product);
    return minus_log;
  }

 private:
  struct Bracket {
    double product, count;
  };

  SplitSizes sizes_;
  std::vector<Bracket> brackets_;
  double constant_ = 0;
};

}  // namespace

Family ford_family() {
  return {.name = "ford",
          .model = &Ford::info(),
          .fixed = {},
          .parameters = {{"alpha", {SearchScale::Kind::plain}, 0, 0.99, {0.05, 0.3, 0.6, 0.9}}},
          .mirror = Mirror::none,
          .alike = "",
          .of_splits =
              [](const ObservedSplits& splits) {
                return jet_likelihood<1>(ford_family(),
                                         [likelihood = FordLikelihood(splits)](const auto& values) {
                                           return likelihood(values[0]);
                                         });
              },
          .nested = {{"bst", {0}}, {"catalan", {0.5}}}};
}

}  // namespace ramify
