#include <cmath>
#include <vector>

#include "ramify/family/all_families.hpp"
#include "ramify/family/jet_likelihood.hpp"
#include "ramify/model/ramification.hpp"

namespace ramify {
namespace {

/// A node of order k has (k, k-i) below with probability T_i / (1 + T_1 + ... + T_k), T_i = a c^(i-1), and
/// two of order k-1 with 1 / (1 + T_1 + ... + T_k). A concave function of (log a, log c).
class TokunagaLikelihood {
 public:
  explicit TokunagaLikelihood(const ObservedBiOrders& observed) {
    for (std::size_t k = 1; k <= observed.largest_order(); ++k) {
      nodes_.push_back(observed.nodes(k));
      sides_ += observed.side_branches(k);
      higher_ += observed.side_branches(k) * (static_cast<double>(k) - 1);
    }
  }

  template <class T>
  T operator()(const T& a, const T& c) const {
    using std::log;
    T minus_log = -sides_ * log(a) - higher_ * log(c);
    T side = a, all(1.0);
    for (const double nodes : nodes_) {
      all += side;
      side *= c;
      minus_log += nodes * log(all);
    }
    return minus_log;
  }

 private:
  std::vector<double> nodes_;      ///< of order k at k-1
  double sides_ = 0, higher_ = 0;  ///< side branches, and the sum of their i-1
};

}  // namespace

Family tokunaga_family() {
  using Kind = SearchScale::Kind;
  return {.name = "tokunaga",
          .model = &tokunaga_info(),
          .fixed = {},
          .parameters = {{"a", {Kind::log_above, 0, 0}, 1e-3, 1e3, {1}},
                         {"c", {Kind::log_above, 0, 0}, 1e-3, 1e2, {2}}},
          .mirror = Mirror::none,
          .alike = "",
          .given = Given::order,
          .of_bi_orders = [](const ObservedBiOrders& observed) {
            return jet_likelihood<2>(tokunaga_family(),
                                     [likelihood = TokunagaLikelihood(observed)](const auto& values) {
                                       return likelihood(values[0], values[1]);
                                     });
          }};
}

Family ramification_family() {
  return {.name = "ramification",
          .model = &ramification_info(),
          .fixed = {},
          .parameters = {},
          .mirror = Mirror::none,
          .alike = "",
          .given = Given::order,
          .closed_form = "p(k,j): of the nodes of order k the share with (k,j) below"};
}

}  // namespace ramify
