// Calls Eigen's class of the same name for each decomposition.

#include "engine/support/dense.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <cassert>

namespace spoke {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

struct LuFactors::Factors {
  Eigen::PartialPivLU<MatrixXd> lu;
};

LuFactors::LuFactors() : factors_(std::make_unique<Factors>()) {}
LuFactors::LuFactors(Index size)
    : factors_(std::make_unique<Factors>(Factors{Eigen::PartialPivLU<MatrixXd>(size)})) {}
LuFactors::LuFactors(const MatrixXd& matrix) : LuFactors() { compute(matrix); }
LuFactors::LuFactors(LuFactors&& other) noexcept = default;
LuFactors& LuFactors::operator=(LuFactors&& other) noexcept = default;
LuFactors::~LuFactors() = default;

void LuFactors::compute(const MatrixXd& matrix) {
  assert(matrix.rows() == matrix.cols());
  factors_->lu.compute(matrix);
}

MatrixXd LuFactors::solve(const MatrixXd& right) const { return factors_->lu.solve(right); }

void LuFactors::solve(const VectorXd& right, VectorXd& solution) const {
  assert(solution.size() == right.size());
  solution.noalias() = factors_->lu.solve(right);
}

double LuFactors::rcond() const { return factors_->lu.rcond(); }

VectorXd LuFactors::pivots() const { return factors_->lu.matrixLU().diagonal(); }

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

void factorise_cholesky(MatrixXd& matrix) noexcept {
  assert(matrix.rows() == matrix.cols());
  Eigen::Ref<MatrixXd> place(matrix);
  const Eigen::LLT<Eigen::Ref<MatrixXd>> in_place(place);
}

void solve_cholesky(const MatrixXd& factor, MatrixXd& right) noexcept {
  assert(factor.rows() == right.rows());
  factor.triangularView<Eigen::Lower>().solveInPlace(right);
  factor.adjoint().triangularView<Eigen::Upper>().solveInPlace(right);
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
