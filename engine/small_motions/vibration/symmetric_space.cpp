// Keeps the basis orthonormal by mass, each vector against all before.

#include "engine/small_motions/vibration/symmetric_space.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace spoke::vibration {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

SymmetricSpace::SymmetricSpace(const Pencil& pencil, double shift, const MatrixXd& known,
                               Index width)
    : pencil_(pencil),
      factor_(pencil, PencilWeights{shift * shift, 0.0, 1.0}),
      width_(width),
      basis_(pencil.size(), 0),
      momentum_(pencil.size(), 0),
      image_(pencil.size(), 0) {
  assert(width > 0 && known.rows() == pencil.size());
  for (const auto& motion : known.colwise()) add(motion);
  known_ = known.cols();
}

/// Adds what a column has besides the basis, or a random vector if that is round-off.
void SymmetricSpace::add(VectorXd column) {
  constexpr double kDepends = 1e-12;
  std::normal_distribution<double> normal;
  VectorXd momentum = pencil_.mass(column);
  for (int trial = 0; trial < 3; ++trial) {
    const double before = std::sqrt(column.dot(momentum));
    for (int twice = 0; twice < 2; ++twice) column -= basis_ * (momentum_.transpose() * column);
    momentum = pencil_.mass(column);
    const double after = std::sqrt(column.dot(momentum));
    if (after > kDepends * before) {
      column /= after;
      momentum /= after;
      break;
    }
    column = VectorXd::NullaryExpr(column.size(), [&] { return normal(dice_); });
    momentum = pencil_.mass(column);
  }
  const Index at = basis_.cols();
  basis_.conservativeResize(Eigen::NoChange, at + 1);
  momentum_.conservativeResize(Eigen::NoChange, at + 1);
  basis_.col(at) = column;
  momentum_.col(at) = momentum;
}

void SymmetricSpace::grow() {
  assert(!is_all());
  const Index block = std::min(width_, basis_.rows() - basis_.cols());
  const Index before = image_.cols(), last = std::min(width_, before);
  std::normal_distribution<double> normal;
  for (Index k = 0; k < block; ++k)
    add(k < last ? VectorXd(image_.col(before - last + k))
                 : VectorXd::NullaryExpr(basis_.rows(), [&] { return normal(dice_); }));
  image_.conservativeResize(Eigen::NoChange, before + block);
  MatrixXd image = factor_.solve(momentum_.rightCols(block));
  // Known motions are known to some digits: what they lack would be in the images.
  image -= basis_.leftCols(known_) * (momentum_.leftCols(known_).transpose() * image).eval();
  image_.rightCols(block) = image;
}

SymmetricSpace::Pairs SymmetricSpace::find_pairs() const {
  const MatrixXd projected = momentum_.rightCols(size()).transpose() * image_;
  return {solve_symmetric(0.5 * (projected + projected.transpose())),
          (projected - projected.transpose()).cwiseAbs().maxCoeff()};
}

double SymmetricSpace::find_remainder(const SymmetricEigen& ritz, Index k) const {
  const VectorXd y = ritz.vectors.col(k);
  const VectorXd left = image_ * y - basis() * (ritz.values[k] * y);
  return std::sqrt(std::max(0.0, left.dot(VectorXd(pencil_.mass(left)))));
}

}  // namespace spoke::vibration
