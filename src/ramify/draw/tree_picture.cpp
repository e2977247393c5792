#include "ramify/draw/tree_picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "ramify/core/contract.hpp"
#include "ramify/core/error.hpp"
#include "ramify/draw/fork_outline.hpp"
#include "ramify/draw/order_pens.hpp"
#include "ramify/draw/page_vector.hpp"
#include "ramify/statistic/node_labels.hpp"
#include "ramify/tree/each_edge.hpp"

namespace ramify {
namespace {

using Style = TreeLook::Style;

constexpr Color shadow_color{0.86, 0.86, 0.84}, needle_color{0.16, 0.36, 0.22}, petal_color{0.97, 0.75, 0.82},
    fruit_color{0.78, 0.13, 0.12}, heart_color{0.95, 0.8, 0.3}, white{1, 1, 1};

Color mixed(const Color& a, const Color& b, double part) {
  Color mix{};
  for (std::size_t i = 0; i < mix.size(); ++i) mix[i] = a[i] * (1 - part) + b[i] * part;
  return mix;
}

/// Dark red near the foot of the tree, yellow where it is deepest.
Color autumn_color(double part) {
  constexpr Color dark{0.48, 0.07, 0.08}, middle{0.84, 0.33, 0.08}, light{0.97, 0.80, 0.25};
  return part < 0.5 ? mixed(dark, middle, 2 * part) : mixed(middle, light, 2 * part - 1);
}

/// The least and the largest of what it was shown.
struct Span {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();

  void add(double value, double around = 0) {
    least = std::min(least, value - around);
    most = std::max(most, value + around);
  }
  double length() const { return most - least; }
  double part(double value) const { return (value - least) / length(); }
};

/// The children of every node that are drawn as branches, in one list.
class BranchChildren {
 public:
  /// @param is_branch  is_branch(node)
  template <class IsBranch>
  BranchChildren(const Tree& tree, IsBranch is_branch) : first_(tree.node_count() + 1, 0) {
    each_edge(tree, [&](std::size_t parent, std::size_t child) { first_[parent + 1] += is_branch(child); });
    for (std::size_t node = 1; node < first_.size(); ++node) first_[node] += first_[node - 1];
    children_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    each_edge(tree, [&](std::size_t parent, std::size_t child) {
      if (is_branch(child)) children_[next[parent]++] = static_cast<std::uint32_t>(child);
    });
  }

  std::span<const std::uint32_t> of(std::size_t node) const {
    return std::span(children_).subspan(first_[node], first_[node + 1] - first_[node]);
  }

 private:
  std::vector<std::uint32_t> first_, children_;
};

class Picture {
 public:
  Picture(Drawing& drawing, const PageBox& box, const Tree& tree, const Shape& shape, const TreeLook& look)
      : drawing_(drawing),
        tree_(tree),
        shape_(shape),
        look_(look),
        orders_(look.by_order ? strahler_orders(tree) : std::vector<std::uint8_t>()),
        depths_(look.leaves && look.leaves->is_autumn ? depths(tree) : std::vector<std::uint32_t>()),
        pens_(orders_.empty() ? 0 : orders_[0], 1),
        children_(tree, [this](std::size_t node) { return is_branch(node); }),
        end_radii_(end_radii()) {
    double top = 0;
    for (const Limb& limb : shape.limbs) top = std::max(top, limb.end[1]);
    lamp_ = {-2 * top, 3 * top, 1.2 * top};
    fit(box);
    for (const std::uint32_t depth : depths_) deepest_ = std::max(deepest_, static_cast<double>(depth));
  }

  void add(const Cancellation& cancellation) {
    if (look_.has_shadow) add_shadow();
    if (look_.style == Style::lines) return add_lines();
    constexpr std::size_t often = 4096;
    std::size_t done = 0;
    for (const Item& item : in_painters_order()) {
      if (done++ % often == 0 && cancellation.requested()) throw Interrupted();
      if (is_branch(item.node))
        add_branch(item.node);
      else
        add_leaf_of(item.node);
    }
    if (look_.has_needles) add_needles();
  }

