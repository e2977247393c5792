#include "ramify/sample/measure_tree.hpp"

#include "ramify/sample/folds.hpp"
#include "ramify/tree/measure.hpp"

namespace ramify {

TreeMeasures measure_tree(const Tree& tree, StreamKey key, std::uint64_t replicate) {
  auto fold = make_fold<MeasuredFold>(key, replicate);
  TreeMeasures measures;
  record(fold, measure(tree, fold), measures);
  return measures;
}

}  // namespace ramify
