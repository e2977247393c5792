#include "ramify/design/ratio_designs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/core/number.hpp"
#include "ramify/core/parallel.hpp"
#include "ramify/design/design_row.hpp"
#include "ramify/design/pooled_ratio.hpp"
#include "ramify/theory/beta_horton_ratio.hpp"
#include "ramify/theory/horton_ratio_constant.hpp"

namespace ramify {
namespace {

/// How closely models are searched: ratios are smooth in p and in a+b, and change over a decade of
/// them.
struct Search {
  std::vector<double> means;  ///< a/(a+b) of beta trees
  double least_sum, most_sum;
  std::size_t sums;           ///< values of a+b
  std::size_t probabilities;  ///< values of p, from least_p to 1/2
};

const Search of_limits{{0.5, 0.4, 0.3, 0.2, 0.1}, 0.01, 200, 9, 0};
const Search of_small_sizes{{0.5, 0.4, 0.3, 0.2, 0.1}, 0.1, 100, 7, 30};
const Search of_large_sizes{{0.5, 0.3}, 0.1, 100, 5, 10};
constexpr Size largest_small_size = 1000;

constexpr double least_p = 0.01;

std::vector<double> geometric(double low, double high, std::size_t count) {
  std::vector<double> grid;
  for (std::size_t i = 0; i < count; ++i)
    grid.push_back(low * std::pow(high / low, static_cast<double>(i) / static_cast<double>(count - 1)));
  grid.back() = high;
  return grid;
}

void require_ratio(double ratio) {
  if (ratio >= 2) return;
  throw Error(fmt::format("--ratio {}", ratio),
              "it is 2 or more: a stream of order k+1 begins where two of order k meet", "take 2 or more");
}

BetaSplit beta_of(double mean, double sum) {
  return {mean * sum, (1 - mean) * sum};
}

/// A model that was found, as its row begins; p of binary splits, a and b of beta.
struct Design {
  Model model;
  std::optional<BetaSplit> split;
  double p = std::numeric_limits<double>::quiet_NaN();

  static Design beta(double mean, double sum) {
    const BetaSplit found = beta_of(mean, sum);
    const BetaSplit split{to_design_digits(found.a), to_design_digits(found.b)};
    return {Model::parse(beta_text(split)), split};
  }
};

Row row_of(const Design& design, std::optional<Size> n, double ratio) {
  Row row;
  row.text(design.model.text());
  if (n) row.whole(*n);
  if (design.split)
    row.exact(design.split->a).exact(design.split->b);
  else
    row.nothing().nothing();
  return std::move(
      row.exact(design.p).exact(depth_of(design.model)).exact(height_of(design.model)).summary(ratio));
}

/// Models of one parameter x: the ratio that they have, where it is searched, the model of an x.
struct Candidates {
  ScannedCurve::Function ratio;
  std::vector<double> grid;
  std::function<Design(double x)> design;
};

struct Found {
  std::vector<Design> designs;
  double lowest = std::numeric_limits<double>::infinity(), highest = 0;
};

Found search(const Candidates& candidates, double ratio, const Cancellation& cancellation) {
  const ScannedCurve curve(candidates.ratio, candidates.grid, {1, &cancellation});
  Found found;
  if (curve.points().empty()) return found;
  for (const double x : curve.solutions(ratio)) found.designs.push_back(candidates.design(x));
  found.lowest = curve.lowest().y;
  found.highest = curve.highest().y;
  return found;
}

std::vector<Found> search_all(const std::vector<Candidates>& all, double ratio, const ScanEffort& effort) {
  std::vector<Found> found(all.size());
  parallel_for(all.size(), effort.threads,
               [&](std::size_t i, unsigned) { found[i] = search(all[i], ratio, *effort.cancellation); });
  return found;
}

double limiting_ratio(const BetaSplit& split) {
  const auto ratio = beta_horton_ratio(split);
  return ratio ? ratio->value : std::numeric_limits<double>::quiet_NaN();
}

std::vector<Candidates> limiting_candidates() {
  std::vector<Candidates> all;
  for (const double mean : of_limits.means)
    all.push_back({[mean](double sum) { return limiting_ratio(beta_of(mean, sum)); },
                   geometric(of_limits.least_sum, of_limits.most_sum, of_limits.sums),
                   [mean](double sum) { return Design::beta(mean, sum); }});
  return all;
}

std::string binary_text(const char* name, double p) {
  return fmt::format("{}({})", name, format_exact(p));
}

std::vector<Candidates> finite_candidates(Size n, const Cancellation& cancellation) {
  const Search& searched = n <= largest_small_size ? of_small_sizes : of_large_sizes;
  std::vector<Candidates> all;
  for (const char* name : {"patricia", "dst"})
    all.push_back({[name, n, &cancellation](double p) {
                     return expected_pooled_ratio(Model::parse(binary_text(name, p)), n, cancellation);
                   },
                   geometric(least_p, 0.5, searched.probabilities),
                   [name](double p) -> Design {
                     const double digits = to_design_digits(p);
                     return {Model::parse(binary_text(name, digits)), {}, digits};
                   }});
  for (const double mean : searched.means)
    all.push_back({[mean, n, &cancellation](double sum) {
                     return expected_pooled_ratio(Model::parse(beta_text(beta_of(mean, sum))), n,
                                                  cancellation);
                   },
                   geometric(searched.least_sum, searched.most_sum, searched.sums),
                   [mean](double sum) { return Design::beta(mean, sum); }});
  return all;
}

Error no_such_model(double ratio, Size n, const std::vector<Found>& found) {
  double lowest = std::numeric_limits<double>::infinity(), highest = 0;
  for (const Found& of_candidates : found) {
    lowest = std::min(lowest, of_candidates.lowest);
    highest = std::max(highest, of_candidates.highest);
  }
  return {fmt::format("--ratio {} --n {}", ratio, n),
          fmt::format("streams pooled over orders have a ratio from {:.4g} to {:.4g} in patricia(p), dst(p) "
                      "and beta(a,b) of this size",
                      lowest, highest),
          "take one between them, or another size"};
}

}  // namespace

Table limiting_ratio_designs(double ratio, const ScanEffort& effort) {
  require_ratio(ratio);
  Table table({"model", "a", "b", "p", "depth", "height", "horton_ratio"});
  for (const char* name : {"patricia", "split"}) {
    const Model model = Model::parse(fmt::format("{}(1/{})", name, format_exact(ratio)));
    table.add(row_of({model, {}, 1 / ratio}, {}, horton_ratio_constant(model)->value));
  }
  for (const Found& found : search_all(limiting_candidates(), ratio, effort))
    for (const Design& design : found.designs) table.add(row_of(design, {}, limiting_ratio(*design.split)));
  return table;
}

Table finite_ratio_designs(double ratio, Size n, const ScanEffort& effort) {
  require_ratio(ratio);
  if (n < 3)
    throw Error(fmt::format("--n {}", n), "trees of fewer than 3 nodes have one ratio, whatever their model",
                "take a larger one");
  const auto found = search_all(finite_candidates(n, *effort.cancellation), ratio, effort);
  Table table({"model", "n", "a", "b", "p", "depth", "height", "streams_pooled_ratio"});
  for (const Found& of_candidates : found)
    for (const Design& design : of_candidates.designs)
      table.add(row_of(design, n, expected_pooled_ratio(design.model, n, *effort.cancellation)));
  if (table.rows() == 0) throw no_such_model(ratio, n, found);
  return table;
}

}  // namespace ramify