 private:
  struct Item {
    float nearness;
    std::uint32_t node;
  };

  bool is_branch(std::size_t node) const { return look_.tips_are_branches || tree_.arity(node) > 0; }

  /// Radii at the ends: that of the widest child where branches taper, of a tip its own.
  std::vector<float> end_radii() const {
    std::vector<float> radii(tree_.node_count(), 0);
    each_edge(tree_, [&](std::size_t parent, std::size_t child) {
      radii[parent] = std::max(radii[parent], static_cast<float>(shape_.limbs[child].radius));
    });
    for (std::size_t node = 0; node < radii.size(); ++node) {
      const auto own = static_cast<float>(shape_.limbs[node].radius);
      radii[node] = look_.tapers && tree_.arity(node) > 0 ? std::min(radii[node], own) : own;
    }
    return radii;
  }

  /// The form's own box, and the scale and place that put it into that of the page.
  void fit(const PageBox& box) {
    Span across, upward;
    for (std::size_t node = 0; node < tree_.node_count(); ++node) {
      if (!is_branch(node)) continue;
      const double around = look_.style == Style::lines ? 0 : shape_.limbs[node].radius;
      each_place(node, [&](const Point3& point) {
        across.add(look_.view.across(point), around);
        upward.add(look_.view.upward(point), around);
        nearness_.add(look_.view.nearness(point));
        if (!look_.has_shadow) return;
        across.add(look_.view.across(on_ground(point)), around);
        upward.add(look_.view.upward(on_ground(point)), around);
      });
    }
    if (nearness_.length() < 0)  // nothing but a leaf
      for (Span* span : {&across, &upward, &nearness_}) span->add(0);
    // A form in a plane has nearnesses that differ by rounding alone.
    constexpr double rounding = 1e-9;
    is_flat_ = nearness_.length() < rounding * std::max(across.length(), upward.length());
    leaf_length_ = look_.leaves ? look_.leaves->length * std::max(box.width, box.height) : 0;
    const double room_x = box.width - 2 * leaf_length_, room_y = box.height - 2 * leaf_length_;
    scale_ = std::min(room_x / std::max(across.length(), 1e-300), room_y / std::max(upward.length(), 1e-300));
    origin_.x = box.left + box.width / 2 - scale_ * (across.least + across.most) / 2;
    origin_.y = box.top + box.height / 2 + scale_ * (upward.least + upward.most) / 2;
  }

  PagePoint place(const Point3& point) const {
    return {origin_.x + scale_ * look_.view.across(point), origin_.y - scale_ * look_.view.upward(point)};
  }

  /// Of a branch: its ends, and where it bends between them.
  template <class Visit>
  void each_place(std::size_t node, Visit visit) const {
    visit(shape_.limbs[node].start);
    for (const Point3& bend : shape_.bends_of(node)) visit(bend);
    visit(shape_.limbs[node].end);
  }

  /// The same on the page, until the next is asked for.
  std::span<const PagePoint> line_of(std::size_t node) {
    line_.clear();
    each_place(node, [&](const Point3& point) { line_.push_back(place(point)); });
    return line_;
  }

  PageLimb on_page(std::size_t node) const {
    const Limb& limb = shape_.limbs[node];
    return {place(limb.start), place(limb.end), scale_ * limb.radius,
            scale_ * static_cast<double>(end_radii_[node])};
  }

  double nearness(std::size_t node) const {
    const Limb& limb = shape_.limbs[node];
    return (look_.view.nearness(limb.start) + look_.view.nearness(limb.end)) / 2;
  }

  /// Paler the farther.
  Color shaded(const Color& own, std::size_t node) const {
    return is_flat_ ? own : mixed(own, white, look_.shade * (1 - nearness_.part(nearness(node))));
  }

  Color color(std::size_t node) const {
    return shaded(look_.by_order ? pens_.color(orders_[node]) : look_.bark, node);
  }

