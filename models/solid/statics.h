#pragma once

// Static solutions K q = f: of a body that its frame holds, and of one that flies by itself.

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>
#include <vector>

#include "models/solid/cholesky.h"

namespace spoke::solid {

/// A stiffness six of whose displacements d follow from many others by a mean, u_d = F q: K = K_00
/// + F^T K_d0 + K_0d F + F^T K_dd F. K itself couples all that these follow from with one another.
struct MeanStiffness {
  Sparse held;               ///< K_00, while the six stand still
  Eigen::MatrixXd follows;   ///< F^T
  Eigen::MatrixXd coupling;  ///< K_0d
  Eigen::MatrixXd own;       ///< K_dd
};

/// Returns the parts of Xi^T K Xi where displacements follow from others by rows of Xi.
MeanStiffness take_apart(const Sparse& K, const Sparse& Xi, const std::vector<int>& dependent);

/// A factorised stiffness, of low rank beside one that is sparse: K = A + U S U^T with U = [F^T,
/// K_0d] and S = [K_dd, 1; 1, 0], solved by the inverse of A (Woodbury).
class CorrectedFactor {
 public:
  CorrectedFactor(const Sparse& K, const Cholesky::Checker& checker) : factor_(K, checker) {}
  /// Takes the first `inner` coordinates.
  CorrectedFactor(const MeanStiffness& K, Eigen::Index inner, const Cholesky::Checker& checker);

  bool is_definite() const { return factor_.is_definite(); }
  Eigen::Index size() const { return factor_.size(); }
  /// K^-1 f.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& f) const;

 private:
  Cholesky factor_;
  Eigen::MatrixXd by_U_;                             ///< A^-1 U
  Eigen::PartialPivLU<Eigen::MatrixXd> complement_;  ///< S^-1 + U^T A^-1 U
};

/// Of a body that is held: inner coordinates first, then those of rigid interfaces. Only the inner
/// ones are factorised; the others follow from Schur's complement.
class ClampedStatics {
 public:
  ClampedStatics(const Sparse& K, int boundary, const Cholesky::Checker& checker);
  /// `parts`: those of which K consists.
  ClampedStatics(const Sparse& K, const MeanStiffness& parts, int boundary,
                 const Cholesky::Checker& checker);

  /// Whether K is positive definite.
  bool is_definite() const { return is_definite_; }
  /// K_ii^-1 f.
  Eigen::MatrixXd solve_inner(const Eigen::MatrixXd& f) const { return inner_.solve(f); }
  /// K^-1 f.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& f) const;
  /// The displacements under unit displacements of the boundary: [- K_ii^-1 K_ib; 1].
  const Eigen::MatrixXd& constraint_modes() const { return modes_; }

 private:
  void find_modes(const Sparse& K, int boundary);

  CorrectedFactor inner_;
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
