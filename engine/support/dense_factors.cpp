// The decompositions that steps need: LU factors, and Cholesky factors in place.

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cassert>

#include "engine/support/dense.h"

namespace spoke {

using Eigen::Index;
using Eigen::MatrixXd;
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

}  // namespace spoke
