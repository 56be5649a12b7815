#pragma once

// Matrices of a reduced solid as its kernels read them: columns one after another, padded with
// zeros to a multiple of four rows, and square ones to as many columns.

#include <algorithm>
#include <cassert>
#include <vector>

#include "models/space/solid.h"
#include "models/support/simd.h"

namespace spoke::space {

/// Returns n, rounded up to a multiple of four.
inline int padded_size(int n) { return (n + 3) / 4 * 4; }

/// Copies n values, and zeros behind them up to the stride.
inline void copy_padded(const double* x, int n, int stride, double* padded) {
  assert(stride >= n);
  std::copy_n(x, n, padded);
  std::fill(padded + n, padded + stride, 0.0);
}

/// What the products m_ab q are made of.
struct ReducedProducts {
  explicit ReducedProducts(const ReducedSolid& solid);

  int modes = 0;
  int stride = 0;                 ///< padded_size() of the modes
  std::vector<double> symmetric;  ///< m_xx, m_yy, m_zz
  std::vector<double> mixed;      ///< m_yz, m_xz, m_xy
  std::vector<double> at_rest;    ///< nine vectors h_ba^T, number 3 a + b
  std::vector<double> momentum;   ///< three vectors of C_t

  std::size_t matrix_size() const { return static_cast<std::size_t>(stride * stride); }
};

/// Returns the columns of a square matrix, padded to as many as there are rows then.
std::vector<double> pad_square(const Eigen::MatrixXd& matrix);

/// Returns a.b of padded vectors.
[[gnu::always_inline]] inline double dot_padded(int stride, const double* a, const double* b) {
  Double4 sum{};
  for (int i = 0; i < stride; i += 4) sum += load4(a + i) * load4(b + i);
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

/// The vectors p_ab = Phi_a^T m rho_b and m_ab q' at a state, `stride` values each, number 3 a + b.
/// Of m_ab q' those with a = b are not set.
struct SlotProducts {
  double* p;
  double* m_rate;
};

/// Calculates them; q and v are padded with zeros to the stride.
void multiply_slots(const ReducedProducts& products, const double* q, const double* v,
                    const SlotProducts& result) noexcept;

/// Calculates y = K x of a padded square matrix.
void multiply_symmetric(const double* columns, int stride, const double* x, double* y) noexcept;

}  // namespace spoke::space
