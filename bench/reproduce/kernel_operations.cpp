// Closed forms of the operations of dense and banded kernels.

#include "bench/reproduce/kernel_operations.h"

#include <algorithm>
#include <cassert>

namespace spoke::reproduce {
namespace {

/// Returns the number of entries below the diagonal of a band.
std::int64_t lower_entries(std::int64_t n, std::int64_t half) {
  const std::int64_t width = std::min(half, n - 1);
  return n * width - width * (width + 1) / 2;
}

}  // namespace

Operations operator+(const Operations& a, const Operations& b) {
  return {a.multiplications + b.multiplications, a.additions + b.additions, a.others + b.others};
}

Operations operator*(std::int64_t times, const Operations& a) {
  return {times * a.multiplications, times * a.additions, times * a.others};
}

Operations cholesky(std::int64_t n) {
  const std::int64_t pairs = (n * n * n - n) / 6;  // sum of j (n - j) over the columns j
  return {pairs, pairs, n + n * (n - 1) / 2};
}

Operations cholesky_solve(std::int64_t n, std::int64_t k) {
  return k * Operations{n * (n - 1), n * (n - 1), 2 * n};
}

Operations lu(std::int64_t n) {
  const std::int64_t pairs = (n - 1) * n * (2 * n - 1) / 6;  // sum of squares below n
  return {pairs, pairs, n * (n - 1) / 2};
}

Operations lu_solve(std::int64_t n, std::int64_t k) {
  return k * Operations{n * (n - 1), n * (n - 1), n};
}

Operations product(std::int64_t m, std::int64_t n, std::int64_t k) {
  return {m * n * k, m * (n - 1) * k, 0};
}

Operations dot(std::int64_t n) { return product(1, n, 1); }

Operations band_product(std::int64_t n, std::int64_t half) {
  assert(n >= 0 && half >= 0);
  const std::int64_t entries = n + 2 * lower_entries(n, half);
  return {entries, entries - n, 0};
}

Operations band_solve(std::int64_t n, std::int64_t half) {
  assert(n >= 0 && half >= 0);
  const std::int64_t entries = 2 * lower_entries(n, half);
  return {entries + n, entries, 0};
}

Operations twist_inverse() { return {21, 8, 1}; }
Operations twist_turn() { return {15, 9, 0}; }
Operations twist_eliminate() { return {45, 36, 0}; }
Operations rotate() { return {4, 2, 0}; }

}  // namespace spoke::reproduce
