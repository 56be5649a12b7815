#pragma once

// Series in time from their Fourier coefficients, eight at a time.

#include <array>
#include <complex>
#include <cstddef>
#include <vector>

#include "models/support/simd.h"

namespace spoke::air {

/// Eight real series of one length. Before the transform: at k the Fourier coefficients of the
/// first four plus i times those of the last four; after it, at t the values of all eight.
struct EightSeries {
  static constexpr std::size_t kCount = 8;
  /// Real parts or the first four values; imaginary parts or the last four. Where not all
  /// processors have vectors of four, GCC gives memory the alignment of two, and kernels take it to
  /// be of four.
  struct alignas(sizeof(Double4)) Place {
    Double4 first, last;
  };

  std::vector<Place> places;

  explicit EightSeries(std::size_t length) : places(length, Place{}) {}

  /// Sets the coefficients of all eight at frequency k, 0 < k < length/2, and at length - k, where
  /// they are conjugate.
  void set(std::size_t k, const std::array<std::complex<double>, kCount>& coefficients);
  double value(std::size_t t, std::size_t series) const {
    const Place& place = places[t];
    return series < 4 ? place.first[series] : place.last[series - 4];
  }
};

/// Transforms x_k to sum over k of x_k e^(2 pi i k t/n), by factors of n one after the other
/// (Stockham's order, Van Loan 1992, section 1.7).
class InverseFourier {
 public:
  /// length: a product of 2, 3 and 5.
  explicit InverseFourier(std::size_t length);

  /// Transforms in place.
  void transform(EightSeries& series);

 private:
  std::vector<std::size_t> factors_;
  std::vector<std::complex<double>> roots_;  ///< e^(2 pi i j/n)
  EightSeries other_;
};

}  // namespace spoke::air
