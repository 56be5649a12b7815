#pragma once

// Cholesky factors of dense matrices of some ten or hundred rows.

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace spoke::air {

inline std::size_t round_up_to_four(std::size_t count) { return (count + 3) / 4 * 4; }

/// A symmetric positive definite matrix, which becomes its Cholesky factor in place. Columns are
/// stored one after the other, each a multiple of four doubles long.
class LowerFactor {
 public:
  /// Makes room for a matrix. Its entries are 0.
  explicit LowerFactor(std::size_t size);

  std::size_t size() const { return size_; }
  /// Returns a column: `size` values, and room for three more, which are to stay 0.
  double* column(std::size_t index) { return entries_.data() + index * stride_; }

  /// Factorises the matrix, of which the lower triangle is read. Returns false if it is not
  /// positive definite.
  bool factorise() noexcept;
  /// Sets y to the factor times x. Precondition: factorised; both have its size.
  void multiply(std::span<const std::complex<double>> x,
                std::span<std::complex<double>> y) const noexcept;

 private:
  std::size_t size_, stride_;
  std::vector<double> entries_;
};

}  // namespace spoke::air
