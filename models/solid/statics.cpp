#include "models/solid/statics.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace spoke::solid {
namespace {

/// Returns rigid motions that are orthonormal with M.
Eigen::MatrixXd make_orthonormal(const Sparse& M, Eigen::MatrixXd rigid) {
  for (int pass = 0; pass < 2; ++pass) {
    // Rotations and translations differ in units: scaled first.
    const Eigen::VectorXd norms =
        (rigid.array() * (M * rigid).array()).colwise().sum().sqrt().transpose();
    rigid = rigid * norms.cwiseInverse().asDiagonal();
    const Eigen::MatrixXd product = rigid.transpose() * (M * rigid);
    const Eigen::LLT<Eigen::MatrixXd> llt(product);
    rigid = llt.matrixU().solve<Eigen::OnTheRight>(rigid);
  }
  return rigid;
}

/// Returns the coordinates without six that hold the body well.
std::vector<int> hold_six(const Eigen::MatrixXd& rigid) {
  const Eigen::MatrixXd rows = rigid.transpose();
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(rows);
  std::vector<bool> is_held(static_cast<std::size_t>(rigid.rows()), false);
  for (int k = 0; k < 6; ++k)
    is_held[static_cast<std::size_t>(qr.colsPermutation().indices()[k])] = true;
  std::vector<int> kept;
  for (std::size_t i = 0; i < is_held.size(); ++i)
    if (!is_held[i]) kept.push_back(static_cast<int>(i));
  return kept;
}

/// Returns the rows and columns of a symmetric matrix that are kept, ascending.
Sparse select(const Sparse& K, const std::vector<int>& kept) {
  std::vector<int> place(static_cast<std::size_t>(K.rows()), -1);
  for (std::size_t k = 0; k < kept.size(); ++k)
    place[static_cast<std::size_t>(kept[k])] = static_cast<int>(k);
  const auto size = static_cast<Eigen::Index>(kept.size());
  Sparse result(size, size);
  result.reserve(K.nonZeros());
  for (Eigen::Index j = 0; j < size; ++j) {
    result.startVec(j);
    for (Sparse::InnerIterator entry(K, kept[static_cast<std::size_t>(j)]); entry; ++entry) {
      const int i = place[static_cast<std::size_t>(entry.row())];
      if (i >= 0) result.insertBack(i, j) = entry.value();
    }
  }
  result.finalize();
  return result;
}

}  // namespace

MeanStiffness take_apart(const Sparse& K, const Sparse& Xi, const std::vector<int>& dependent) {
  MeanStiffness parts;
  const auto d = static_cast<Eigen::Index>(dependent.size());
  std::vector<bool> follows(static_cast<std::size_t>(K.rows()), false);
  Sparse chosen(K.rows(), d);
  for (Eigen::Index k = 0; k < d; ++k) {
    const int i = dependent[static_cast<std::size_t>(k)];
    follows[static_cast<std::size_t>(i)] = true;
    chosen.insert(i, k) = 1.0;
  }
  Sparse held = Xi;
  held.prune([&follows](Eigen::Index i, Eigen::Index, double) {
    return !follows[static_cast<std::size_t>(i)];
  });
  const Sparse columns = K * chosen;
  parts.held = project(K, held);
  parts.follows = Sparse(Sparse(Xi.transpose()) * chosen);
  parts.coupling = Sparse(Sparse(held.transpose()) * columns);
  parts.own = Sparse(Sparse(chosen.transpose()) * columns);
  return parts;
}

