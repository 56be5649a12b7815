// Products and solutions tree by tree, and the iteration.

#include "engine/vibration/largest_root.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <vector>

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using steady::HubCoupling;
using steady::LinearModel;
using steady::LinearTree;

Index size_of(const LinearModel& model) {
  Index size = model.M.rows();
  for (std::size_t i = 0; i < model.alike.size(); ++i) size += model.tree(i).M.rows();
  return size;
}

VectorXd multiply(const ArrowMatrix& matrix, const VectorXd& x) {
  const LinearModel& model = matrix.model;
  const Index h = model.M.rows();
  VectorXd y(x.size());
  y.head(h) = model.*matrix.hub * x.head(h);
  Index at = h;
  for (std::size_t i = 0; i < model.alike.size(); ++i) {
    const MatrixXd& tree = model.tree(i).*matrix.tree;
    const auto part = x.segment(at, tree.rows());
    y.segment(at, tree.rows()) = tree * part;
    if (h > 0) {
      const MatrixXd& by_hub = model.couplings[i].*matrix.tree_hub;
      y.segment(at, tree.rows()) += by_hub * x.head(h);
      y.head(h) += by_hub.transpose() * part;
    }
    at += tree.rows();
  }
  return y;
}

/// M, factorised: the trees, then what they leave of the hub.
class Mass {
 public:
  explicit Mass(const LinearModel& model) : model_(model) {
    MatrixXd hub = model.M;
    for (std::size_t i = 0; i < model.alike.size(); ++i) {
      if (model.alike[i] == i) trees_[i].compute(model.tree(i).M);
      if (hub.rows() == 0) continue;
      const MatrixXd& by_hub = model.couplings[i].M_bh;
      by_hub_.push_back(trees_[model.alike[i]].solve(by_hub));
      hub -= by_hub.transpose() * by_hub_.back();
    }
    hub_.compute(hub);
  }

  VectorXd multiply(const VectorXd& x) const {
    return vibration::multiply({model_, &LinearModel::M, &LinearTree::M, &HubCoupling::M_bh}, x);
  }
  VectorXd solve(const VectorXd& right) const {
    const Index h = model_.M.rows();
    VectorXd x(right.size());
    VectorXd of_hub = right.head(h);
    Index at = h;
    for (std::size_t i = 0; i < model_.alike.size(); ++i) {
      const auto& tree = trees_.at(model_.alike[i]);
      x.segment(at, tree.rows()) = tree.solve(right.segment(at, tree.rows()));
      if (h > 0) of_hub -= model_.couplings[i].M_bh.transpose() * x.segment(at, tree.rows());
      at += tree.rows();
    }
    if (h == 0) return x;
    x.head(h) = hub_.solve(of_hub);
    at = h;
    for (const MatrixXd& by_hub : by_hub_) {
      x.segment(at, by_hub.rows()) -= by_hub * x.head(h);
      at += by_hub.rows();
    }
    return x;
  }

 private:
  const LinearModel& model_;
  std::map<std::size_t, Eigen::LLT<MatrixXd>> trees_;
  std::vector<MatrixXd> by_hub_;
  Eigen::LLT<MatrixXd> hub_;
};

/// The largest eigenvalue of a symmetric tridiagonal matrix.
double find_largest(const std::vector<double>& diagonal, const std::vector<double>& beside) {
  const auto n = std::ssize(diagonal);
  Eigen::SelfAdjointEigenSolver<MatrixXd> solver;
  solver.computeFromTridiagonal(Eigen::Map<const VectorXd>(diagonal.data(), n),
                                Eigen::Map<const VectorXd>(beside.data(), n - 1),
                                Eigen::EigenvaluesOnly);
  return solver.eigenvalues()[n - 1];
}

}  // namespace

double find_largest_root(const ArrowMatrix& matrix) {
  constexpr double kEnough = 1e-10;
  constexpr int kMost = 300;
  const Index size = size_of(matrix.model);
  if (size == 0) return 0.0;
  const Mass mass(matrix.model);
  std::mt19937 dice(1);
  std::normal_distribution<double> normal;
  VectorXd next = VectorXd::NullaryExpr(size, [&] { return normal(dice); });
  MatrixXd basis(size, 0), momenta(size, 0);  // orthonormal in M, and M times it
  std::vector<double> diagonal, beside;
  double largest = 0.0;
  for (Index k = 0; k < std::min<Index>(size, kMost); ++k) {
    for (int twice = 0; twice < 2; ++twice) next -= basis * (momenta.transpose() * next).eval();
    const double length = std::sqrt(next.dot(mass.multiply(next)));
    if (k > 0 && length <= 1e-13 * std::abs(largest)) break;
    if (k > 0) beside.push_back(length);
    basis.conservativeResize(size, k + 1);
    momenta.conservativeResize(size, k + 1);
    basis.col(k) = next / length;
    momenta.col(k) = mass.multiply(basis.col(k));
    const VectorXd image = multiply(matrix, basis.col(k));
    diagonal.push_back(basis.col(k).dot(image));
    const double before = largest;
    largest = find_largest(diagonal, beside);
    if (k > 8 && std::abs(largest - before) <= kEnough * std::abs(largest)) break;
    next = mass.solve(image);
  }
  return largest;
}

}  // namespace spoke::vibration
