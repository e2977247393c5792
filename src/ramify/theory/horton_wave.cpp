#include "ramify/theory/horton_wave.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/LU>

namespace ramify {
namespace {

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

}  // namespace

/// A child at a node of the quadrature: its share of the size, and where psi and psi' are read.
struct HortonWave::Child {
  double share;  ///< x or 1-x
  LatticeStencil same_order;
  LatticeStencil order_below;

  Child(double its_share, double log_share, double log_ratio, double spacing)
      : share(its_share), same_order(log_share / spacing), order_below((log_share + log_ratio) / spacing) {}
};

/// What the equations share from one lattice point to the next.
struct HortonWave::Stencils {
  std::vector<Child> left, right;
  std::vector<double> weights;  ///< of G in the integral, the weight x^(a-1) (1-x)^(b-1) scaled
  int reach_below = 0;          ///< points below and above the lattice that are read
  int reach_above = 0;

  Stencils(const Quadrature& rule, double log_ratio, double spacing) {
    for (std::size_t q = 0; q < rule.nodes.size(); ++q) {
      const double x = rule.nodes[q];
      left.emplace_back(x, std::log(x), log_ratio, spacing);
      right.emplace_back(1 - x, std::log1p(-x), log_ratio, spacing);
      weights.push_back(rule.weights[q] / (x * (1 - x)));
      for (const auto& child : {left.back(), right.back()}) {
        reach_below = std::max(reach_below, -child.same_order.first);
        reach_above = std::max(reach_above, child.order_below.first + LatticeStencil::width);
      }
    }
    reach_above = std::max(reach_above, LatticeStencil::width);
  }
};

/// One equation while it is summed up: what it reads and what it adds to, both at its own lattice point.
struct HortonWave::Row {
  const double* phi;
  double* slope;
  double scale;  ///< e^y
  double ratio;  ///< R
  Slopes slopes;
};

/// The equations times e^(-y), one a lattice point, and their derivatives by phi.
struct HortonWave::System {
  Eigen::VectorXd residual;
  RowMatrix jacobian;

