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

TreeMeasures measure_tree(const Tree& tree, StreamKey key, std::uint64_t replicate, FoldSet folds) {
  if (orders_and_height.contains(folds)) return measure_by(OrdersAndHeight(), tree);
  return folds.contains(Folded::indices) ? measure_by(make_fold<MeasuredIndexedFold>(key, replicate), tree)
                                         : measure_by(make_fold<MeasuredFold>(key, replicate), tree);
}

}  // namespace ramify
