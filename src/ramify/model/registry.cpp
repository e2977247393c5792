#include "ramify/model/registry.hpp"

#include <type_traits>

#include "ramify/core/find_named.hpp"
#include "ramify/model/branching.hpp"
#include "ramify/model/flow_rate.hpp"
#include "ramify/model/galton_watson.hpp"
#include "ramify/model/kary.hpp"
#include "ramify/model/node_dependent.hpp"
#include "ramify/model/ramification.hpp"
#include "ramify/model/ternary.hpp"
#include "ramify/model/trie.hpp"
#include "ramify/random/stream.hpp"

namespace ramify {
namespace {

using Infos = std::vector<std::reference_wrapper<const ModelInfo>>;

template <class... Laws>
  requires(SplitLaw<Laws, Stream> && ...)
Infos infos_of(std::type_identity<std::variant<Laws...>>) {
  return {Laws::info()...};
}

Infos all_models() {
  Infos all = infos_of(std::type_identity<AnySplitLaw>());
  const Infos grown{Trie::info(),    Ternary::info(),     NodeBeta::info(),  NodeSplit::info(),
                    NodeDst::info(), NodeTernary::info(), Branching::info(), GaltonWatson::info(),
                    tokunaga_info(), ramification_info(), hybrid_info(),     markov_info(),
                    Kary::info(),    FlowRate::info()};
  all.insert(all.end(), grown.begin(), grown.end());
  return all;
}

}  // namespace

const std::vector<std::reference_wrapper<const ModelInfo>>& models() {
  static const Infos all = all_models();
  return all;
}

const ModelInfo& find_model(std::string_view name) {
  return find_named(models(), &ModelInfo::name, name, "model");
}

}  // namespace ramify
