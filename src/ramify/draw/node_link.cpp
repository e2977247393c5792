#include "ramify/draw/node_link.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/core/nearest_name.hpp"
#include "ramify/core/utf8.hpp"
#include "ramify/draw/label_text.hpp"
#include "ramify/draw/order_pens.hpp"
#include "ramify/draw/tree_layout.hpp"
#include "ramify/statistic/node_labels.hpp"
#include "ramify/tree/each_edge.hpp"

namespace ramify {
namespace {

using Form = NodeLinkStyle::Form;

constexpr double margin = 20, head = 64;  // of the page; room for the title and the key
constexpr double row = 14, name_size = 10, title_size = 16, key_size = 11;
constexpr double extent_along = 720, most_across = 900, least_across = 120;
constexpr double letter = 0.6;  // width of a letter as part of the font's size, on average and rounded up

/// The lengths to draw by; empty where every branch is as long as another.
std::vector<double> lengths_of(const RecordedTree& tree, bool same_lengths) {
  if (same_lengths || tree.lengths.empty()) return {};
  std::vector<double> lengths = tree.lengths;
  if (std::isnan(lengths[0])) lengths[0] = 0;
  for (std::size_t node = 0; node < lengths.size(); ++node) {
    if (std::isfinite(lengths[node]) && lengths[node] >= 0) continue;
    const std::string name(tree.names[node]);
    throw Error(fmt::format("{}: node {}{} has the length {}", tree.name, node + 1,
                            name.empty() ? "" : " (" + name + ")", lengths[node]),
                "a branch is drawn to scale, or none is", "add --same-lengths");
  }
  const bool has_length = std::ranges::any_of(lengths, [](double length) { return length > 0; });
  return has_length ? lengths : std::vector<double>();
}

/// 1, 2 or 5 times a power of ten, at most a quarter of the length of the tree.
double bar_length(double length) {
  const double most = length / 4, power = std::pow(10, std::floor(std::log10(most)));
  return most >= 5 * power ? 5 * power : most >= 2 * power ? 2 * power : power;
}

class Diagram {
 public:
  Diagram(const RecordedTree& tree, const NodeLinkStyle& style)
      : tree_(tree),
        style_(style),
        lengths_(lengths_of(tree, style.same_lengths)),
        layout_(lay_out(tree.tree, lengths_)),
        orders_(strahler_orders(tree.tree)),
        tips_(layout_.width + 1),
        pens_(orders_[0], std::clamp(300 / tips_, 0.3, 1.2)) {
    if (!std::isfinite(layout_.length))
      throw Error(fmt::format("{}: the lengths from root to tip", tree.name),
                  "their sum is no number any more", "add --same-lengths");
    if (style.number && tips_ > most_named_tips)
      throw Error(fmt::format("--label on {:.0f} tips", tips_),
                  fmt::format("numbers are legible on {} at most", most_named_tips), "leave --label out");
    const bool is_named = tips_ <= most_named_tips && !tree.names.empty();
    for (std::size_t node = 0; is_named && node < tree.tree.node_count(); ++node)
      if (is_tip(node))
        longest_name_ = std::max(longest_name_, character_count(label_text(tree.names[node])));
    const double least = style.form == Form::upright ? extent_along : least_across;
    across_ = std::clamp(tips_ * row, least, is_named ? most_named_tips * row : most_across);
  }

  Drawing drawing() {
    const double names = longest_name_ > 0 ? static_cast<double>(longest_name_) * name_size * letter + 8 : 0;
    const double bar = lengths_.empty() ? 0 : 30;
    const double along = extent_along + names;
    const double width = style_.form == Form::upright ? across_ : along;
    const double height = style_.form == Form::upright ? along : across_;
    top_ = margin + head + (style_.form == Form::upright ? names : 0);
    page_ = {std::max(width, extent_along) + 2 * margin, height + 2 * margin + head + bar, {}, {}};
    add_branches();
    add_names();
    if (style_.number) add_numbers();
    add_head();
    if (!lengths_.empty()) add_bar();
    return std::move(page_);
  }

 private:
  bool is_tip(std::size_t node) const { return tree_.tree.arity(node) == 0; }

  /// From a tip to its name: past its number where it has one.
  double name_gap() const { return style_.number ? 12 : 5; }

  double scale_along() const { return layout_.length > 0 ? extent_along / layout_.length : 0; }

  /// From the units of the tree to those of the page.
  PagePoint place(double along, double across) const {
    const double a = along * scale_along();
    const double b = (across + 0.5) * across_ / tips_;
    if (style_.form == Form::upright) return {margin + b, top_ + extent_along - a};
    return {margin + a, top_ + b};
  }

