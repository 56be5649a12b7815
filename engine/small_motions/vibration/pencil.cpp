// Multiplies and factorises, subsystem by subsystem.

#include "engine/small_motions/vibration/pencil.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using steady::HubCoupling;
using steady::LinearModel;
using steady::LinearSubsystem;
using steady::RoundOff;

constexpr double kRounding = std::numeric_limits<double>::epsilon();
/// Number of rounded terms of a force.
constexpr double kTerms = 30.0;

/// Returns factors that scale the diagonal to ones; 1 for zeros.
VectorXd find_balance(const MatrixXd& matrix) {
  VectorXd balance = matrix.diagonal().cwiseAbs();
  const double most = balance.size() > 0 ? balance.maxCoeff() : 0.0;
  for (double& value : balance)
    value = value > kRounding * kRounding * most ? 1.0 / std::sqrt(value) : 1.0;
  return balance;
}

std::vector<std::size_t> all_subsystems(const LinearModel& model) {
  std::vector<std::size_t> subsystems(model.subsystems.size());
  std::iota(subsystems.begin(), subsystems.end(), std::size_t{0});
  return subsystems;
}

}  // namespace

Pencil::Pencil(const LinearModel& model) : Pencil(model, all_subsystems(model)) {}

Pencil::Pencil(const LinearModel& model, std::vector<std::size_t> subsystems)
    : model_(model), subsystems_(std::move(subsystems)) {
  Index size = model.M.rows();
  for (const std::size_t i : subsystems_) {
    starts_.push_back(size);
    size += model.subsystem(i).M.rows();
  }
  scale_.resize(size);
  std::vector<double> squares;
  // A stiffness that is nothing but round-off does not count.
  const auto add = [&](const MatrixXd& M, const MatrixXd& K, const RoundOff& lost, Index at) {
    for (Index k = 0; k < M.rows(); ++k) {
      scale_[at + k] = 1.0 / std::sqrt(M(k, k));
      const double stiffness = std::abs(K(k, k));
      const double round_off = kTerms * kRounding * lost.force[k] / lost.step[k];
      largest_round_off_ = std::max(largest_round_off_, round_off / M(k, k));
      if (stiffness > round_off)
        squares.push_back(stiffness / M(k, k));
      else
        is_held_ = false;
    }
  };
  add(model.M, model.K, model.round_off, 0);
  for (std::size_t place = 0; place < subsystems_.size(); ++place) {
    const LinearSubsystem& t = model.subsystem(subsystems_[place]);
    add(t.M, t.K, t.round_off, starts_[place]);
  }
  const double most = squares.empty() ? 0.0 : *std::max_element(squares.begin(), squares.end());
  if (most == 0.0) return;
  stiffest_ = softest_ = std::sqrt(most);
  for (const double square : squares)
    if (square > 1e-30 * most) softest_ = std::min(softest_, std::sqrt(square));
}

bool Pencil::is_symmetric() const {
  VectorXd held(size());
  const auto hold = [&](const MatrixXd& K, Index at) {
    held.segment(at, K.rows()) =
        K.diagonal().cwiseAbs().cwiseSqrt().cwiseProduct(scale_.segment(at, K.rows()));
  };
  hold(model_.K, 0);
  // Each pair is judged by its own diagonal entries, not by the stiffest ones.
  const auto agree = [&](const MatrixXd& K, const MatrixXd& other, Index row, Index column) {
    for (Index i = 0; i < K.rows(); ++i)
      for (Index k = 0; k < K.cols(); ++k) {
        const double size = scale_[row + i] * scale_[column + k];
        if (std::abs(K(i, k) - other(k, i)) * size >
            1e-9 * held[row + i] * held[column + k] + largest_round_off_)
          return false;
      }
    return true;
  };
  // M has a unit diagonal: C is a rate, to be compared with the frequencies.
  const auto is_slow = [&](const MatrixXd& C, Index row, Index column) {
    for (Index i = 0; i < C.rows(); ++i)
      for (Index k = 0; k < C.cols(); ++k)
        if (std::abs(C(i, k)) * scale_[row + i] * scale_[column + k] > 1e-9 * softest_)
          return false;
    return true;
  };
  bool is = is_slow(model_.C, 0, 0) && agree(model_.K, model_.K, 0, 0);
  for (std::size_t place = 0; place < subsystems_.size() && is; ++place) {
    const LinearSubsystem& t = model_.subsystem(subsystems_[place]);
    const Index at = starts_[place];
    hold(t.K, at);
    is = is_slow(t.C, at, at) && agree(t.K, t.K, at, at);
    if (!is || !has_hub()) continue;
    const HubCoupling& c = model_.couplings[subsystems_[place]];
    is = is_slow(c.C_bh, at, 0) && is_slow(c.C_hb, 0, at) && agree(c.K_bh, c.K_hb, at, 0);
  }
  return is;
}

