#include "ramify/law/depth_law.hpp"

#include <algorithm>

#include "ramify/core/contract.hpp"
#include "ramify/law/trim.hpp"

namespace ramify {
namespace {

constexpr double not_stored = 1e-20;

}  // namespace

void DepthLaw::extend(const SplitRow& row) {
  RAMIFY_EXPECTS(row.n == sizes());
  Size first = row.n + 1, end = 0;
  const auto each_child = [this, &row](auto visit) {
    const auto total = static_cast<double>(row.n - 1 + 2 * weight_of_none_);
    for (std::size_t m = 0; m < row.weights.size(); ++m)
      for (const Size child : {row.smaller(m), row.larger(m)}) {
        const double share = row.n == 1 ? 0.5 : static_cast<double>(child + weight_of_none_) / total;
        if (share > 0) visit(child, row.weights[m] * share);
      }
  };
  each_child([&](Size child, double) {
    first = std::min(first, laws_[child].first + 1);
    end = std::max(end, laws_[child].first + laws_[child].probabilities.size() + 1);
  });
  std::vector<double> sums(end - first, 0.0);
  each_child([&](Size child, double weight) {
    const Law& law = laws_[child];
    double* out = sums.data() + (law.first + 1 - first);
    for (std::size_t d = 0; d < law.probabilities.size(); ++d) out[d] += weight * law.probabilities[d];
  });
  const auto kept = trim_to_law(sums, not_stored);
  laws_.push_back({first + static_cast<Size>(kept.data() - sums.data()), {kept.begin(), kept.end()}});
}

}  // namespace ramify
