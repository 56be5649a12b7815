// An Arnoldi iteration on x'' = -M^-1 (C x' + K x).

#include "engine/vibration/extreme_root.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "engine/support/dense.h"

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The first-order system, its state (w x, x') with the frequency w of the stiffest coordinate,
/// which makes both parts equally large.
class Rates {
 public:
  explicit Rates(const Pencil& pencil)
      : pencil_(pencil), mass_(pencil, PencilWeights{1.0, 0.0, 0.0}), scale_(pencil.stiffest()) {}

  Index size() const { return 2 * pencil_.size(); }

  VectorXd operator*(const VectorXd& state) const {
    const Index n = pencil_.size();
    VectorXd rates(2 * n);
    rates.head(n) = scale_ * state.tail(n);
    const MatrixXd force =
        pencil_.stiffness(state.head(n)) / scale_ + pencil_.damping(0.0, state.tail(n));
    rates.tail(n) = -mass_.solve(force);
    return rates;
  }

 private:
  const Pencil& pencil_;
  PencilFactor mass_;
  double scale_;
};

/// The space that rates span from a vector on: an orthonormal basis, and the rates as it has them.
class KrylovSpace {
 public:
  explicit KrylovSpace(Index size) : basis_(size, 1), projected_(0, 0) {
    std::mt19937 dice{1};
    std::normal_distribution<double> normal;
    basis_ = MatrixXd::NullaryExpr(size, 1, [&] { return normal(dice); });
    basis_.normalize();
  }

  Index size() const { return projected_.cols(); }
  /// Whether it holds the rates of all that is in it.
  bool is_closed() const { return is_closed_; }
  const MatrixXd& projected() const { return projected_; }

  void grow(const Rates& rates) {
    const Index m = size();
    VectorXd next = rates * basis_.col(m);
    const double before = next.norm();
    projected_.conservativeResize(m + 1, m + 1);
    projected_.col(m).setZero();
    projected_.row(m).setZero();
    if (m > 0) projected_(m, m - 1) = remainder_;
    for (int twice = 0; twice < 2; ++twice) {
      const VectorXd shares = basis_.transpose() * next;
      next -= basis_ * shares;
      projected_.col(m) += shares;
    }
    remainder_ = next.norm();
    is_closed_ = m + 1 == basis_.rows() || remainder_ <= 1e-13 * before;
    if (is_closed_) return;
    basis_.conservativeResize(Eigen::NoChange, m + 2);
    basis_.col(m + 1) = next / remainder_;
  }

 private:
  MatrixXd basis_, projected_;
  double remainder_ = 0.0;
  bool is_closed_ = false;
};

std::complex<double> choose(const MatrixXd& projected, const RootMeasure& measure) {
  std::complex<double> found = 0.0;
  double most = 0.0;
  for (const std::complex<double>& s : find_eigenvalues(projected)) {
    if (s.imag() < 0.0 || measure(s) <= most) continue;
    most = measure(s);
    found = s;
  }
  return found;
}

}  // namespace

std::complex<double> find_extreme_root(const Pencil& pencil, const RootMeasure& measure) {
  constexpr Index kBlock = 20;
  if (pencil.size() == 0) return 0.0;
  const Rates rates(pencil);
  KrylovSpace space(rates.size());
  double before = 0.0;
  while (true) {
    for (Index k = 0; k < kBlock && !space.is_closed(); ++k) space.grow(rates);
    const std::complex<double> root = choose(space.projected(), measure);
    const double now = root == 0.0 ? 0.0 : measure(root);
    if (space.is_closed() || std::abs(now - before) <= 1e-6 * now) return root;
    before = now;
  }
}

}  // namespace spoke::vibration
