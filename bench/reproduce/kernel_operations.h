#pragma once

// Operations of dense and banded kernels, in closed form. All operations on numbers that the kernel
// needs are counted; changes of sign, copies and the zeros that fill up vector registers are not.

#include <cstdint>

namespace spoke::reproduce {

struct Operations {
  std::int64_t multiplications = 0;
  std::int64_t additions = 0;  ///< additions and subtractions
  std::int64_t others = 0;     ///< divisions, square roots, sines and cosines, one each

  std::int64_t total() const { return multiplications + additions + others; }
  friend bool operator==(const Operations&, const Operations&) = default;
};
Operations operator+(const Operations& a, const Operations& b);
Operations operator*(std::int64_t times, const Operations& a);

/// A = L L^T of an n x n matrix.
Operations cholesky(std::int64_t n);
/// L L^T X = B with k columns.
Operations cholesky_solve(std::int64_t n, std::int64_t k);
/// P A = L U of an n x n matrix; the search for pivots is not counted.
Operations lu(std::int64_t n);
/// L U X = B with k columns.
Operations lu_solve(std::int64_t n, std::int64_t k);
/// (m x n) (n x k).
Operations product(std::int64_t m, std::int64_t n, std::int64_t k);
/// x . y
Operations dot(std::int64_t n);
/// A x, A symmetric with `half` diagonals on either side.
Operations band_product(std::int64_t n, std::int64_t half);
/// L D L^T x = b for a factorised band matrix, with the inverse of D.
Operations band_solve(std::int64_t n, std::int64_t half);

// Symmetric twist matrices of the plane (3 x 3), as in models/plane/plane.h.
Operations twist_inverse();    ///< invert()
Operations twist_turn();       ///< rotate() of a matrix
Operations twist_eliminate();  ///< eliminate()
Operations rotate();           ///< rotate() of a twist

}  // namespace spoke::reproduce
