#include "models/solid/reduction.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace spoke::solid {
namespace {

/// A shape of which less than this part is not in the span of those before is left out: it is
/// round-off, or would be mostly.
constexpr double kDependent = 1e-10;

/// Columns that are orthonormal with M, to which more are added.
class OrthonormalColumns {
 public:
  OrthonormalColumns(const Sparse& M, const Eigen::MatrixXd& rigid)
      : M_(M), rigid_(rigid), M_rigid_(M * rigid) {}

  void add(const Eigen::MatrixXd& columns) {
    const Eigen::Index most = std::min(size_ + columns.cols(), M_.rows() - rigid_.cols());
    Q_.conservativeResize(M_.rows(), most);
    MQ_.conservativeResize(M_.rows(), most);
    for (Eigen::Index c = 0; c < columns.cols() && size_ < most; ++c) add_column(columns.col(c));
    Q_.conservativeResize(M_.rows(), size_);
    MQ_.conservativeResize(M_.rows(), size_);
  }
  const Eigen::MatrixXd& columns() const { return Q_; }

 private:
  void add_column(const Eigen::VectorXd& column) {
    Eigen::MatrixXd x = column;
    double before = std::sqrt(x.col(0).dot(M_ * x.col(0)));
    double least = kDependent;
    for (int pass = 0; pass < 3; ++pass) {
      if (rigid_.cols() > 0) remove_parts(rigid_, M_rigid_, x);
      x -= Q_.leftCols(size_) * (MQ_.leftCols(size_).transpose() * x);
      const double length = std::sqrt(std::max(0.0, x.col(0).dot(M_ * x.col(0))));
      if (!(length > least * before)) return;
      x /= length;
      before = 1.0;
      least = 0.1;  // what is left is the column's own
    }
    Q_.col(size_) = x;
    MQ_.col(size_) = M_ * x;
    ++size_;
  }

  const Sparse& M_;
  const Eigen::MatrixXd& rigid_;
  Eigen::MatrixXd M_rigid_, Q_, MQ_;
  Eigen::Index size_ = 0;
};

/// Turns orthonormal columns so that K is diagonal.
ReducedBasis make_diagonal(const Sparse& K, const Eigen::MatrixXd& Q,
                           const Eigen::VectorXd& vibration) {
  const Eigen::MatrixXd product = Q.transpose() * (K * Q);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(
      Eigen::MatrixXd(0.5 * (product + product.transpose())));
  ReducedBasis basis{Q * eigen.eigenvectors(), eigen.eigenvalues(), vibration};
  fix_signs(basis.T);
  return basis;
}

}  // namespace

ReducedBasis reduce(const Sparse& M, const Sparse& K, const ClampedStatics& statics,
                    const Eigen::MatrixXd& attached, const ModeChoice& choice,
                    const PartDone& done) {
  const Eigen::Index inner = M.rows() - statics.constraint_modes().cols();
  const Sparse M_inner = M.topLeftCorner(inner, inner);
  const Eigen::MatrixXd none(inner, 0), no_rigid(M.rows(), 0);
  const VibrationModes modes = find_modes(
      M_inner, [&](const Eigen::MatrixXd& f) { return statics.solve_inner(f); }, none, choice,
      done);
  const auto extend = [&](const Eigen::MatrixXd& shapes) {
    Eigen::MatrixXd extended = Eigen::MatrixXd::Zero(M.rows(), shapes.cols());
    extended.topRows(inner) = shapes;
    return extended;
  };
  OrthonormalColumns columns(M, no_rigid);
  columns.add(extend(modes.shapes));
  columns.add(statics.constraint_modes());
  columns.add(extend(statics.solve_inner(attached.topRows(inner))));
  return make_diagonal(K, columns.columns(), modes.squares);
}

ReducedBasis reduce(const Sparse& M, const Sparse& K, const FreeStatics& statics,
                    const Eigen::MatrixXd& attached, const ModeChoice& choice,
                    const PartDone& done) {
  const VibrationModes modes = find_modes(
      M, [&](const Eigen::MatrixXd& f) { return statics.solve(f); }, statics.rigid(), choice, done);
  OrthonormalColumns columns(M, statics.rigid());
  columns.add(modes.shapes);
  columns.add(statics.solve(attached));
  return make_diagonal(K, columns.columns(), modes.squares);
}

}  // namespace spoke::solid