  /// What is as near as another stays in preorder: children over their mothers.
  std::vector<Item> in_painters_order() const {
    std::vector<Item> items;
    for (std::size_t node = 0; node < tree_.node_count(); ++node)
      if (is_branch(node) || look_.leaves)
        items.push_back({static_cast<float>(nearness(node)), static_cast<std::uint32_t>(node)});
    if (!is_flat_) std::ranges::stable_sort(items, {}, &Item::nearness);
    return items;
  }

  void add_lines() {
    const std::size_t pens = look_.by_order ? orders_[0] + std::size_t{1} : 1;
    const std::size_t first = drawing_.strokes.size();
    for (std::size_t pen = 0; pen < pens; ++pen)
      drawing_.strokes.push_back({look_.by_order ? pens_.color(pen) : look_.bark, look_.line_width, {}});
    for (std::size_t node = 0; node < tree_.node_count(); ++node) {
      if (!is_branch(node)) continue;
      auto& lines = drawing_.strokes[first + (look_.by_order ? orders_[node] : 0)].lines;
      const auto line = line_of(node);
      for (std::size_t i = 1; i < line.size(); ++i) lines.push_back({line[i - 1], line[i]});
    }
  }

  void add_branch(std::size_t node) {
    const PageLimb limb = on_page(node);
    if (!shape_.bends.empty()) return add_walk(node, limb);
    if (look_.style == Style::bars && !look_.fills_notches)
      return add_bar(drawing_.patches, color(node), limb);
    buds_.clear();
    for (const std::uint32_t child : children_.of(node)) buds_.push_back(on_page(child));
    const PagePoint h = limb.end - limb.start, left = to_the_left(h);
    const auto turn = [&](const PageLimb& bud) {
      const PagePoint way = bud.end - bud.start;
      return -std::atan2(dot(way, left), dot(way, h));
    };
    std::ranges::sort(buds_, {}, turn);
    if (look_.style == Style::bars) return add_notched_bar(drawing_.patches, color(node), limb, buds_);
    add_fork(drawing_.patches, color(node), limb, node == 0 ? limb.start : own_start(limb), buds_);
    if (has_flower(node)) add_flower(limb.end);
  }

  /// A walk turns too often for smooth forks: it is a ribbon that begins with a round joint.
  void add_walk(std::size_t node, const PageLimb& limb) {
    if (node != 0) add_disc(drawing_.patches, color(node), limb.start, limb.start_radius);
    add_ribbon(drawing_.patches, color(node), line_of(node), limb.start_radius, limb.end_radius);
  }

  /// Blossoms and fruit stand where a branch ends in two leaves and nothing else.
  bool has_flower(std::size_t node) const {
    return (look_.has_blossoms || look_.has_fruit) && tree_.arity(node) == 2 && children_.of(node).empty();
  }

  void add_flower(PagePoint place) {
    const double size = 0.45 * leaf_length_;
    if (look_.has_fruit) return add_disc(drawing_.patches, fruit_color, {place.x, place.y + size}, size);
    for (int petal = 0; petal < 5; ++petal) {
      const double angle = 2 * std::numbers::pi * petal / 5;
      const PagePoint from_heart{0.6 * size * std::sin(angle), -0.6 * size * std::cos(angle)};
      add_disc(drawing_.patches, petal_color, place + from_heart, 0.55 * size);
    }
    add_disc(drawing_.patches, heart_color, place, 0.3 * size);
  }

  /// A leaf begins where its mother ends; it is shorter the more it points at who looks.
  void add_leaf_of(std::size_t node) {
    if (node == 0 || has_flower_beside(node)) return;
    const Limb& limb = shape_.limbs[node];
    const PagePoint foot = place(limb.start), way = place(limb.end) - foot;
    const double whole = scale_ * std::sqrt(std::pow(limb.end[0] - limb.start[0], 2) +
                                            std::pow(limb.end[1] - limb.start[1], 2) +
                                            std::pow(limb.end[2] - limb.start[2], 2));
    const double seen = length(way);
    if (whole <= 0 || seen <= 1e-9 * whole) return;
    constexpr double least_seen = 0.35;
    const PagePoint blade = way * (leaf_length_ * std::max(seen / whole, least_seen) / seen);
    const LeafLook& look = *look_.leaves;
    const Color own = look.is_autumn ? autumn_color(depths_[node] / deepest_) : look.color;
    add_leaf(drawing_.patches, look.form, shaded(own, node), foot, blade);
  }

