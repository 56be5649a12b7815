// Matrices whose decompositions are known in whole numbers.

#include "engine/support/dense.h"

#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <utility>

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXcd;
using Eigen::VectorXd;

namespace {

MatrixXd make(double a, double b, double c, double d) {
  MatrixXd m(2, 2);
  m << a, b, c, d;
  return m;
}

}  // namespace

TEST_CASE("dense: LU factors solve for vectors and matrices, past a pivot of zero") {
  spoke::LuFactors factors(2);
  factors.compute(make(0.0, 2.0, 4.0, 8.0));
  VectorXd x(2);
  factors.solve(Vector2d(2.0, 12.0), x);
  CHECK(x.isApprox(Vector2d(1.0, 1.0)));
  CHECK(factors.solve(MatrixXd(make(2.0, 4.0, 12.0, 16.0))).isApprox(make(1.0, 0.0, 1.0, 2.0)));
  CHECK(factors.pivots().isApprox(Vector2d(4.0, 2.0)));
  const spoke::LuFactors moved = std::move(factors);
  CHECK(moved.rcond() > 0.01);
  CHECK(spoke::LuFactors(make(1.0, 1.0, 1.0, 1.0)).rcond() < 1e-15);
}

TEST_CASE("dense: Cholesky factors, of their own and in place of the matrix") {
  MatrixXd matrix = make(4.0, 2.0, 2.0, 5.0);  // L = [2 0; 1 2]
  const spoke::CholeskyFactor factor(matrix);
  CHECK(factor.is_positive_definite());
  CHECK(factor.rcond() > 0.1);
  CHECK(factor.solve_lower(Vector2d(2.0, 5.0)).isApprox(Vector2d(1.0, 2.0)));
  CHECK(factor.solve_upper(Vector2d(4.0, 4.0)).isApprox(Vector2d(1.0, 2.0)));
  CHECK(
      factor.solve_upper_on_the_right(make(2.0, 5.0, 0.0, 2.0)).isApprox(make(1.0, 2.0, 0.0, 1.0)));
  CHECK_FALSE(spoke::CholeskyFactor(make(1.0, 2.0, 2.0, 1.0)).is_positive_definite());
  matrix(0, 1) = NAN;  // is not read
  spoke::factorise_cholesky(matrix);
  CHECK(matrix(0, 0) == 2.0);
  CHECK(matrix(1, 0) == 1.0);
  CHECK(matrix(1, 1) == 2.0);
  MatrixXd right = make(8.0, 4.0, 12.0, 2.0);
  spoke::solve_cholesky(matrix, right);
  CHECK(right.isApprox(make(1.0, 1.0, 2.0, 0.0)));
}

TEST_CASE("dense: of many solutions least squares take the shortest") {
  spoke::LeastSquares squares;
  squares.compute(make(1.0, 1.0, 1.0, 1.0));
  CHECK(squares.rank() == 1);
  CHECK(squares.pivot(0) + squares.pivot(1) == 1);
  CHECK(squares.solve(Vector2d(1.0, 3.0)).isApprox(Vector2d(1.0, 1.0)));
}

TEST_CASE("dense: an orthonormal basis spans the columns, singular values are lengths") {
  MatrixXd columns(3, 2);
  columns << 1.0, 2.0, 0.0, 3.0, 0.0, 4.0;
  const MatrixXd basis = spoke::find_orthonormal_basis(columns);
  CHECK((basis.transpose() * basis).isApprox(MatrixXd::Identity(2, 2)));
  CHECK((basis * (basis.transpose() * columns)).isApprox(columns));
  const spoke::RightSingular parts = spoke::find_right_singular(make(0.0, -3.0, 1.0, 0.0));
  CHECK(parts.values.isApprox(Vector2d(3.0, 1.0)));
  CHECK(std::abs(parts.vectors(1, 0)) == doctest::Approx(1.0));
  CHECK(std::abs(parts.vectors(0, 1)) == doctest::Approx(1.0));
}

TEST_CASE("dense: eigenvalues of symmetric, Hermitian and other matrices") {
  const MatrixXd matrix = make(2.0, 1.0, 1.0, 2.0);
  const spoke::SymmetricEigen symmetric = spoke::solve_symmetric(matrix);
  CHECK(symmetric.values.isApprox(Vector2d(1.0, 3.0)));
  CHECK((matrix * symmetric.vectors).isApprox(symmetric.vectors * symmetric.values.asDiagonal()));

  const std::complex<double> i(0.0, 1.0);
  MatrixXcd complex(2, 2);
  complex << 5.0, 4.0 * i, -4.0 * i, 5.0;  // 1 and 9
  const spoke::HermitianEigen hermitian = spoke::solve_hermitian(complex);
  CHECK(hermitian.values.isApprox(Vector2d(1.0, 9.0)));
  const MatrixXcd half = hermitian.inverse_square_root();
  CHECK((half * complex * half).isApprox(MatrixXcd::Identity(2, 2)));

  const MatrixXd turn = make(0.0, -2.0, 2.0, 0.0);
  const spoke::GeneralEigen general = spoke::solve_general(turn);
  CHECK((turn * general.vectors).isApprox(general.vectors * general.values.asDiagonal()));
  CHECK(general.vectors.col(0).norm() == doctest::Approx(1.0));
  const VectorXcd values = spoke::find_eigenvalues(turn);
  CHECK(std::abs(values[0] + values[1]) < 1e-15);
  CHECK(std::abs(values[0] * values[1] - 4.0) < 1e-14);
}