/// Returns |x|^T |A| |x| for the matrix A of these parts.
double Pencil::sum_terms(MatrixXd LinearSubsystem::*subsystem, MatrixXd HubCoupling::*subsystem_hub,
                         MatrixXd HubCoupling::*hub_subsystem, MatrixXd LinearModel::*hub,
                         const VectorXd& x) const {
  const auto form = [](const auto& left, const MatrixXd& A, const auto& right) {
    return A.size() == 0 ? 0.0 : left.dot(A.cwiseAbs() * right);
  };
  const bool is_stiffness = subsystem == &LinearSubsystem::K;
  const VectorXd of_hub = x.head(model_.M.rows());
  double sum = form(of_hub, model_.*hub, of_hub);
  for (std::size_t place = 0; place < subsystems_.size(); ++place) {
    const LinearSubsystem& t = model_.subsystem(subsystems_[place]);
    const VectorXd of_subsystem = x.segment(starts_[place], t.M.rows());
    const bool has_terms = is_stiffness && t.K_terms.size() > 0;
    sum += form(of_subsystem, has_terms ? t.K_terms : t.*subsystem, of_subsystem);
    if (!has_hub()) continue;
    const HubCoupling& both = model_.couplings[subsystems_[place]];
    sum += form(of_subsystem, both.*subsystem_hub, of_hub) +
           form(of_hub, both.*hub_subsystem, of_subsystem);
  }
  return sum;
}

double Pencil::calc_round_off(const Eigen::VectorXcd& x, double magnitude_of_s) const {
  assert(x.size() == size() && magnitude_of_s >= 0.0);
  const VectorXd size = scale_.cwiseProduct(x.cwiseAbs());
  const double s = magnitude_of_s;
  double force = model_.round_off.force.dot(size.head(model_.M.rows()));
  double steps = size.head(model_.M.rows()).cwiseQuotient(model_.round_off.step).sum();
  for (std::size_t place = 0; place < subsystems_.size(); ++place) {
    const RoundOff& lost = model_.subsystem(subsystems_[place]).round_off;
    const VectorXd of_subsystem = size.segment(starts_[place], lost.step.size());
    force += lost.force.dot(of_subsystem);
    steps += of_subsystem.cwiseQuotient(lost.step).sum();
  }
  const auto sum = [&](auto subsystem, auto subsystem_hub, auto hub_subsystem, auto hub) {
    return sum_terms(subsystem, subsystem_hub, hub_subsystem, hub, size);
  };
  const double terms =
      s * s * sum(&LinearSubsystem::M, &HubCoupling::M_bh, &HubCoupling::M_hb, &LinearModel::M) +
      s * sum(&LinearSubsystem::C, &HubCoupling::C_bh, &HubCoupling::C_hb, &LinearModel::C) +
      sum(&LinearSubsystem::K, &HubCoupling::K_bh, &HubCoupling::K_hb, &LinearModel::K) +
      force * steps * (1.0 + s / model_.rate);
  return kTerms * kRounding * terms;
}

MatrixXd Pencil::apply(MatrixXd LinearSubsystem::*subsystem, MatrixXd HubCoupling::*subsystem_hub,
                       MatrixXd HubCoupling::*hub_subsystem, MatrixXd LinearModel::*hub,
                       const MatrixXd& x) const {
  const MatrixXd scaled = scale_.asDiagonal() * x;
  const Index h = model_.M.rows();
  MatrixXd y(x.rows(), x.cols());
  y.topRows(h) = model_.*hub * scaled.topRows(h);
  for (std::size_t place = 0; place < subsystems_.size(); ++place) {
    const LinearSubsystem& t = model_.subsystem(subsystems_[place]);
    const auto of_subsystem = scaled.middleRows(starts_[place], t.M.rows());
    auto rows = y.middleRows(starts_[place], t.M.rows());
    rows = t.*subsystem * of_subsystem;
    if (h == 0) continue;
    const HubCoupling& hub_and_subsystem = model_.couplings[subsystems_[place]];
    rows += hub_and_subsystem.*subsystem_hub * scaled.topRows(h);
    y.topRows(h) += hub_and_subsystem.*hub_subsystem * of_subsystem;
  }
  return scale_.asDiagonal() * y;
}

MatrixXd Pencil::mass(const MatrixXd& x) const {
  assert(x.rows() == size());
  return apply(&LinearSubsystem::M, &HubCoupling::M_bh, &HubCoupling::M_hb, &LinearModel::M, x);
}

