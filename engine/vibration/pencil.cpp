// Products and factors, tree by tree.

#include "engine/vibration/pencil.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using steady::HubCoupling;
using steady::LinearModel;
using steady::LinearTree;

/// The estimate passes by a pivot of zero, that of what nothing holds. A tree without coordinates
/// loses nothing.
double find_rcond(const Eigen::PartialPivLU<MatrixXd>& factor) {
  if (factor.rows() == 0) return 1.0;
  const VectorXd pivots = factor.matrixLU().diagonal().cwiseAbs();
  const double least = pivots.minCoeff() / pivots.maxCoeff();
  return least > 0.0 ? std::min(least, factor.rcond()) : 0.0;
}

std::vector<std::size_t> all_trees(const LinearModel& model) {
  std::vector<std::size_t> trees(model.trees.size());
  std::iota(trees.begin(), trees.end(), std::size_t{0});
  return trees;
}

}  // namespace

Pencil::Pencil(const LinearModel& model) : Pencil(model, all_trees(model)) {}

Pencil::Pencil(const LinearModel& model, std::vector<std::size_t> trees)
    : model_(model), trees_(std::move(trees)) {
  Index size = model.M.rows();
  for (const std::size_t i : trees_) {
    starts_.push_back(size);
    size += model.tree(i).M.rows();
  }
  scale_.resize(size);
  std::vector<double> squares;
  const auto add = [&](const MatrixXd& M, const MatrixXd& K, Index at) {
    for (Index k = 0; k < M.rows(); ++k) {
      scale_[at + k] = 1.0 / std::sqrt(M(k, k));
      squares.push_back(std::abs(K(k, k)) / M(k, k));
    }
  };
  add(model.M, model.K, 0);
  for (std::size_t place = 0; place < trees_.size(); ++place)
    add(model.tree(trees_[place]).M, model.tree(trees_[place]).K, starts_[place]);
  const double most = squares.empty() ? 0.0 : *std::max_element(squares.begin(), squares.end());
  if (most == 0.0) return;
  stiffest_ = softest_ = std::sqrt(most);
  // What is nothing but round-off is no stiffness.
  for (const double square : squares)
    if (square > 1e-14 * most) softest_ = std::min(softest_, std::sqrt(square));
}

MatrixXd Pencil::apply(MatrixXd LinearTree::*tree, MatrixXd HubCoupling::*tree_hub,
                       MatrixXd HubCoupling::*hub_tree, MatrixXd LinearModel::*hub,
                       const MatrixXd& x) const {
  const MatrixXd scaled = scale_.asDiagonal() * x;
  const Index h = model_.M.rows();
  MatrixXd y(x.rows(), x.cols());
  y.topRows(h) = model_.*hub * scaled.topRows(h);
  for (std::size_t place = 0; place < trees_.size(); ++place) {
    const LinearTree& t = model_.tree(trees_[place]);
    const auto of_tree = scaled.middleRows(starts_[place], t.M.rows());
    auto rows = y.middleRows(starts_[place], t.M.rows());
    rows = t.*tree * of_tree;
    if (h == 0) continue;
    const HubCoupling& hub_and_tree = model_.couplings[trees_[place]];
    rows += hub_and_tree.*tree_hub * scaled.topRows(h);
    y.topRows(h) += hub_and_tree.*hub_tree * of_tree;
  }
  return scale_.asDiagonal() * y;
}

MatrixXd Pencil::mass(const MatrixXd& x) const {
  return apply(&LinearTree::M, &HubCoupling::M_bh, &HubCoupling::M_hb, &LinearModel::M, x);
}

MatrixXd Pencil::damping(double s, const MatrixXd& x) const {
  return apply(&LinearTree::C, &HubCoupling::C_bh, &HubCoupling::C_hb, &LinearModel::C, x) +
         s * mass(x);
}

MatrixXd Pencil::stiffness(const MatrixXd& x) const {
  return apply(&LinearTree::K, &HubCoupling::K_bh, &HubCoupling::K_hb, &LinearModel::K, x);
}

MatrixXd Pencil::dense_mass() const { return mass(MatrixXd::Identity(size(), size())); }
MatrixXd Pencil::dense_damping() const { return damping(0.0, MatrixXd::Identity(size(), size())); }
MatrixXd Pencil::dense_stiffness() const { return stiffness(MatrixXd::Identity(size(), size())); }

PencilFactor::PencilFactor(const Pencil& pencil, const PencilWeights& weights) : pencil_(pencil) {
  const LinearModel& model = pencil.model_;
  const Index h = model.M.rows();
  const VectorXd of_hub = pencil.scale_.head(h);
  const auto evaluate = [&](const MatrixXd& M, const MatrixXd& C, const MatrixXd& K) {
    return MatrixXd(weights.mass * M + weights.damping * C + weights.stiffness * K);
  };
  MatrixXd hub = of_hub.asDiagonal() * evaluate(model.M, model.C, model.K) * of_hub.asDiagonal();
  std::vector<std::size_t> factor_of(model.trees.size(), model.trees.size());
  for (std::size_t place = 0; place < pencil.trees_.size(); ++place) {
    const std::size_t i = pencil.trees_[place], first = model.alike[i];
    const LinearTree& t = model.tree(i);
    const VectorXd scale = pencil.scale_.segment(pencil.starts_[place], t.M.rows());
    if (factor_of[first] == model.trees.size()) {
      factor_of[first] = factors_.size();
      factors_.emplace_back(
          MatrixXd(scale.asDiagonal() * evaluate(t.M, t.C, t.K) * scale.asDiagonal()));
      rcond_ = std::min(rcond_, find_rcond(factors_.back()));
    }
    factor_of_.push_back(factor_of[first]);
    if (h == 0) continue;
    const HubCoupling& c = model.couplings[i];
    by_hub_.push_back(tree(place).solve(
        MatrixXd(scale.asDiagonal() * evaluate(c.M_bh, c.C_bh, c.K_bh) * of_hub.asDiagonal())));
    on_hub_.push_back(of_hub.asDiagonal() * evaluate(c.M_hb, c.C_hb, c.K_hb) * scale.asDiagonal());
    hub -= on_hub_.back() * by_hub_.back();
  }
  if (h == 0) return;
  hub_.compute(hub);
  rcond_ = std::min(rcond_, find_rcond(hub_));
}

MatrixXd PencilFactor::solve(const MatrixXd& right) const {
  const Index h = pencil_.model_.M.rows();
  MatrixXd x(right.rows(), right.cols());
  MatrixXd of_hub = right.topRows(h);
  for (std::size_t place = 0; place < factor_of_.size(); ++place) {
    auto rows = x.middleRows(pencil_.starts_[place], tree(place).rows());
    rows = tree(place).solve(right.middleRows(pencil_.starts_[place], tree(place).rows()));
    if (h > 0) of_hub -= on_hub_[place] * rows;
  }
  if (h == 0) return x;
  x.topRows(h) = hub_.solve(of_hub);
  for (std::size_t place = 0; place < factor_of_.size(); ++place)
    x.middleRows(pencil_.starts_[place], tree(place).rows()) -= by_hub_[place] * x.topRows(h);
  return x;
}

}  // namespace spoke::vibration
