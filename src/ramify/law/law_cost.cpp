#include "ramify/law/law_cost.hpp"

#include <algorithm>
#include <cmath>

#include "ramify/law/law_width.hpp"
#include "ramify/statistic/horton_strahler.hpp"

namespace ramify {
namespace {

/// The split rows of all sizes 1..n.
struct RowCost {
  double entries;      ///< in all of them
  double nanoseconds;  ///< to make an entry
  double bytes;        ///< of tables, for each size
};

RowCost dense(double n, double nanoseconds, double bytes) {
  return {n * n / 4 + n, nanoseconds, bytes};
}

/// A binomial law is above 1e-18 over 18 standard deviations, a row at most half as long as its size.
RowCost binomial(double n, double p) {
  const double longest = std::min(n / 2, 18 * std::sqrt(n * p * (1 - p)));
  return {n * (1 + 2 * longest / 3), 16, 24};
}

RowCost rows(const Bst&, double n) {
  return dense(n, 4, 24);
}
RowCost rows(const Catalan&, double n) {
  return dense(n, 4, 24);
}
RowCost rows(const Beta&, double n) {
  return dense(n, 40, 240);
}
RowCost rows(const BetaMultinomial&, double n) {
  return dense(n, 12, 24);
}
RowCost rows(const Aldous&, double n) {
  return dense(n, 12, 24);
}
RowCost rows(const Dst& law, double n) {
  return binomial(n, law.p());
}
RowCost rows(const Patricia& law, double n) {
  return binomial(n, law.p());
}
/// Between the first and the last entry of a row may be zeros: they cost as much.
RowCost rows(const TabulatedSplit&, double n) {
  return dense(n, 8, 24);
}
/// One entry a size: the call of a sum costs as much as 25.
RowCost single(double n) {
  return {n * 25, 4, 24};
}
RowCost rows(const FixedSplit&, double n) {
  return single(n);
}
RowCost rows(const Complete&, double n) {
  return single(n);
}
RowCost rows(const Chain&, double n) {
  return single(n);
}

/// What a law keeps for each size, and the time it takes for each entry of a row.
struct Use {
  double bytes;
  double nanoseconds;
};

Use use(const Model& model, LawKind kind, Size n) {
  const auto orders = static_cast<double>(HortonStrahler::largest_order(n));
  const double strahler = 3 * (orders + 3), means = strahler + 2 * (orders + 1), counts = 2 * orders;
  const double series = sizeof(double);
  // The width at half the size stands for the mean over all sizes.
  switch (kind) {
    case LawKind::bounded:
      return {strahler * series, 8};
    case LawKind::height: {
      const double width = height_width(model, n / 2);
      return {12 * width + 36, width};
    }
    case LawKind::depth: {
      const double width = depth_width(model, n / 2);
      return {8 * width + 64, width};
    }
    case LawKind::node_sum:
      return {2 * series, 8};
    case LawKind::order_means:
      return {means * series, 20};
    case LawKind::order_moments:
      break;
  }
  const double moments = counts * (2 * orders + 4) + counts * (counts + 1) / 2;
  return {(means + moments) * series, 20 + 2 * counts * counts};
}

/// 12345 -> 12000.
Size two_digits(Size n) {
  Size unit = 1;
  while (n / unit >= 100) unit *= 10;
  return n / unit * unit;
}

}  // namespace

LawCost law_cost(const Model& model, LawKind kind, Size n) {
  const auto size = static_cast<double>(n) + 1;
  const RowCost row = std::visit([size](const auto& law) { return rows(law, size); }, model.law());
  const Use law = use(model, kind, n);
  return {size * (row.bytes + law.bytes), row.entries * (row.nanoseconds + law.nanoseconds) * 1e-9};
}

Size largest_affordable(const Model& model, LawKind kind, const LawCost& limit) {
  Size low = 0, high = model.largest_size();
  while (low < high) {
    const Size middle = high - (high - low) / 2;
    const LawCost cost = law_cost(model, kind, middle);
    if (cost.bytes <= limit.bytes && cost.seconds <= limit.seconds)
      low = middle;
    else
      high = middle - 1;
  }
  return two_digits(low);
}

}  // namespace ramify