MatrixXd Pencil::damping(double s, const MatrixXd& x) const {
  assert(x.rows() == size());
  return apply(&LinearSubsystem::C, &HubCoupling::C_bh, &HubCoupling::C_hb, &LinearModel::C, x) +
         s * mass(x);
}

MatrixXd Pencil::stiffness(const MatrixXd& x) const {
  assert(x.rows() == size());
  return apply(&LinearSubsystem::K, &HubCoupling::K_bh, &HubCoupling::K_hb, &LinearModel::K, x);
}

MatrixXd Pencil::dense_mass() const { return mass(MatrixXd::Identity(size(), size())); }
MatrixXd Pencil::dense_damping() const { return damping(0.0, MatrixXd::Identity(size(), size())); }
MatrixXd Pencil::dense_stiffness() const { return stiffness(MatrixXd::Identity(size(), size())); }

BalancedFactor::BalancedFactor(const MatrixXd& matrix) : balance_(find_balance(matrix)) {
  if (rows() > 0) factor_.compute(balance_.asDiagonal() * matrix * balance_.asDiagonal());
}

MatrixXd BalancedFactor::solve(const MatrixXd& right) const {
  assert(right.rows() == rows());
  if (rows() == 0) return right;
  return balance_.asDiagonal() * factor_.solve(balance_.asDiagonal() * right);
}

double BalancedFactor::rcond() const {
  if (rows() == 0) return 1.0;
  // The estimate does not see a pivot of zero, of a motion that nothing holds.
  const VectorXd pivots = factor_.pivots().cwiseAbs();
  const double least = pivots.minCoeff() / pivots.maxCoeff();
  return least > 0.0 ? std::min(least, factor_.rcond()) : 0.0;
}

PencilFactor::PencilFactor(const Pencil& pencil, const PencilWeights& weights) : pencil_(pencil) {
  const LinearModel& model = pencil.model_;
  const Index h = model.M.rows();
  const VectorXd of_hub = pencil.scale_.head(h);
  const auto evaluate = [&](const MatrixXd& M, const MatrixXd& C, const MatrixXd& K) {
    return MatrixXd(weights.mass * M + weights.damping * C + weights.stiffness * K);
  };
  MatrixXd hub = of_hub.asDiagonal() * evaluate(model.M, model.C, model.K) * of_hub.asDiagonal();
  std::vector<std::size_t> factor_of(model.subsystems.size(), model.subsystems.size());
  for (std::size_t place = 0; place < pencil.subsystems_.size(); ++place) {
    const std::size_t i = pencil.subsystems_[place], first = model.alike[i];
    const LinearSubsystem& t = model.subsystem(i);
    const VectorXd scale = pencil.scale_.segment(pencil.starts_[place], t.M.rows());
    if (factor_of[first] == model.subsystems.size()) {
      factor_of[first] = factors_.size();
      factors_.emplace_back(
          MatrixXd(scale.asDiagonal() * evaluate(t.M, t.C, t.K) * scale.asDiagonal()));
      rcond_ = std::min(rcond_, factors_.back().rcond());
    }
    factor_of_.push_back(factor_of[first]);
    if (h == 0) continue;
    const HubCoupling& c = model.couplings[i];
    by_hub_.push_back(subsystem(place).solve(
        MatrixXd(scale.asDiagonal() * evaluate(c.M_bh, c.C_bh, c.K_bh) * of_hub.asDiagonal())));
    on_hub_.push_back(of_hub.asDiagonal() * evaluate(c.M_hb, c.C_hb, c.K_hb) * scale.asDiagonal());
    hub -= on_hub_.back() * by_hub_.back();
  }
  if (h == 0) return;
  hub_.emplace(hub);
  rcond_ = std::min(rcond_, hub_->rcond());
}

MatrixXd PencilFactor::solve(const MatrixXd& right) const {
  assert(right.rows() == pencil_.size());
  const Index h = pencil_.model_.M.rows();
  MatrixXd x(right.rows(), right.cols());
  MatrixXd of_hub = right.topRows(h);
  for (std::size_t place = 0; place < factor_of_.size(); ++place) {
    auto rows = x.middleRows(pencil_.starts_[place], subsystem(place).rows());
    rows =
        subsystem(place).solve(right.middleRows(pencil_.starts_[place], subsystem(place).rows()));
    if (h > 0) of_hub -= on_hub_[place] * rows;
  }
  if (h == 0) return x;
  x.topRows(h) = hub_->solve(of_hub);
  for (std::size_t place = 0; place < factor_of_.size(); ++place)
    x.middleRows(pencil_.starts_[place], subsystem(place).rows()) -= by_hub_[place] * x.topRows(h);
  return x;
}

}  // namespace spoke::vibration
