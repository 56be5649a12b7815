// Applies an Arnoldi iteration to x'' = -M^-1 (C x' + K x).

#include "engine/small_motions/vibration/extreme_root.h"

#include <algorithm>
#include <cmath>

#include "engine/small_motions/vibration/arnoldi_space.h"
#include "engine/support/dense.h"

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// The first-order system. Its state is (w x, x') with the frequency w of the stiffest coordinate,
/// which makes both parts equally large.
class Rates {
 public:
  explicit Rates(const Pencil& pencil)
      : pencil_(pencil), mass_(pencil, PencilWeights{1.0, 0.0, 0.0}), scale_(pencil.stiffest()) {}

  Index size() const { return 2 * pencil_.size(); }

  MatrixXd operator*(const MatrixXd& state) const {
    const Index n = pencil_.size();
    MatrixXd rates(2 * n, state.cols());
    rates.topRows(n) = scale_ * state.bottomRows(n);
    const MatrixXd force =
        pencil_.stiffness(state.topRows(n)) / scale_ + pencil_.damping(0.0, state.bottomRows(n));
    rates.bottomRows(n) = -mass_.solve(force);
    return rates;
  }

 private:
  const Pencil& pencil_;
  PencilFactor mass_;
  double scale_;
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
  ArnoldiSpace space(rates.size(), 1);
  double before = 0.0;
  while (true) {
    for (Index k = 0; k < kBlock && !space.is_all(); ++k) space.grow(rates);
    const std::complex<double> root = choose(space.projected(), measure);
    const double now = root == 0.0 ? 0.0 : measure(root);
    if (space.is_all() || std::abs(now - before) <= 1e-6 * now) return root;
    before = now;
  }
}

}  // namespace spoke::vibration
