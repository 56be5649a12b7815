// Cholesky factors against the matrices they are of, whatever the size and the instructions.

#include "models/air/lower_factor.h"

#include <doctest/doctest.h>

#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <vector>

#include "models/air/turbulence_random.h"
#include "models/support/instructions.h"

using namespace spoke;
using namespace spoke::air;

namespace {

/// A coherence of points on a line, which is positive definite.
double entry(Eigen::Index i, Eigen::Index j) {
  return std::exp(-0.3 * std::abs(static_cast<double>(i - j)));
}

LowerFactor make(std::size_t size) {
  LowerFactor factor(size);
  for (std::size_t j = 0; j < size; ++j)
    for (std::size_t i = j; i < size; ++i)
      factor.column(j)[i] = entry(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  return factor;
}

}  // namespace

TEST_CASE("a factor times its transpose is the matrix, and it multiplies vectors") {
  for (const Kernels kernels : {Kernels::avx512, Kernels::avx2, Kernels::baseline}) {
    const Kernels before = use_kernels(kernels);
    for (std::size_t size = 1; size <= 14; ++size) {
      CAPTURE(size);
      LowerFactor factor = make(size);
      REQUIRE(factor.factorise());
      const auto n = static_cast<Eigen::Index>(size);
      Eigen::MatrixXd L = Eigen::MatrixXd::Zero(n, n);
      for (Eigen::Index j = 0; j < n; ++j)
        for (Eigen::Index i = j; i < n; ++i)
          L(i, j) = factor.column(static_cast<std::size_t>(j))[i];
      const Eigen::MatrixXd A = Eigen::MatrixXd::NullaryExpr(
          n, n, [](Eigen::Index i, Eigen::Index j) { return entry(i, j); });
      CHECK((L * L.transpose() - A).cwiseAbs().maxCoeff() < 1e-14);
      std::vector<std::complex<double>> x(size), y(size);
      RandomStream(3).draw_phasors(x);
      factor.multiply(x, y);
      const Eigen::VectorXcd expected = L * Eigen::Map<const Eigen::VectorXcd>(x.data(), n);
      CHECK((Eigen::Map<const Eigen::VectorXcd>(y.data(), n) - expected).norm() < 1e-14);
    }
    use_kernels(before);
  }
}

TEST_CASE("a matrix that is not positive definite has no factor") {
  for (const std::size_t size : {1, 6, 9}) {
    LowerFactor factor = make(size);
    factor.column(size - 1)[size - 1] = size == 1 ? 0.0 : 0.5;  // less than the rows before leave
    CHECK_FALSE(factor.factorise());
  }
}
