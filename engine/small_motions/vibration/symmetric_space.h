#pragma once

// The space of a block Lanczos iteration for a symmetric pencil.

#include <Eigen/Core>
#include <random>

#include "engine/small_motions/vibration/pencil.h"
#include "engine/support/dense.h"

namespace spoke::vibration {

/// The space that the inverse B = (K + shift^2 M)^-1 M of a symmetric pencil spans from random
/// vectors on, the same each time, with a basis that is orthonormal by mass: there B is symmetric,
/// whether the stiffness is positive or not. The space is orthogonal to motions that are known, so
/// that B is as small in it as what is left.
class SymmetricSpace {
 public:
  /// Makes an empty space. `known`: motions that B leaves in their span. `width`: of a block.
  SymmetricSpace(const Pencil& pencil, double shift, const Eigen::MatrixXd& known,
                 Eigen::Index width);

  Eigen::Index size() const { return basis_.cols() - known_; }
  bool is_all() const { return basis_.cols() == basis_.rows(); }
  auto basis() const { return basis_.rightCols(size()); }

  /// Adds a block: the image of the last one.
  void grow();

  struct Pairs {
    SymmetricEigen ritz;     ///< of B in the space, vectors in its basis
    double round_off = 0.0;  ///< by which B is not symmetric
  };
  Pairs find_pairs() const;
  /// Returns the remainder B x - value x of a pair, by mass: x has unit mass.
  double find_remainder(const SymmetricEigen& ritz, Eigen::Index k) const;

 private:
  void add(Eigen::VectorXd column);

  const Pencil& pencil_;
  PencilFactor factor_;
  Eigen::Index width_;
  Eigen::Index known_ = 0;
  std::mt19937 dice_{1};
  Eigen::MatrixXd basis_, momentum_;  ///< known motions first; M times them
  Eigen::MatrixXd image_;             ///< B times the basis of the space
};

}  // namespace spoke::vibration
