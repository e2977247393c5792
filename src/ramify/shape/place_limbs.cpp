#include "ramify/shape/place_limbs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/random/uniform.hpp"
#include "ramify/shape/degrees.hpp"
#include "ramify/tree/each_edge.hpp"

namespace ramify {
namespace {

using Vector = Eigen::Vector3d;

Vector vector_of(const Point3& point) {
  return {point[0], point[1], point[2]};
}

Point3 point_of(const Vector& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

struct Frame {
  Vector h, e;
  Vector n() const { return h.cross(e); }
  Vector across(double side) const { return e * std::cos(side) + n() * std::sin(side); }
};

/// Turned by an angle in radians about a unit axis.
Frame turned(const Frame& frame, const Vector& axis, double angle) {
  const Eigen::AngleAxisd turn(angle, axis);
  return {turn * frame.h, turn * frame.e};
}

/// Of unit length and at right angles again: without this, rounding grows with every fork of a deep tree.
Frame straightened(const Frame& frame) {
  const Vector h = frame.h.normalized();
  return {h, (frame.e - h * h.dot(frame.e)).normalized()};
}

/// Turned towards a direction, in the plane of both.
/// @param turn  turn(h x target's length), the angle
template <class Turn>
Frame turned_towards(const Frame& frame, const Vector& target, Turn turn) {
  const Vector axis = frame.h.cross(target);
  const double sine = axis.norm();
  return sine == 0 ? frame : turned(frame, axis / sine, turn(sine));
}

/// Turned so that it heads towards a unit direction, by the least turn that does.
Frame headed(const Frame& frame, const Vector& heading) {
  return turned_towards(frame, heading, [&](double sine) { return std::atan2(sine, frame.h.dot(heading)); });
}

/// The level direction across a heading; of a vertical one (1,0,0), as the plane of Aono and Kunii's first
/// fork (X44).
Vector level_across(const Vector& h) {
  const double flat = std::hypot(h.x(), h.z());
  constexpr double vertical = 1e-12;
  return flat < vertical ? Vector(1, 0, 0) : Vector(h.z() / flat, 0, -h.x() / flat);
}

double share_of_root(const NodeFacts& node, const NodeFacts& root, double exponent) {
  return std::pow(node.nodes / root.nodes, exponent);
}

/// A heading drawn towards a target: its angle to it divided.
Frame drawn(const Frame& frame, const Vector& target, double divisor) {
  return turned_towards(frame, target, [&](double sine) {
    const double angle = std::atan2(sine, frame.h.dot(target));
    return angle - angle / divisor;
  });
}

/// Facts of every node that take a pass over the tree.
class Survey {
 public:
  Survey(const Tree& tree, MainChild main)
      : leaves_(magnitudes(tree)),
        orders_(strahler_orders(tree)),
        paths_(path_nodes(tree, main)),
        nodes_(node_counts(tree)) {}

  std::size_t nodes(std::size_t node) const { return nodes_[node]; }

  NodeFacts facts(std::size_t node, std::size_t place, bool is_main) const {
    return {static_cast<double>(nodes_[node]),
            static_cast<double>(leaves_[node]),
            orders_[node] + 1.0,
            static_cast<double>(paths_[node].main),
            static_cast<double>(paths_[node].secondary),
            is_main,
            place,
            node};
  }

  bool is_main(std::size_t node, const NodeFacts& mother) const { return paths_[node].main > mother.main; }

 private:
  std::vector<Size> leaves_;
  std::vector<std::uint8_t> orders_;
  std::vector<PathNodes> paths_;
  std::vector<Size> nodes_;
};

class Placing {
 public:
  Placing(const Tree& tree, const ShapeRules& rules, Stream& chance)
      : tree_(tree), rules_(rules), chance_(chance), survey_(tree, rules.main) {}

  Shape shape(const Cancellation& cancellation) {
    shape_.limbs.resize(tree_.node_count());
    add_root();
    constexpr std::size_t often = 4096;
    for (std::size_t done = 0; !open_.empty(); ++done) {
      if (done % often == 0 && cancellation.requested()) throw Interrupted();
      const Twig mother = open_.back();
      open_.pop_back();
      if (tree_.arity(mother.node) > 0) fork(mother);
    }
    return std::move(shape_);
  }

 private:
  struct Twig {
    std::size_t node;
    NodeFacts facts;
    Frame frame;
  };

  double extent(const ExtentRule& rule, std::string_view what, std::size_t node, const NodeFacts& facts,
                double of_mother) {
    const double value = rule({facts, root_, of_mother, chance_});
    if (std::isfinite(value) && value >= 0) return value;
    throw Error(fmt::format("the {} of node {} is {:g}", what, node + 1, value),
                "it must be a number and not negative", "change the constants of its rule");
  }

  void add_root() {
    root_ = survey_.facts(0, 0, true);
    root_.radius = extent(rules_.radius, "radius", 0, root_, 0);
    root_.length = extent(rules_.length, "length", 0, root_, 0);
    const Vector e = rules_.plane.kind == PlaneRule::Kind::gradient ? Vector(1, 0, 0) : Vector(-1, 0, 0);
    const Frame frame{{0, 1, 0}, e};
    shape_.limbs[0] = {{0, 0, 0}, point_of(frame.h * root_.length), root_.radius};
    open_.push_back({0, root_, frame});
  }

  /// Radii first, for angles depend on those of siblings; then every child in its place.
  void fork(const Twig& mother) {
    nodes_.clear();
    facts_.clear();
    std::size_t node = mother.node + 1;
    for (std::size_t place = 0; place < tree_.arity(mother.node); ++place, node += survey_.nodes(node)) {
      NodeFacts facts = survey_.facts(node, place, survey_.is_main(node, mother.facts));
      facts.radius = extent(rules_.radius, "radius", node, facts, mother.facts.radius);
      nodes_.push_back(node);
      facts_.push_back(facts);
    }
    const double turn = rules_.mirrors && (chance_() >> 63) != 0 ? std::numbers::pi : 0;
    sides_taken_ = 0;
    for (std::size_t child = 0; child < nodes_.size(); ++child) {
      const double side = turn + side_of(mother, child);
      add_child(mother, child, side, deviation(mother, child));
    }
    std::reverse(open_.end() - static_cast<std::ptrdiff_t>(nodes_.size()), open_.end());
  }

  /// The direction in which a child leaves, about the mother's axis from e.
  double side_of(const Twig& mother, std::size_t child) {
    const auto children = static_cast<double>(nodes_.size());
    if (rules_.arrangement == Arrangement::turned && !rules_.azimuths.empty())
      return radians(rules_.azimuths[child % rules_.azimuths.size()]);
    if (rules_.arrangement == Arrangement::whorl)
      return 2 * std::numbers::pi * static_cast<double>(child) / children;
    if (nodes_.size() > 2 && facts_[child].is_main) return 0;
    const bool changes_sides = rules_.arrangement == Arrangement::alternating && mother.facts.secondary > 0 &&
                               std::fmod(mother.facts.depth(), 2) == 0;
    return (sides_taken_++ % 2 == 0) == changes_sides ? std::numbers::pi : 0;
  }

  double deviation(const Twig& mother, std::size_t child) {
    double angle = rules_.deviation({mother.facts, facts_, chance_}, child);
    if (rules_.foreshortens) angle *= std::cos(2 * std::numbers::pi * uniform_open(chance_));
    if (std::isfinite(angle)) return radians(angle);
    throw Error(fmt::format("the deviation of node {} is {:g}", nodes_[child] + 1, angle),
                "it must be a number of degrees", "change the constants of its rule");
  }

  void add_child(const Twig& mother, std::size_t child, double side, double deviation) {
    NodeFacts& facts = facts_[child];
    Frame frame = turned(mother.frame, mother.frame.h.cross(mother.frame.across(side)), deviation);
    for (const Tropism& tropism : rules_.tropisms) frame = headed_by(tropism, frame, facts);
    facts.length = extent(rules_.length, "length", nodes_[child], facts, mother.facts.length);
    const Vector start = start_of(mother, frame, side, facts.radius);
    Vector end = start + frame.h * facts.length;
    Vector moved = end;
    for (const Tropism& tropism : rules_.tropisms) moved += shift_of(tropism, end, facts);
    if (moved != end) {
      facts.length = (moved - start).norm();
      if (facts.length > 0) frame = headed(frame, (moved - start) / facts.length);
    }
    frame.e = plane_of(frame, facts, rules_.arrangement == Arrangement::turned ? side : 0);
    frame = straightened(frame);
    shape_.limbs[nodes_[child]] = {point_of(start), point_of(moved), facts.radius};
    open_.push_back({nodes_[child], facts, frame});
  }

  Vector start_of(const Twig& mother, const Frame& child, double side, double radius) const {
    Vector end = vector_of(shape_.limbs[mother.node].end);
    if (rules_.joint == BranchJoint::centre) return end;
    return end + mother.frame.across(side) * mother.facts.radius - child.across(side) * radius;
  }

  Frame headed_by(const Tropism& tropism, const Frame& frame, const NodeFacts& node) const {
    const Vector target = vector_of(tropism.target);
    const double share = share_of_root(node, root_, tropism.exponent);
    switch (tropism.kind) {
      case Tropism::Kind::lean: {
        const Vector heading = frame.h + tropism.strength * target;
        return heading.norm() == 0 ? frame : headed(frame, heading.normalized());
      }
      case Tropism::Kind::torque:
        return turned_towards(frame, target, [&](double sine) { return tropism.strength * sine; });
      case Tropism::Kind::pull:
        return drawn(frame, target.normalized(), 1 + tropism.strength * share);
      case Tropism::Kind::bend:
        return drawn(frame, target.normalized(), 1 + tropism.strength * (1 - share));
      default:
        return frame;
    }
  }

  static Vector shift_of(const Tropism& tropism, const Vector& end, const NodeFacts& node) {
    Vector target = vector_of(tropism.target);
    if (tropism.kind == Tropism::Kind::shift) return target;
    const double level = node.depth() - 1;
    const Vector way = target - end;
    const bool acts = tropism.kind == Tropism::Kind::controller && level >= tropism.first_level &&
                      level <= tropism.last_level && way.norm() > 0;
    return acts ? Vector(way * (tropism.strength / way.norm())) : Vector(0, 0, 0);
  }

  /// The normal of the plane of a node's own children.
  /// @param roll  of the frame itself, before the rule
  Vector plane_of(const Frame& frame, const NodeFacts& node, double roll) {
    double angle = radians(rules_.plane.angle) + roll;
    Vector e = frame.e;
    switch (rules_.plane.kind) {
      case PlaneRule::Kind::carried:
        break;
      case PlaneRule::Kind::horizontal:
        if (node.secondary > 0) return level_across(frame.h);
        break;
      case PlaneRule::Kind::gradient:
        e = level_across(frame.h);
        angle = radians(rules_.plane.angle) * (node.depth() - 1);
        break;
      case PlaneRule::Kind::random:
        angle = roll + radians(rules_.plane.angle) * uniform_open(chance_);
    }
    return e * std::cos(angle) + frame.h.cross(e) * std::sin(angle);
  }

  const Tree& tree_;
  const ShapeRules& rules_;
  Stream& chance_;
  Survey survey_;
  Shape shape_;
  NodeFacts root_{};
  std::vector<Twig> open_;
  std::vector<std::size_t> nodes_;  // of the fork at hand
  std::vector<NodeFacts> facts_;
  std::size_t sides_taken_ = 0;
};

}  // namespace

Shape place_limbs(const Tree& tree, const ShapeRules& rules, Stream& chance,
                  const Cancellation& cancellation) {
  return Placing(tree, rules, chance).shape(cancellation);
}

}  // namespace ramify
