#include "ramify/sample/measure_tree.hpp"

#include "ramify/sample/folds.hpp"
#include "ramify/tree/measure.hpp"

namespace ramify {

namespace {

template <class F>
TreeMeasures measure_by(F fold, const Tree& tree) {
  TreeMeasures measures;
  record(fold, measure(tree, fold), measures);
  return measures;
}

}  // namespace

TreeMeasures measure_tree(const Tree& tree, StreamKey key, std::uint64_t replicate) {
  return measure_by(make_fold<MeasuredFold>(key, replicate), tree);
}

TreeMeasures measure_orders_and_height(const Tree& tree) {
  return measure_by(LeanFold(), tree);
}

}  // namespace ramify
