#pragma once

#include <span>
#include <string>

#include "ramify/fit/model_fits.hpp"
#include "ramify/io/table.hpp"

namespace ramify {

/// One row for each parameter of each fit, one for a family without: data,model,parameter,estimate,
/// standard_error,lower,upper, then the fit they are of: observable,n,rank,log_likelihood,aic,bic,delta_aic,
/// misfit,misfit_p,bootstrap_trees,bootstrap_lower,bootstrap_upper,bootstrap_bias,status,note
/// (docs/fitting-models.md).
Table model_fit_table(std::span<const FittedDatum> data);

/// The same for reading: aligned, the families of each datum from the best to the worst, notes below.
std::string model_fit_text(std::span<const FittedDatum> data);

/// True where a fit did not converge: exit code 3.
bool any_not_converged(std::span<const FittedDatum> data);

}  // namespace ramify
