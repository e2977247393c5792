#include <cmath>
#include <vector>

#include "ramify/family/all_families.hpp"
#include "ramify/family/beta_shapes.hpp"
#include "ramify/family/jet_likelihood.hpp"
#include "ramify/family/log_rising.hpp"
#include "ramify/family/split_sizes.hpp"
#include "ramify/model/beta_multinomial.hpp"

namespace ramify {
namespace {

/// P(left = i) = (a)_i/i! (b)_j/j! / ((a+b)_(i+j)/(i+j)!), in rising factorials.
class BetaMultinomialLikelihood {
 public:
  explicit BetaMultinomialLikelihood(const ObservedSplits& observed) : sizes_(observed) {
    for (const ObservedSplit& split : observed.splits()) counts_.push_back(split.count);
  }

  template <class T>
  T operator()(const T& a, const T& b) const {
    using std::exp, std::log1p;
    const LogRising<T> rising_a(a - 1.0), rising_b(b - 1.0), rising_both(a + b - 1.0);
    std::vector<T> left, right;
    left.reserve(sizes_.sizes.size());
    right.reserve(sizes_.sizes.size());
    T minus_log(0.0);
    for (std::size_t i = 0; i < sizes_.sizes.size(); ++i) {
      left.push_back(rising_a(sizes_.sizes[i]));
      right.push_back(rising_b(sizes_.sizes[i]));
      if (sizes_.nodes[i] != 0) minus_log += sizes_.nodes[i] * rising_both(sizes_.sizes[i] - 1);
    }
    for (std::size_t s = 0; s < counts_.size(); ++s) {
      const auto [smaller, larger, node] = sizes_.places[s];
      const T straight = left[smaller] + right[larger];
      if (smaller == larger) {
        minus_log -= counts_[s] * straight;
        continue;
      }
      const T mirrored = left[larger] + right[smaller];
      minus_log -= counts_[s] * (straight > mirrored ? straight + log1p(exp(mirrored - straight))
                                                     : mirrored + log1p(exp(straight - mirrored)));
    }
    return minus_log;
  }

 private:
  SplitSizes sizes_;
  std::vector<double> counts_;
};

}  // namespace

Family beta_multinomial_family() {
  return {.name = "beta_multinomial",
          .model = &BetaMultinomial::info(),
          .fixed = {},
          .parameters = beta_shapes(),
          .mirror = Mirror::exchanged,
          .alike = shapes_exchanged,
          .of_splits =
              [](const ObservedSplits& splits) {
                return jet_likelihood<2>(
                    beta_multinomial_family(),
                    [likelihood = BetaMultinomialLikelihood(splits)](const auto& values) {
                      return likelihood(values[0], values[1]);
                    });
              },
          .nested = uniform_shapes()};
}

}  // namespace ramify