  Eigen::VectorXd solve() const { return jacobian.partialPivLu().solve(residual); }
};

namespace {

double read(const LatticeStencil& stencil, const double* at) {
  double sum = 0;
  for (int j = 0; j < LatticeStencil::width; ++j)
    sum += stencil.weight[static_cast<std::size_t>(j)] * at[stencil.first + j];
  return sum;
}

void add(const LatticeStencil& stencil, double factor, double* at) {
  for (int j = 0; j < LatticeStencil::width; ++j)
    at[stencil.first + j] += factor * stencil.weight[static_cast<std::size_t>(j)];
}

}  // namespace

HortonWave::HortonWave(const BetaSplit& split, const Mesh& mesh)
    : split_(split),
      mesh_(mesh),
      rule_(gauss_jacobi(mesh.points, split.a, split.b)),
      log_ratio_(std::log(3.0)) {
  for (int i = 0; i < size(); ++i) {
    const double scale = std::exp(position(i));
    phi_.push_back(-std::expm1(-std::numbers::ln2 * scale) / scale);
  }
}

HortonWave HortonWave::resampled(const Mesh& mesh) const {
  HortonWave wave = *this;
  wave.phi_ = shifted_phi(mesh, 0);
  wave.mesh_ = mesh;
  if (mesh.points != mesh_.points) wave.rule_ = gauss_jacobi(mesh.points, split_.a, split_.b);
  return wave;
}

double HortonWave::advance() {
  const Eigen::VectorXd correction = equations(log_ratio_, Slopes::same_order).solve();
  for (int i = 0; i < size(); ++i) phi_[static_cast<std::size_t>(i)] -= correction[i];
  const double moved = median();
  phi_ = shifted_phi(mesh_, moved);
  log_ratio_ += moved;
  return moved;
}

double HortonWave::refine() {
  // The equations are smooth in log R: a central difference gives 10 digits of its column, and Newton's
  // method makes up for the others.
  constexpr double step = 1e-5;
  const System here = equations(log_ratio_, Slopes::both_orders);
  const Eigen::VectorXd ahead = equations(log_ratio_ + step, Slopes::none).residual;
  const Eigen::VectorXd behind = equations(log_ratio_ - step, Slopes::none).residual;
  const int n = size();
  System bordered{Eigen::VectorXd(n + 1), RowMatrix::Zero(n + 1, n + 1)};
  bordered.residual << here.residual, phi_at_point(mesh_.below) - 0.5;
  bordered.jacobian.topLeftCorner(n, n) = here.jacobian;
  bordered.jacobian.col(n).head(n) = (ahead - behind) / (2 * step);
  bordered.jacobian(n, mesh_.below) = 1;
  const Eigen::VectorXd correction = bordered.solve();
  for (int i = 0; i < n; ++i) phi_[static_cast<std::size_t>(i)] -= correction[i];
  log_ratio_ -= correction[n];
  return correction.lpNorm<Eigen::Infinity>();
}

HortonWave::Mesh HortonWave::extent() const {
  Mesh least = mesh_;
  least.below = least.above = 0;
  while (least.below < mesh_.below && std::abs(phi_at_point(mesh_.below - least.below)) > 1e-18)
    ++least.below;
  while (least.above < mesh_.above && std::abs(1 - psi(least.above * mesh_.spacing)) > 1e-13) ++least.above;
  return least;
}

double HortonWave::phi_at_point(int i) const {
  if (i < 0) return 0;
  return i < size() ? phi_[static_cast<std::size_t>(i)] : std::exp(-position(i));
}

double HortonWave::psi(double y) const {
  const LatticeStencil stencil(y / mesh_.spacing);
  double phi = 0;
  for (int j = 0; j < LatticeStencil::width; ++j)
    phi += stencil.weight[static_cast<std::size_t>(j)] * phi_at_point(mesh_.below + stencil.first + j);
  return phi * std::exp(y);
}

double HortonWave::median() const {
  double low = position(0), high = position(size() - 1);
  for (int halvings = 0; halvings < 60; ++halvings) {
    const double middle = (low + high) / 2;
    (psi(middle) < 0.5 ? low : high) = middle;
  }
  return low;
}

std::vector<double> HortonWave::shifted_phi(const Mesh& mesh, double shift) const {
  std::vector<double> phi;
  for (int i = -mesh.below; i <= mesh.above; ++i) {
    const double y = i * mesh.spacing;
    phi.push_back(psi(y + shift) * std::exp(-y));
  }
  return phi;
}

/// The contribution of one split to a row of the residual; adds its derivatives to the row's slope.
double HortonWave::add_split(const Child& left, const Child& right, double weight, const Row& row) {
  const double growth = row.ratio * row.scale;
  const double left_same = left.share * read(left.same_order, row.phi);  // psi(y1) e^-y
  const double right_same = right.share * read(right.same_order, row.phi);
  const double left_below = growth * left.share * read(left.order_below, row.phi);  // psi'(y1)
  const double right_below = growth * right.share * read(right.order_below, row.phi);
  if (row.slopes != Slopes::none) {
    add(left.same_order, weight * left.share * (1 - right_below), row.slope);
    add(right.same_order, weight * right.share * (1 - left_below), row.slope);
    *row.slope -= weight;
  }
  if (row.slopes == Slopes::both_orders) {
    add(left.order_below, weight * left.share * (row.ratio * right_below - growth * right_same), row.slope);
    add(right.order_below, weight * right.share * (row.ratio * left_below - growth * left_same), row.slope);
  }
  return weight * (left_same * (1 - right_below) + right_same * (1 - left_below) +
                   left_below * right_below / row.scale - *row.phi);
}

HortonWave::System HortonWave::equations(double log_ratio, Slopes slopes) const {
  const Stencils stencils(rule_, log_ratio, mesh_.spacing);
  const int n = size();
  std::vector<double> phi;
  for (int i = -stencils.reach_below; i < n + stencils.reach_above; ++i) phi.push_back(phi_at_point(i));
  std::vector<double> slope(phi.size());
  System system{Eigen::VectorXd::Zero(n), RowMatrix()};
  if (slopes != Slopes::none) system.jacobian.resize(n, n);
  for (int i = 0; i < n; ++i) {
    std::fill(slope.begin(), slope.end(), 0.0);
    const Row row{phi.data() + stencils.reach_below + i, slope.data() + stencils.reach_below + i,
                  std::exp(position(i)), std::exp(log_ratio), slopes};
    for (std::size_t q = 0; q < stencils.weights.size(); ++q)
      system.residual[i] += add_split(stencils.left[q], stencils.right[q], stencils.weights[q], row);
    if (slopes != Slopes::none)
      system.jacobian.row(i) = Eigen::Map<const Eigen::RowVectorXd>(slope.data() + stencils.reach_below, n);
  }
  return system;
}

}  // namespace ramify
