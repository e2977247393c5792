#include "ramify/gallery/form_table.hpp"

#include <utility>
#include <vector>

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/core/nearest_name.hpp"
#include "ramify/gallery/preset_drawing.hpp"
#include "ramify/shape/shape_measures.hpp"
#include "ramify/statistic/stream_geometry.hpp"

namespace ramify {
namespace {

const std::vector<std::string> tree_columns{"panel", "model", "n", "seed", "replicate"};

std::vector<std::string> columns_of(FormTable kind) {
  std::vector<std::string> columns = tree_columns;
  const std::vector<std::string> own =
      kind == FormTable::summary
          ? std::vector<std::string>{"volume",
                                     "surface",
                                     "height",
                                     "spread",
                                     "length",
                                     "radius_ratio",
                                     "stream_length_ratio"}
          : std::vector<std::string>{"leaf_order",  "order",       "cylinders",         "streams",
                                     "mean_radius", "mean_length", "mean_stream_length"};
  columns.insert(columns.end(), own.begin(), own.end());
  return columns;
}

Row row_of_panel(const PicturePanel& panel, std::size_t number) {
  Row row;
  row.whole(number).text(panel.model.text()).whole(panel.n).whole(panel.seed).whole(panel.replicate);
  return row;
}

Row with_summary(Row row, const ShapeMeasures& measures) {
  std::vector<double> radii, lengths;
  for (const OrderExtents& order : measures.orders) {
    radii.push_back(order.mean_radius);
    lengths.push_back(order.mean_stream_length);
  }
  row.summary(measures.volume).summary(measures.surface).summary(measures.height);
  row.summary(measures.spread).summary(measures.length);
  row.summary(mean_ratios(radii).regression).summary(mean_ratios(lengths).regression);
  return row;
}

Row with_order(Row row, const OrderExtents& order) {
  row.whole(1).whole(order.order).whole(static_cast<std::uint64_t>(order.cylinders));
  row.whole(static_cast<std::uint64_t>(order.streams));
  row.summary(order.mean_radius).summary(order.mean_length).summary(order.mean_stream_length);
  return row;
}

}  // namespace

FormTable parse_form_table(const std::string& name) {
  if (name == "summary") return FormTable::summary;
  if (name == "orders") return FormTable::orders;
  throw Error(fmt::format("--table {}", name), "there is no such table of forms",
              did_you_mean(name, {"summary", "orders"}) + "take summary or orders");
}

Table form_table(const PicturePreset& preset, FormTable kind, const Cancellation& cancellation) {
  Table table(columns_of(kind));
  for (std::size_t i = 0; i < preset.panels.size(); ++i) {
    const PicturePanel& panel = preset.panels[i];
    const RecordedTree tree = panel_tree(panel, cancellation);
    const ShapeMeasures measures = measure_shape(tree.tree, panel_shape(panel, tree.tree, cancellation));
    if (kind == FormTable::summary) {
      table.add(with_summary(row_of_panel(panel, i + 1), measures));
      continue;
    }
    for (const OrderExtents& order : measures.orders)
      table.add(with_order(row_of_panel(panel, i + 1), order));
  }
  return table;
}

}  // namespace ramify
