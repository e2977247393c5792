#pragma once

#include "ramify/model/registry.hpp"
#include "ramify/statistic/statistic_set.hpp"

namespace ramify {

/// Levels that are open at once while a tree of this model and size grows, as far as the rough growth of its
/// height tells; all nodes of a tree that is stored whole.
double open_levels(const Model& model, Size size);

/// Bytes that growing such a tree takes, on each thread: as measured with chains of 10^7 nodes and trees of
/// as many.
/// @param pass  what is folded meanwhile
double growing_bytes(const Model& model, Size n, FoldSet pass);

}  // namespace ramify
