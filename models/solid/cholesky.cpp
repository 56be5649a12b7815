#include "models/solid/cholesky.h"

#include <cassert>

namespace spoke::solid {
namespace {

/// Right-hand sides that are solved in one pass over L.
constexpr int kLanes = 4;
using Lanes = Eigen::Matrix<double, Eigen::Dynamic, kLanes, Eigen::RowMajor>;
using LaneRow = Eigen::Matrix<double, 1, kLanes>;

/// x := L^-T L^-1 x.
void solve_lanes(const Sparse& L, Lanes& x) {
  const int* outer = L.outerIndexPtr();
  const int* inner = L.innerIndexPtr();
  const double* values = L.valuePtr();
  for (Eigen::Index j = 0; j < L.cols(); ++j) {
    const LaneRow y = x.row(j) / values[outer[j]];  // the diagonal is first
    x.row(j) = y;
    for (int k = outer[j] + 1; k < outer[j + 1]; ++k) x.row(inner[k]) -= values[k] * y;
  }
  for (Eigen::Index j = L.cols() - 1; j >= 0; --j) {
    LaneRow y = x.row(j);
    for (int k = outer[j] + 1; k < outer[j + 1]; ++k) y -= values[k] * x.row(inner[k]);
    x.row(j) = y / values[outer[j]];
  }
}

/// A pivot below this part of its diagonal entry is round-off.
constexpr double kLeastPivot = 1e-13;

}  // namespace

double Cholesky::Factor::count_entries() const {
  return this->m_nonZerosPerCol.template cast<double>().sum() + static_cast<double>(this->cols());
}

Cholesky::Cholesky(const Sparse& K, const Checker& checker) : size_(K.rows()) {
  if (size_ == 0) {
    is_definite_ = true;
    return;
  }
  factor_.analyzePattern(K);
  if (checker) checker(factor_.count_entries());
  factor_.factorize(K);
  is_definite_ = factor_.info() == Eigen::Success;
  if (!is_definite_) return;
  const Sparse& L = factor_.matrixL().nestedExpression();
  const Eigen::VectorXd diagonal = factor_.permutationP() * Eigen::VectorXd(K.diagonal());
  for (Eigen::Index j = 0; j < size_; ++j) {
    const double pivot = L.valuePtr()[L.outerIndexPtr()[j]];
    if (!(pivot * pivot > kLeastPivot * diagonal[j])) is_definite_ = false;
  }
}

Eigen::MatrixXd Cholesky::solve(const Eigen::MatrixXd& f) const {
  assert(is_definite_ && f.rows() == size_);
  Eigen::MatrixXd result(f.rows(), f.cols());
  if (size_ == 0) return result;
  const Sparse& L = factor_.matrixL().nestedExpression();
  Lanes x(size_, kLanes);
  for (Eigen::Index first = 0; first < f.cols(); first += kLanes) {
    const Eigen::Index count = std::min<Eigen::Index>(kLanes, f.cols() - first);
    x.setZero();
    x.leftCols(count) = factor_.permutationP() * f.middleCols(first, count);
    solve_lanes(L, x);
    result.middleCols(first, count) = factor_.permutationPinv() * x.leftCols(count);
  }
  return result;
}

}  // namespace spoke::solid
