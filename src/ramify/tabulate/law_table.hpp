#pragma once

#include "ramify/core/cancellation.hpp"
#include "ramify/io/table.hpp"
#include "ramify/tabulate/law_request.hpp"

namespace ramify {

/// The exact law of a statistic at the sizes asked for: what `ramify law` prints.
///
///   law              model,n,statistic,value,probability; values with probability > 0 only
///   moments          model,n,statistic,mean,variance
///   nodes, streams: moments  of every order, statistics nodes_0, ...
///   orders: law      model,n,leaf_order,order,mean_nodes,mean_streams; orders 0..K, K = floor(log2(n+1))
///           moments  as above, statistics nodes_0..nodes_K, streams_0..streams_K
///           covariances  model,n,leaf_order,first,second,covariance; every two of them, also of one with
///                    itself
/// Numbers are printed so that they read back as the same doubles. Probabilities are right to 1e-15, those of
/// heights and orders also to a relative 1e-12 from 1e-20 up, means of counts to a relative 1e-13 from there
/// up, covariances to 1e-13 n. Sizes come in the order of the request; the law is built once, up to the
/// largest. Cost: law_cost. Throws Interrupted when cancelled.
Table law_table(const LawRequest& request, const Cancellation& cancellation);

}  // namespace ramify