CorrectedFactor::CorrectedFactor(const MeanStiffness& K, Eigen::Index inner,
                                 const Cholesky::Checker& checker)
    : factor_(Sparse(K.held.topLeftCorner(inner, inner)), checker) {
  if (!is_definite()) return;
  const Eigen::Index d = K.own.rows();
  Eigen::MatrixXd U(inner, 2 * d), complement = Eigen::MatrixXd::Zero(2 * d, 2 * d);
  // Scaled to entries of one size: displacements by forces.
  const double scale = std::sqrt(K.own.diagonal().maxCoeff());
  U << scale * K.follows.topRows(inner), K.coupling.topRows(inner) / scale;
  by_U_ = factor_.solve(U);
  complement.topRightCorner(d, d).setIdentity();
  complement.bottomLeftCorner(d, d).setIdentity();
  complement.bottomRightCorner(d, d) = -K.own / (scale * scale);
  complement_.compute(complement + U.transpose() * by_U_);
}

Eigen::MatrixXd CorrectedFactor::solve(const Eigen::MatrixXd& f) const {
  Eigen::MatrixXd q = factor_.solve(f);
  // U^T A^-1 f is (A^-1 U)^T f.
  if (by_U_.cols() > 0) q.noalias() -= by_U_ * complement_.solve(by_U_.transpose() * f);
  return q;
}

ClampedStatics::ClampedStatics(const Sparse& K, int boundary, const Cholesky::Checker& checker)
    : inner_(Sparse(K.topLeftCorner(K.rows() - boundary, K.rows() - boundary)), checker) {
  find_modes(K, boundary);
}

ClampedStatics::ClampedStatics(const Sparse& K, const MeanStiffness& parts, int boundary,
                               const Cholesky::Checker& checker)
    : inner_(parts, K.rows() - boundary, checker) {
  find_modes(K, boundary);
}

void ClampedStatics::find_modes(const Sparse& K, int boundary) {
  is_definite_ = inner_.is_definite();
  if (!is_definite_) return;
  const Eigen::Index inner = inner_.size();
  const Eigen::MatrixXd right = K.rightCols(boundary);
  modes_.resize(K.rows(), boundary);
  modes_.topRows(inner) = -inner_.solve(right.topRows(inner));
  modes_.bottomRows(boundary).setIdentity();
  if (boundary == 0) return;
  const Eigen::MatrixXd complement = right.transpose() * modes_;
  complement_.compute(0.5 * (complement + complement.transpose()));
  is_definite_ = complement_.info() == Eigen::Success;
}

Eigen::MatrixXd ClampedStatics::solve(const Eigen::MatrixXd& f) const {
  const Eigen::Index inner = inner_.size(), boundary = modes_.cols();
  Eigen::MatrixXd q = Eigen::MatrixXd::Zero(f.rows(), f.cols());
  q.topRows(inner) = inner_.solve(f.topRows(inner));
  if (boundary > 0) q.noalias() += modes_ * complement_.solve(modes_.transpose() * f);
  return q;
}

FreeStatics::FreeStatics(const Sparse& K, const Sparse& M, const Eigen::MatrixXd& rigid,
                         const Cholesky::Checker& checker)
    : rigid_(make_orthonormal(M, rigid)),
      M_rigid_(M * rigid_),
      kept_(hold_six(rigid_)),
      held_(select(K, kept_), checker) {}

Eigen::MatrixXd FreeStatics::solve(const Eigen::MatrixXd& f) const {
  const Eigen::MatrixXd load = f - M_rigid_ * (rigid_.transpose() * f);
  const auto size = static_cast<Eigen::Index>(kept_.size());
  Eigen::MatrixXd held(size, f.cols());
  for (Eigen::Index k = 0; k < size; ++k)
    held.row(k) = load.row(kept_[static_cast<std::size_t>(k)]);
  held = held_.solve(held);
  Eigen::MatrixXd q = Eigen::MatrixXd::Zero(f.rows(), f.cols());
  for (Eigen::Index k = 0; k < size; ++k) q.row(kept_[static_cast<std::size_t>(k)]) = held.row(k);
  for (int pass = 0; pass < 2; ++pass) q -= rigid_ * (M_rigid_.transpose() * q);
  return q;
}

}  // namespace spoke::solid
