#pragma once

#include <span>
#include <string>

#include "ramify/fit/model_fits.hpp"
#include "ramify/io/table.hpp"

namespace ramify {

/// One row for each parameter of each fit, one for a family without: data,model,parameter,estimate,
/// standard_error,lower,upper, then the fit they are of:
/// observable,given,n,rank,log_likelihood,aic,bic,delta_aic,
/// misfit,misfit_p,bootstrap_trees,bootstrap_lower,bootstrap_upper,bootstrap_bias,status,note
/// (docs/fitting-models.md).
Table model_fit_table(std::span<const FittedDatum> data);

/// The fits of one datum for reading, the best first: model, parameter, estimate with its error, 95 %
/// interval, AIC less that of the best, P of a larger misfit, status.
Table model_fit_lines(const FittedDatum& datum);

/// An estimate with the decimals that its error has: "0.230 +- 0.009".
std::string estimate_text(const FittedParameter& parameter);
/// "0.213 .. 0.248", "open 0 .. 0.1"; empty where there is none.
std::string interval_text(const FittedParameter& parameter);

/// The same for reading: aligned, the families of each datum from the best to the worst, notes below.
std::string model_fit_text(std::span<const FittedDatum> data);

/// True where a fit did not converge: exit code 3.
bool any_not_converged(std::span<const FittedDatum> data);

}  // namespace ramify