  void add_line(std::size_t order, PagePoint from, PagePoint to) {
    page_.strokes[order].lines.push_back({from, to});
  }

  /// The stroke of every order in its place: higher orders lie over lower ones.
  void add_branches() {
    for (std::size_t order = 0; order <= orders_[0]; ++order)
      page_.strokes.push_back({pens_.color(order), pens_.width(order), {}});
    const auto& [along, across, length, width] = layout_;
    add_line(orders_[0], place(0, across[0]), place(along[0], across[0]));
    each_edge(tree_.tree, [&](std::size_t parent, std::size_t child) {
      const PagePoint from = place(along[parent], across[parent]), to = place(along[child], across[child]);
      if (style_.form == Form::upright) return add_line(orders_[child], from, to);
      const PagePoint corner = place(along[parent], across[child]);
      add_line(orders_[child], from, corner);
      add_line(orders_[child], corner, to);
    });
  }

  void add_names() {
    if (longest_name_ == 0) return;
    for (std::size_t node = 0; node < tree_.tree.node_count(); ++node) {
      if (!is_tip(node) || tree_.names[node].empty()) continue;
      PagePoint at = place(layout_.along[node], layout_.across[node]);
      (style_.form == Form::upright ? at.y : at.x) += style_.form == Form::upright ? -name_gap() : name_gap();
      page_.labels.push_back(
          {at, label_text(tree_.names[node]), name_size, Label::Anchor::start, style_.form == Form::upright});
    }
  }

  /// Each on a white disc, which is a line without length: strokes have round ends.
  void add_numbers() {
    constexpr double disc = 15;
    Stroke discs{{1, 1, 1}, disc, {}};
    const auto numbers = node_numbers(tree_.tree, *style_.number, style_.leaf_order);
    for (std::size_t node = 0; node < numbers.size(); ++node) {
      const PagePoint at = place(layout_.along[node], layout_.across[node]);
      discs.lines.push_back({at, at});
      page_.labels.push_back({at, fmt::format("{}", numbers[node]), name_size, Label::Anchor::middle});
    }
    page_.strokes.push_back(std::move(discs));
  }

  void add_head() {
    page_.labels.push_back({{margin, margin + 8}, label_text(tree_.name, 80), title_size});
    const std::string key = fmt::format("Horton-Strahler order, leaf order {}", style_.leaf_order);
    page_.labels.push_back({{margin, margin + 34}, key, key_size});
    double x = margin + static_cast<double>(key.size()) * key_size * letter;
    for (std::size_t order = 0; order <= orders_[0]; ++order, x += 48) {
      page_.strokes.push_back({pens_.color(order),
                               std::max(1.5, pens_.width(order)),
                               {{{x, margin + 34}, {x + 14, margin + 34}}}});
      page_.labels.push_back({{x + 23, margin + 34}, fmt::format("{}", order + style_.leaf_order), key_size});
    }
    page_.width = std::max(page_.width, x + margin);
  }

  void add_bar() {
    const double length = bar_length(layout_.length), y = page_.height - margin - 8;
    const double end = margin + length * scale_along();
    page_.strokes.push_back({{0.2, 0.2, 0.2}, 1.5, {{{margin, y}, {end, y}}}});
    page_.labels.push_back({{end + 8, y}, fmt::format("{:g} in the unit of the file", length), key_size});
  }

  const RecordedTree& tree_;
  const NodeLinkStyle& style_;
  std::vector<double> lengths_;
  TreeLayout layout_;
  std::vector<std::uint8_t> orders_;
  double tips_;
  OrderPens pens_;
  std::size_t longest_name_ = 0;
  double across_ = 0, top_ = 0;
  Drawing page_{};
};

}  // namespace

Form parse_form(const std::string& name) {
  if (name == "dendrogram") return Form::dendrogram;
  if (name == "upright") return Form::upright;
  throw Error(fmt::format("--style {}", name), "no such style",
              did_you_mean(name, {"dendrogram", "upright"}) + "take dendrogram or upright");
}

bool has_drawable_lengths(const RecordedTree& tree) {
  double sum = 0;
  for (std::size_t node = 0; node < tree.lengths.size(); ++node) {
    const double length = tree.lengths[node];
    if (node == 0 && std::isnan(length)) continue;
    if (!(length >= 0)) return false;
    sum += length;
  }
  return !tree.lengths.empty() && std::isfinite(sum);
}

Drawing node_link_diagram(const RecordedTree& tree, const NodeLinkStyle& style) {
  return Diagram(tree, style).drawing();
}

}  // namespace ramify
