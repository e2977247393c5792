#include "ramify/model/labelled_tree.hpp"

#include "ramify/model/split_tree.hpp"
#include "ramify/tree/store.hpp"

namespace ramify {

LabelledTree grow_labelled(const Model& model, Size n, Stream& stream, const Cancellation& cancellation) {
  LabelledTree grown;
  if (!model.is_split()) {
    grown.meaning = model.grown().label_meaning();
    grown.tree = model.grown().grow(n, stream, cancellation, &grown.labels);
    return grown;
  }
  std::visit(
      [&]<class Law>(const Law& law) {
        grown.meaning = SplitTree<Law>::label_meaning;
        grown.tree =
            grow_tree(SplitTree<Law>(law), n, stream, [&grown](Size size) { grown.labels.push_back(size); });
      },
      model.law());
  return grown;
}

}  // namespace ramify
