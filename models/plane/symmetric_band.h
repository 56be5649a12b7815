#pragma once

// Symmetric band matrices, stored for products by vector instructions.

#include <Eigen/Core>
#include <algorithm>
#include <cassert>
#include <cstdlib>

namespace spoke::plane {

/// A symmetric n x n matrix of half-bandwidth `Half`. Full rows are stored, two at a time side by
/// side (rows 2 k and 2 k + 1), so that a product takes both in one vector register and runs along
/// contiguous, 16-byte aligned memory. An odd last row has a partner of zeros.
template <int Half>
class SymmetricBand {
 public:
  static constexpr int kWidth = 2 * Half + 1;

  SymmetricBand() = default;
  explicit SymmetricBand(int n)
      : n_(n), pairs_(Eigen::VectorXd::Zero(Eigen::Index{(n + 1) / 2} * 2 * kWidth)) {}

  int size() const { return n_; }

  double operator()(int i, int j) const {
    return std::abs(i - j) > Half ? 0.0 : pairs_[place(i, j)];
  }

  /// Adds `value` at (i, j) and, off the diagonal, at (j, i).
  /// Precondition: |i - j| <= Half.
  void add(int i, int j, double value) {
    assert(std::abs(i - j) <= Half);
    pairs_[place(i, j)] += value;
    if (i != j) pairs_[place(j, i)] += value;
  }

  /// this += factor * other.
  void add_scaled(double factor, const SymmetricBand& other) {
    assert(n_ == other.n_);
    pairs_ += factor * other.pairs_;
  }

  /// Returns row i of A x. Precondition: x[i - Half] to x[i + Half] can be read and are finite.
  double row(int i, const double* x) const {
    assert(i >= 0 && i < n_);
    double sum = 0.0;
    for (int k = -Half; k <= Half; ++k) sum += pairs_[place(i, i + k)] * x[i + k];
    return sum;
  }

  /// Returns the entries of rows 0 and 1 as kWidth pairs, for columns i - Half to i + Half of row
  /// i. The entries of rows 2 k and 2 k + 1 follow k times 2 kWidth further on.
  const double* pairs() const { return pairs_.data(); }

  Eigen::MatrixXd to_dense() const {
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(n_, n_);
    for (int i = 0; i < n_; ++i)
      for (int j = std::max(0, i - Half); j <= std::min(n_ - 1, i + Half); ++j)
        dense(i, j) = (*this)(i, j);
    return dense;
  }

 private:
  static Eigen::Index place(int i, int j) {
    return (Eigen::Index{i / 2} * kWidth + (j - i + Half)) * 2 + i % 2;
  }

  int n_ = 0;
  Eigen::VectorXd pairs_;
};

}  // namespace spoke::plane
