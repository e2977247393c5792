#include "ramify/fit/lack_of_fit.hpp"

#include <array>
#include <cmath>

#include <Eigen/Dense>

namespace ramify {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::array<Size, 4> bands{3, 8, 32, 128};  // where they begin

/// Of the balances of one band.
struct Band {
  double nodes = 0, sum = 0, squares = 0;

  void add(const ObservedSplit& split) {
    const double balance = 2 * static_cast<double>(split.smaller) / (static_cast<double>(split.size()) - 1);
    nodes += split.count;
    sum += split.count * balance;
    squares += split.count * balance * balance;
  }
};

/// What a linear regression on the estimates leaves of the features, row by row.
MatrixXd residuals(std::span<const FittedFeatures> trees) {
  const auto rows = static_cast<Index>(trees.size());
  const auto estimates = static_cast<Index>(trees[0].searched.size());
  MatrixXd design(rows, 1 + estimates), features(rows, static_cast<Index>(trees[0].values.size()));
  for (Index r = 0; r < rows; ++r) {
    const FittedFeatures& tree = trees[static_cast<std::size_t>(r)];
    design(r, 0) = 1;
    design.row(r).tail(estimates) = VectorXd::Map(tree.searched.data(), estimates);
    features.row(r) = VectorXd::Map(tree.values.data(), features.cols());
  }
  return features - design * design.completeOrthogonalDecomposition().solve(features);
}

}  // namespace

std::vector<double> features_of(const ObservedSplits& splits, double log_likelihood) {
  std::array<Band, bands.size()> found;
  for (const ObservedSplit& split : splits.splits()) {
    std::size_t band = bands.size() - 1;
    while (split.size() < bands[band]) --band;
    found[band].add(split);
  }
  std::vector<double> features{log_likelihood / splits.nodes()};
  for (const Band& band : found) {
    features.push_back(band.nodes > 0 ? band.sum / band.nodes : 0);
    features.push_back(band.nodes > 0 ? band.squares / band.nodes : 0);
  }
  return features;
}

std::vector<double> lack_of_fit(std::span<const FittedFeatures> trees) {
  MatrixXd left = residuals(trees);
  const VectorXd scales = left.colwise().norm();
  const double largest = scales.maxCoeff();
  for (Index c = 0; c < left.cols(); ++c)
    if (scales[c] > 1e-12 * largest)
      left.col(c) /= scales[c];
    else
      left.col(c).setZero();
  // Directions without spread say nothing: a feature that the others give, or that all trees have.
  const Eigen::SelfAdjointEigenSolver<MatrixXd> axes(left.transpose() * left);
  const MatrixXd along = left * axes.eigenvectors();
  VectorXd distance = VectorXd::Zero(left.rows());
  for (Index c = 0; c < along.cols(); ++c)
    if (axes.eigenvalues()[c] > 1e-9) distance += along.col(c).cwiseAbs2() / axes.eigenvalues()[c];
  return {distance.data(), distance.data() + distance.size()};
}

}  // namespace ramify
