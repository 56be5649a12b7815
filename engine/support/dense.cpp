// Calls Eigen's class of the same name for each decomposition that steps do without.

#include "engine/support/dense.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <cassert>

namespace spoke {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

struct CholeskyFactor::Factor {
  Eigen::LLT<MatrixXd> llt;
};

CholeskyFactor::CholeskyFactor(const MatrixXd& matrix)
    : factor_(std::make_unique<Factor>(Factor{Eigen::LLT<MatrixXd>(matrix)})) {
  assert(matrix.rows() == matrix.cols());
}
CholeskyFactor::CholeskyFactor(CholeskyFactor&& other) noexcept = default;
CholeskyFactor& CholeskyFactor::operator=(CholeskyFactor&& other) noexcept = default;
CholeskyFactor::~CholeskyFactor() = default;

bool CholeskyFactor::is_positive_definite() const { return factor_->llt.info() == Eigen::Success; }
double CholeskyFactor::rcond() const { return factor_->llt.rcond(); }

MatrixXd CholeskyFactor::solve_lower(const MatrixXd& x) const {
  return factor_->llt.matrixL().solve(x);
}
VectorXd CholeskyFactor::solve_upper(const VectorXd& x) const {
  return factor_->llt.matrixU().solve(x);
}
MatrixXd CholeskyFactor::solve_upper_on_the_right(const MatrixXd& x) const {
  return factor_->llt.matrixU().solve<Eigen::OnTheRight>(x);
}

struct LeastSquares::Factors {
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> cod;
};

LeastSquares::LeastSquares() : factors_(std::make_unique<Factors>()) {}
LeastSquares::~LeastSquares() = default;

void LeastSquares::compute(const MatrixXd& matrix) { factors_->cod.compute(matrix); }
Index LeastSquares::rank() const { return factors_->cod.rank(); }
Index LeastSquares::pivot(Index k) const {
  assert(k >= 0 && k < factors_->cod.cols());
  return factors_->cod.colsPermutation().indices()[k];
}
VectorXd LeastSquares::solve(const VectorXd& right) const { return factors_->cod.solve(right); }

MatrixXd find_orthonormal_basis(const MatrixXd& columns) {
  assert(columns.cols() <= columns.rows());
  const Eigen::HouseholderQR<MatrixXd> factors(columns);
  return factors.householderQ() * MatrixXd::Identity(columns.rows(), columns.cols());
}

RightSingular find_right_singular(const MatrixXd& matrix) {
  const Eigen::JacobiSVD<MatrixXd> parts(matrix, Eigen::ComputeFullV);
  return {parts.singularValues(), parts.matrixV()};
}

SymmetricEigen solve_symmetric(const MatrixXd& matrix) {
  assert(matrix.rows() == matrix.cols());
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(matrix);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

HermitianEigen solve_hermitian(const MatrixXcd& matrix) {
  assert(matrix.rows() == matrix.cols());
  const Eigen::SelfAdjointEigenSolver<MatrixXcd> solver(matrix);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

MatrixXcd HermitianEigen::inverse_square_root() const {
  return vectors * values.cwiseInverse().cwiseSqrt().asDiagonal() * vectors.adjoint();
}

GeneralEigen solve_general(const MatrixXd& matrix) {
  assert(matrix.rows() == matrix.cols());
  const Eigen::EigenSolver<MatrixXd> solver(matrix);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

VectorXcd find_eigenvalues(const MatrixXd& matrix) {
  assert(matrix.rows() == matrix.cols());
  return Eigen::EigenSolver<MatrixXd>(matrix, false).eigenvalues();
}

}  // namespace spoke
