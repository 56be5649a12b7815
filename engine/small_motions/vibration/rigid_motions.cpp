// Finds null vectors of the stiffness.

#include "engine/small_motions/vibration/rigid_motions.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <random>

#include "engine/support/dense.h"

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Returns an orthonormal basis of about the `width` motions of least stiffness by mass.
MatrixXd find_softest(const Pencil& pencil, double shift, Index width) {
  constexpr int kIterations = 8;
  const PencilFactor factor(pencil, PencilWeights{shift * shift, 0.0, 1.0});
  std::mt19937 dice{1};
  std::normal_distribution<double> normal;
  MatrixXd x = MatrixXd::NullaryExpr(pencil.size(), width, [&] { return normal(dice); });
  for (int k = 0; k < kIterations; ++k) x = find_orthonormal_basis(factor.solve(pencil.mass(x)));
  return x;
}

/// Returns the motions without stiffness in the span of x.
MatrixXd find_without_stiffness(const Pencil& pencil, double shift, const MatrixXd& x) {
  constexpr double kLost = 10.0 * std::numeric_limits<double>::epsilon();
  const CholeskyFactor mass(x.transpose() * pencil.mass(x));
  const MatrixXd basis = mass.solve_upper_on_the_right(x);
  const RightSingular parts = find_right_singular(basis.transpose() * pencil.stiffness(basis));
  Index count = 0;
  for (; count < x.cols(); ++count) {
    const Index k = x.cols() - 1 - count;
    const VectorXd motion = basis * parts.vectors.col(k);
    const double round_off =
        pencil.calc_round_off(motion.cast<std::complex<double>>(), 0.0) + kLost * shift * shift;
    if (!(parts.values[k] <= round_off)) break;
  }
  return basis * parts.vectors.rightCols(count);
}

}  // namespace

MatrixXd find_rigid_motions(const Pencil& pencil, double shift) {
  assert(shift > 0.0);
  for (Index width = std::min<Index>(8, pencil.size());;
       width = std::min(2 * width, pencil.size())) {
    MatrixXd found = find_without_stiffness(pencil, shift, find_softest(pencil, shift, width));
    if (found.cols() < width || width == pencil.size()) return found;
  }
}

}  // namespace spoke::vibration
