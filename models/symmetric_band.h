#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <vector>

namespace spoke {

/// A symmetric n x n matrix of half-bandwidth `Half`, stored by diagonals (both triangles), so that
/// a product runs along contiguous memory.
template <int Half>
class SymmetricBand {
 public:
  SymmetricBand() = default;
  explicit SymmetricBand(int n) : n_(n), diagonals_(static_cast<std::size_t>(n) * kWidth, 0.0) {}

  int size() const { return n_; }

  double operator()(int i, int j) const {
    return std::abs(i - j) > Half ? 0.0 : diagonal(j - i)[i];
  }

  /// Adds `value` at (i, j) and, off the diagonal, at (j, i).
  /// Precondition: |i - j| <= Half.
  void add(int i, int j, double value) {
    assert(std::abs(i - j) <= Half);
    diagonal(j - i)[i] += value;
    if (i != j) diagonal(i - j)[j] += value;
  }

  /// this += factor * other.
  void add_scaled(double factor, const SymmetricBand& other) {
    assert(n_ == other.n_);
    for (std::size_t i = 0; i < diagonals_.size(); ++i)
      diagonals_[i] += factor * other.diagonals_[i];
  }

  /// Entries (i, i + offset) by row i; outside the matrix they are zero.
  const double* diagonal(int offset) const { return diagonals_.data() + (offset + Half) * n_; }

  /// Row i of A x. Precondition: x[i - Half] to x[i + Half] can be read and are finite.
  double row(int i, const double* x) const {
    double sum = 0.0;
    for (int k = -Half; k <= Half; ++k) sum += diagonal(k)[i] * x[i + k];
    return sum;
  }

  static constexpr int half() { return Half; }

  Eigen::MatrixXd to_dense() const {
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(n_, n_);
    for (int i = 0; i < n_; ++i)
      for (int j = std::max(0, i - Half); j <= std::min(n_ - 1, i + Half); ++j)
        dense(i, j) = (*this)(i, j);
    return dense;
  }

 private:
  static constexpr int kWidth = 2 * Half + 1;
  double* diagonal(int offset) { return diagonals_.data() + (offset + Half) * n_; }

  int n_ = 0;
  std::vector<double> diagonals_;
};

}  // namespace spoke
