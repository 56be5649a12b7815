#pragma once

// Static solutions K q = f: of a body that its frame holds, and of one that flies by itself.

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <vector>

#include "models/solid/cholesky.h"

namespace spoke::solid {

/// Of a body that is held: inner coordinates first, then those of rigid interfaces. Only the inner
/// ones are factorised; the others follow from Schur's complement.
class ClampedStatics {
 public:
  ClampedStatics(const Sparse& K, int boundary, const Cholesky::Checker& checker);

  /// Whether K is positive definite.
  bool is_definite() const { return is_definite_; }
  /// K_ii^-1 f.
  Eigen::MatrixXd solve_inner(const Eigen::MatrixXd& f) const { return inner_.solve(f); }
  /// K^-1 f.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& f) const;
  /// The displacements under unit displacements of the boundary: [- K_ii^-1 K_ib; 1].
  const Eigen::MatrixXd& constraint_modes() const { return modes_; }

 private:
  Cholesky inner_;
  Eigen::MatrixXd modes_;
  Eigen::LLT<Eigen::MatrixXd> complement_;
  bool is_definite_ = false;
};

/// Of a body that nothing holds, under loads made self-equilibrated by the accelerations of a rigid
/// body: f - M R R^T f with rigid motions R, orthonormal with M.
class FreeStatics {
 public:
  FreeStatics(const Sparse& K, const Sparse& M, const Eigen::MatrixXd& rigid,
              const Cholesky::Checker& checker);

  bool is_definite() const { return held_.is_definite(); }
  /// Rigid motions, orthonormal with M.
  const Eigen::MatrixXd& rigid() const { return rigid_; }
  /// The displacements without rigid motion.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& f) const;

 private:
  Eigen::MatrixXd rigid_, M_rigid_;
  std::vector<int> kept_;  ///< coordinates that are not held while K is solved
  Cholesky held_;
};

}  // namespace spoke::solid
