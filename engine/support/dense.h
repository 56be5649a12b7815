#pragma once

// Decompositions of dense matrices of any size, by Eigen. They are compiled in dense.cpp and,
// those of steps, in dense_factors.cpp only: each takes seconds in every source that names it.

#include <Eigen/Core>
#include <memory>

namespace spoke {

/// LU factors of a square matrix, with partial pivoting.
class LuFactors {
 public:
  /// Factors of a matrix that is given later, by compute().
  LuFactors();
  /// Reserves the memory for a matrix of this size: compute() then allocates no factors.
  explicit LuFactors(Eigen::Index size);
  explicit LuFactors(const Eigen::MatrixXd& matrix);
  LuFactors(LuFactors&& other) noexcept;
  LuFactors& operator=(LuFactors&& other) noexcept;
  ~LuFactors();

  void compute(const Eigen::MatrixXd& matrix);
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;
  /// Solves into existing memory: `solution` has the size of `right`.
  void solve(const Eigen::VectorXd& right, Eigen::VectorXd& solution) const;
  /// Returns the estimated reciprocal condition.
  double rcond() const;
  /// Returns the diagonal of U.
  Eigen::VectorXd pivots() const;

 private:
  struct Factors;
  std::unique_ptr<Factors> factors_;
};

/// The factor L of a symmetric positive definite matrix L L^T, of which the lower triangle is read.
class CholeskyFactor {
 public:
  explicit CholeskyFactor(const Eigen::MatrixXd& matrix);
  CholeskyFactor(CholeskyFactor&& other) noexcept;
  CholeskyFactor& operator=(CholeskyFactor&& other) noexcept;
  ~CholeskyFactor();

  bool is_positive_definite() const;
  /// Returns the estimated reciprocal condition.
  double rcond() const;
  /// Returns L^-1 x.
  Eigen::MatrixXd solve_lower(const Eigen::MatrixXd& x) const;
  /// Returns L^-T x.
  Eigen::VectorXd solve_upper(const Eigen::VectorXd& x) const;
  /// Returns x L^-T.
  Eigen::MatrixXd solve_upper_on_the_right(const Eigen::MatrixXd& x) const;

 private:
  struct Factor;
  std::unique_ptr<Factor> factor_;
};

/// Puts the Cholesky factor L of a symmetric positive definite matrix in the place of its lower
/// triangle.
void factorise_cholesky(Eigen::MatrixXd& matrix) noexcept;
/// Solves L L^T x = right, with L in the lower triangle; x takes the place of the right-hand sides.
void solve_cholesky(const Eigen::MatrixXd& factor, Eigen::MatrixXd& right) noexcept;

/// A complete orthogonal decomposition, for solutions of least squares and least norm.
class LeastSquares {
 public:
  LeastSquares();
  ~LeastSquares();

  void compute(const Eigen::MatrixXd& matrix);
  Eigen::Index rank() const;
  /// Returns the column that came k-th in pivoting; from the rank on they depend on those before.
  Eigen::Index pivot(Eigen::Index k) const;
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  struct Factors;
  std::unique_ptr<Factors> factors_;
};

/// Returns an orthonormal basis of the columns' span, as many as they are, by Householder
/// reflections.
Eigen::MatrixXd find_orthonormal_basis(const Eigen::MatrixXd& columns);

/// Singular values, the largest first, and all their right vectors.
struct RightSingular {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
RightSingular find_right_singular(const Eigen::MatrixXd& matrix);

/// Eigenvalues, the least first, and orthonormal vectors.
struct SymmetricEigen {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
SymmetricEigen solve_symmetric(const Eigen::MatrixXd& matrix);

struct HermitianEigen {
  Eigen::VectorXd values;
  Eigen::MatrixXcd vectors;
  /// Returns A^-1/2 of the matrix A, which must be positive definite.
  Eigen::MatrixXcd inverse_square_root() const;
};
HermitianEigen solve_hermitian(const Eigen::MatrixXcd& matrix);

/// Eigenvalues in no order, and vectors of length one.
struct GeneralEigen {
  Eigen::VectorXcd values;
  Eigen::MatrixXcd vectors;
};
GeneralEigen solve_general(const Eigen::MatrixXd& matrix);
Eigen::VectorXcd find_eigenvalues(const Eigen::MatrixXd& matrix);

}  // namespace spoke
