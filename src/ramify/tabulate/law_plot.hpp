#pragma once

#include "ramify/io/table.hpp"
#include "ramify/report/plot.hpp"
#include "ramify/tabulate/law_request.hpp"

namespace ramify {

/// Throws Error where the request has no picture: of moments and covariances, and of more than
/// most_drawn_sizes.
void require_drawable(const LawRequest& request);

inline constexpr std::size_t most_drawn_sizes = 8;

/// The picture of a law table that is drawable: probability against value, bars for one size, a curve for
/// each of several; of orders, mean numbers of nodes and streams against the order on a logarithmic axis.
/// What is too small to be seen is left out, and the picture says so.
Plot law_plot(const LawRequest& request, const Table& law);

}  // namespace ramify
