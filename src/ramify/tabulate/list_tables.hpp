#pragma once

#include "ramify/io/table.hpp"

namespace ramify {

// What `ramify list` prints.

/// name,n_counts,domain,description,sampled,source of every model.
Table model_table();

/// name,columns,convention,description,known,sampled,source of every statistic; what is known and how it is
/// sampled are those of split models.
Table statistic_table();

/// What is known of every statistic for every model, and how it is sampled; models of which all is the same
/// share a column.
Table coverage_table();

/// name,parameters,searched,observed,alike of every family of models that `ramify fit` fits.
Table family_table();

/// name,model,n,description,source of every preset.
Table preset_table();

}  // namespace ramify
