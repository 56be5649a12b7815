#pragma once

// Cholesky factors of sparse matrices, solved with four right-hand sides at a time.

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <functional>

#include "models/solid/assembly.h"

namespace spoke::solid {

/// P K P^T = L L^T with an order P that keeps L sparse.
class Cholesky {
 public:
  /// Called with the number of entries of L before they are computed; may throw.
  using Checker = std::function<void(double)>;

  /// Factorises a symmetric matrix of which the lower triangle is read.
  explicit Cholesky(const Sparse& K, const Checker& checker = {});

  /// Whether K is positive definite, with a margin over round-off.
  bool is_definite() const { return is_definite_; }
  Eigen::Index size() const { return size_; }

  /// Returns K^-1 f, a column each. Precondition: is_definite().
  Eigen::MatrixXd solve(const Eigen::MatrixXd& f) const;

 private:
  /// Eigen's, which tells how many entries L will have.
  struct Factor : Eigen::SimplicialLLT<Sparse, Eigen::Lower, Eigen::AMDOrdering<int>> {
    double count_entries() const;
  };
  Factor factor_;
  Eigen::Index size_ = 0;
  bool is_definite_ = false;
};

}  // namespace spoke::solid
