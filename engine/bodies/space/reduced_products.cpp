// Multiplies by columns, four rows at a time.

#include "engine/bodies/space/reduced_products.h"

#include <algorithm>
#include <cassert>

#include "models/support/simd.h"
#include "models/support/wide_kernels.h"

namespace spoke::space {
namespace {

/// The axes a, b of the mixed matrices, as their numbers 3 a + b and 3 b + a.
constexpr int kMixed[3][2] = {{5, 7}, {2, 6}, {1, 3}};

/// Adds M q to `y`, M v to `y_rate`; adds M^T q to `z`, sets M^T v. Two columns at a time.
[[gnu::always_inline]] inline void multiply_both(const double* columns, int stride, const double* q,
                                                 const double* v, double* y, double* y_rate,
                                                 double* z, double* z_rate) {
  const auto total4 = [](const Double4& x) { return (x[0] + x[1]) + (x[2] + x[3]); };
  for (int j = 0; j < stride; j += 2, columns += 2 * stride) {
    Double4 sums[2]{}, rates[2]{};
    for (int i = 0; i < stride; i += 4) {
      const Double4 c0 = load4(columns + i), c1 = load4(columns + stride + i);
      const Double4 q_i = load4(q + i), v_i = load4(v + i);
      store(load4(y + i) + q[j] * c0 + q[j + 1] * c1, y + i);
      store(load4(y_rate + i) + v[j] * c0 + v[j + 1] * c1, y_rate + i);
      sums[0] += c0 * q_i;
      sums[1] += c1 * q_i;
      rates[0] += c0 * v_i;
      rates[1] += c1 * v_i;
    }
    for (int k = 0; k < 2; ++k) {
      z[j + k] += total4(sums[k]);
      z_rate[j + k] = total4(rates[k]);
    }
  }
}

/// Adds K x to y, four columns at a time.
[[gnu::always_inline]] inline void add_product(const double* columns, int stride, const double* x,
                                               double* y) {
  for (int j = 0; j < stride; j += 4, columns += 4 * stride)
    for (int i = 0; i < stride; i += 4) {
      const double* c = columns + i;
      store(load4(y + i) + (x[j] * load4(c) + x[j + 1] * load4(c + stride)) +
                (x[j + 2] * load4(c + 2 * stride) + x[j + 3] * load4(c + 3 * stride)),
            y + i);
    }
}

/// Returns the columns of a matrix with zeros behind each.
std::vector<double> pad_columns(const Eigen::MatrixXd& matrix) {
  const auto stride = static_cast<std::size_t>(padded_size(static_cast<int>(matrix.rows())));
  std::vector<double> columns(stride * static_cast<std::size_t>(matrix.cols()), 0.0);
  for (Eigen::Index j = 0; j < matrix.cols(); ++j)
    std::copy_n(matrix.col(j).data(), matrix.rows(),
                columns.data() + static_cast<std::size_t>(j) * stride);
  return columns;
}

}  // namespace

std::vector<double> pad_square(const Eigen::MatrixXd& matrix) {
  assert(matrix.rows() == matrix.cols());
  std::vector<double> columns = pad_columns(matrix);
  const auto stride = static_cast<std::size_t>(padded_size(static_cast<int>(matrix.rows())));
  columns.resize(stride * stride, 0.0);
  return columns;
}

ReducedProducts::ReducedProducts(const ReducedSolid& solid)
    : modes(static_cast<int>(solid.stiffness.size())),
      stride(padded_size(modes)),
      momentum(pad_columns(solid.C_t)) {
  const auto append = [](std::vector<double>& all, const std::vector<double>& columns) {
    all.insert(all.end(), columns.begin(), columns.end());
  };
  for (const std::size_t a : {0, 4, 8}) append(symmetric, pad_square(solid.m[a]));
  for (const auto& pair : kMixed)
    append(mixed, pad_square(solid.m[static_cast<std::size_t>(pair[0])]));
  for (const Eigen::VectorXd& h : solid.h) append(at_rest, pad_columns(h));
}

namespace {

// The matrix of the axes b, a is the transpose of that of a, b: one pass over the columns yields
// the products of both.
void multiply_all(const ReducedProducts& products, const double* q, const double* v,
                  const SlotProducts& result) {
  const int stride = products.stride;
  std::copy(products.at_rest.begin(), products.at_rest.end(), result.p);
  std::fill_n(result.m_rate, 9 * stride, 0.0);
  const double* columns = products.symmetric.data();
  for (const int a : {0, 4, 8}) {
    add_product(columns, stride, q, result.p + a * stride);
    columns += products.matrix_size();
  }
  columns = products.mixed.data();
  for (const auto& [ab, ba] : kMixed) {
    multiply_both(columns, stride, q, v, result.p + ab * stride, result.m_rate + ab * stride,
                  result.p + ba * stride, result.m_rate + ba * stride);
    columns += products.matrix_size();
  }
}

}  // namespace

void multiply_slots(const ReducedProducts& products, const double* q, const double* v,
                    const SlotProducts& result) noexcept {
  run_large_kernel([&]() noexcept { multiply_all(products, q, v, result); });
}

void multiply_symmetric(const double* columns, int stride, const double* x, double* y) noexcept {
  assert(stride % 4 == 0);
  std::fill_n(y, stride, 0.0);
  run_large_kernel([&]() noexcept { add_product(columns, stride, x, y); });
}

}  // namespace spoke::space
