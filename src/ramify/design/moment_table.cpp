#include "ramify/design/moment_table.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/core/number.hpp"
#include "ramify/design/design_row.hpp"
#include "ramify/model/parameter.hpp"
#include "ramify/theory/split_mean.hpp"
#include "ramify/theory/split_variance.hpp"

namespace ramify {

BetaSplit split_of_moments(double mean, double variance) {
  if (!Domain{0, 1}.contains(mean))
    throw Error(fmt::format("--mean {}", mean), "the mean of a fraction lies between 0 and 1",
                "take one between them");
  const double most = mean * (1 - mean);
  const std::string problem = fmt::format("--mean {} --variance {}", mean, variance);
  if (!(variance > 0))
    throw Error(problem, "a split that varies has a variance above 0",
                fmt::format("take a larger one; split({}) has none", mean));
  if (!(variance < most))
    throw Error(problem,
                fmt::format("a fraction of this mean has a variance below m (1-m) = {}",
                            format_significant(most, 10)),
                "take a smaller one");
  const double sum = (most - variance) / variance;
  const BetaSplit split{to_design_digits(mean * sum), to_design_digits((1 - mean) * sum)};
  constexpr Parameter shape = beta_shape("a");
  if (!shape.accepts(split.a) || !shape.accepts(split.b))
    throw Error(problem, fmt::format("{} has it, and a and b lie from 1e-9 to 1e9", beta_text(split)),
                std::max(split.a, split.b) > shape.domain.high ? "take a larger variance"
                                                               : "take a smaller variance");
  return split;
}

Table moment_table(double mean, double variance) {
  const Model model = Model::parse(beta_text(split_of_moments(mean, variance)));
  const auto split = *BetaSplit::of(model);
  Table table({"model", "a", "b", "mean", "variance", "depth", "height"});
  table.add(Row()
                .text(model.text())
                .exact(split.a)
                .exact(split.b)
                .exact(split_mean(model)->value)
                .exact(split_variance(model)->value)
                .exact(depth_of(model))
                .exact(height_of(model)));
  return table;
}

}  // namespace ramify
