// Factorises panels of four columns, each less the products of all columns before it.

#include "models/air/lower_factor.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "models/support/simd.h"
#include "models/support/wide_kernels.h"

namespace spoke::air {
namespace {

constexpr std::size_t kPanel = 4;  // columns

/// Subtracts from four rows of a panel what the columns before it make of them.
[[gnu::always_inline]] inline void subtract_before(double* entries, std::size_t stride,
                                                   std::size_t row, std::size_t panel) noexcept {
  Double4 sum[kPanel];
  for (std::size_t c = 0; c < kPanel; ++c) sum[c] = load4(entries + (panel + c) * stride + row);
  for (std::size_t k = 0; k < panel; ++k) {
    const double* column = entries + k * stride;
    const Double4 rows = load4(column + row);
    for (std::size_t c = 0; c < kPanel; ++c) sum[c] -= rows * column[panel + c];
  }
  for (std::size_t c = 0; c < kPanel; ++c) store(sum[c], entries + (panel + c) * stride + row);
}

/// Factorises the columns of a panel, from which all before it are subtracted. `columns`: four, or
/// what is left of the matrix.
[[gnu::always_inline]] inline bool factorise_panel(double* entries, std::size_t stride,
                                                   std::size_t rows, std::size_t panel,
                                                   std::size_t columns) noexcept {
  for (std::size_t c = 0; c < columns; ++c) {
    double* own = entries + (panel + c) * stride;
    for (std::size_t before = 0; before < c; ++before) {
      const double* other = entries + (panel + before) * stride;
      const double factor = other[panel + c];
      for (std::size_t row = panel; row < rows; row += 4)
        store(load4(own + row) - load4(other + row) * factor, own + row);
    }
    const double pivot = own[panel + c];
    if (!(pivot > 0.0)) return false;
    const double inverse = 1.0 / std::sqrt(pivot);
    for (std::size_t row = panel; row < rows; row += 4)
      store(load4(own + row) * inverse, own + row);
    std::fill(own + panel, own + panel + c, 0.0);
  }
  return true;
}

[[gnu::always_inline]] inline bool factorise_all(double* entries, std::size_t size,
                                                 std::size_t stride) noexcept {
  const std::size_t rows = round_up_to_four(size);
  for (std::size_t panel = 0; panel < size; panel += kPanel) {
    for (std::size_t row = panel; row < rows; row += 4)
      subtract_before(entries, stride, row, panel);
    const std::size_t columns = std::min(kPanel, size - panel);
    if (!factorise_panel(entries, stride, rows, panel, columns)) return false;
  }
  return true;
}

[[gnu::always_inline]] inline void multiply_all(const double* entries, std::size_t size,
                                                std::size_t stride, const std::complex<double>* x,
                                                std::complex<double>* y) noexcept {
  for (std::size_t row = 0; row < size; row += 4) {
    Double4 re{}, im{};
    const std::size_t columns = std::min(row + 4, size);
    for (std::size_t k = 0; k < columns; ++k) {
      const Double4 rows = load4(entries + k * stride + row);
      re += rows * x[k].real();
      im += rows * x[k].imag();
    }
    for (std::size_t i = 0; i < columns - row; ++i) y[row + i] = {re[i], im[i]};
  }
}

}  // namespace

// The last panel may have columns beyond the matrix, which stay 0.
LowerFactor::LowerFactor(std::size_t size)
    : size_(size),
      stride_(round_up_to_four(size + 3)),
      entries_(round_up_to_four(size) * stride_) {}

bool LowerFactor::factorise() noexcept {
  return run_large_kernel(
      [&]() noexcept { return factorise_all(entries_.data(), size_, stride_); });
}

void LowerFactor::multiply(std::span<const std::complex<double>> x,
                           std::span<std::complex<double>> y) const noexcept {
  assert(x.size() == size_ && y.size() == size_);
  run_large_kernel(
      [&]() noexcept { multiply_all(entries_.data(), size_, stride_, x.data(), y.data()); });
}

}  // namespace spoke::air