  /// The external nodes of a fork are the node before and after it, or the two after: both have no mother but
  /// one whose children are both external.
  bool has_flower_beside(std::size_t node) const {
    if (!look_.has_blossoms && !look_.has_fruit) return false;
    const auto is_cherry = [&](std::size_t mother) {
      return tree_.arity(mother) == 2 && !is_branch(mother + 1) && mother + 2 < tree_.node_count() &&
             !is_branch(mother + 2);
    };
    return is_cherry(node - 1) || (node >= 2 && is_cherry(node - 2));
  }

  /// Short lines on both sides of every branch, tilted forwards.
  void add_needles() {
    Stroke needles{needle_color, std::max(0.3, 0.06 * needle_length()), {}};
    for (std::size_t node = 0; node < tree_.node_count(); ++node) {
      if (!is_branch(node)) continue;
      const auto line = line_of(node);
      for (std::size_t i = 1; i < line.size(); ++i) add_needles_between(line[i - 1], line[i], needles.lines);
    }
    drawing_.strokes.push_back(std::move(needles));
  }

  void add_needles_between(PagePoint from, PagePoint to, std::vector<Stroke::Line>& lines) const {
    const PagePoint way = to - from;
    const double far = length(way);
    if (far < 1e-9) return;
    const PagePoint h = way * (1 / far), left = to_the_left(h);
    const auto pairs = static_cast<int>(std::ceil(far / (0.25 * needle_length())));
    for (int pair = 0; pair < pairs; ++pair) {
      const PagePoint at = from + way * ((pair + 0.5) / pairs);
      for (const double side : {-1.0, 1.0})
        lines.push_back({at, at + (left * (side * 0.8) + h * 0.6) * needle_length()});
    }
  }

  double needle_length() const { return look_.leaves ? leaf_length_ : 5; }

  /// The shadow of a point on the ground, of a lamp at E: E + (P - E) E_y/(E_y - P_y).
  Point3 on_ground(const Point3& point) const {
    const double part = lamp_[1] / (lamp_[1] - std::max(point[1], 0.0));
    Point3 shadow{};
    for (std::size_t i = 0; i < 3; ++i) shadow[i] = lamp_[i] + (point[i] - lamp_[i]) * part;
    shadow[1] = 0;
    return shadow;
  }

  void add_shadow() {
    for (std::size_t node = 0; node < tree_.node_count(); ++node) {
      if (!is_branch(node)) continue;
      const PageLimb limb = on_page(node);
      line_.clear();
      each_place(node, [&](const Point3& point) { line_.push_back(place(on_ground(point))); });
      add_ribbon(drawing_.patches, shadow_color, line_, limb.start_radius, limb.end_radius);
    }
  }

  Drawing& drawing_;
  const Tree& tree_;
  const Shape& shape_;
  const TreeLook& look_;
  std::vector<std::uint8_t> orders_;
  std::vector<std::uint32_t> depths_;
  OrderPens pens_;
  BranchChildren children_;
  std::vector<float> end_radii_;
  Span nearness_;
  bool is_flat_ = false;
  Point3 lamp_{};  // over the left, in front
  PagePoint origin_{};
  double scale_ = 1, leaf_length_ = 0, deepest_ = 1;
  std::vector<PageLimb> buds_;
  std::vector<PagePoint> line_;
};

}  // namespace

void add_tree(Drawing& drawing, const PageBox& box, const Tree& tree, const Shape& shape,
              const TreeLook& look, const Cancellation& cancellation) {
  RAMIFY_EXPECTS(tree.node_count() > 0 && tree.node_count() == shape.limbs.size());
  Picture(drawing, box, tree, shape, look).add(cancellation);
}

}  // namespace ramify
