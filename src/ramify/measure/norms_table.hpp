#pragma once

#include <vector>

#include "ramify/io/table.hpp"
#include "ramify/measure/tree_measurement.hpp"

namespace ramify {

/// A row for every tree and every statistic of one column whose exact moments are known: what the value is
/// worth beside Yule trees (`bst`) and uniform trees (`catalan`) of the same n.
///
///   tree,n,statistic,value
///   yule_mean,yule_deviation,yule_z        mean and standard deviation at n, (value - mean)/deviation
///   yule_normalised                        (value - mean)/m of Sackin and Colless index, m = n+1 external
///                                          nodes (Blum, Francois and Janson 2006)
///   uniform_mean, ..., uniform_normalised  likewise; value/m^(3/2)
/// Empty where n is out of reach of the exact laws (law_limit) or the deviation is 0. Trees with other nodes
/// than of two children have no rows. Seconds where n goes into thousands.
Table norms_table(const std::vector<TreeMeasurement>& trees);

}  // namespace ramify
