#include "bench/reproduce/operation_counts.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bench/reproduce/paper.h"
#include "tests/approx.h"

// The closed forms against textbook algorithms that are run on a number which counts.

using namespace spoke;
using namespace spoke::reproduce;

namespace {

Operations counted;

struct Number {
  double value = 0.0;
};
Number operator*(Number a, Number b) {
  return ++counted.multiplications, Number{a.value * b.value};
}
Number operator+(Number a, Number b) { return ++counted.additions, Number{a.value + b.value}; }
Number operator-(Number a, Number b) { return ++counted.additions, Number{a.value - b.value}; }
Number operator/(Number a, Number b) { return ++counted.others, Number{a.value / b.value}; }
Number root(Number a) { return ++counted.others, Number{std::sqrt(a.value)}; }

using Matrix = std::vector<std::vector<Number>>;
using spoke::testing::approx;

Matrix positive(int n) {
  Matrix A(n, std::vector<Number>(n));
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) A[i][j].value = i == j ? 2.0 * n : 1.0 / (1.0 + std::abs(i - j));
  return A;
}

template <class Run>
Operations count_of(Run run) {
  counted = {};
  run();
  return counted;
}

/// Overwrites the lower triangle by L.
void run_cholesky(Matrix& A) {
  for (int j = 0, n = static_cast<int>(A.size()); j < n; ++j)
    for (int i = j; i < n; ++i) {
      for (int k = 0; k < j; ++k) A[i][j] = A[i][j] - A[i][k] * A[j][k];
      A[i][j] = i == j ? root(A[i][j]) : A[i][j] / A[j][j];
    }
}

void run_cholesky_solve(const Matrix& L, std::vector<Number>& x) {
  const int n = static_cast<int>(L.size());
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < i; ++k) x[i] = x[i] - L[i][k] * x[k];
    x[i] = x[i] / L[i][i];
  }
  for (int i = n - 1; i >= 0; --i) {
    for (int k = i + 1; k < n; ++k) x[i] = x[i] - L[k][i] * x[k];
    x[i] = x[i] / L[i][i];
  }
}

void run_lu(Matrix& A) {
  const int n = static_cast<int>(A.size());
  for (int k = 0; k < n; ++k)
    for (int i = k + 1; i < n; ++i) {
      A[i][k] = A[i][k] / A[k][k];
      for (int j = k + 1; j < n; ++j) A[i][j] = A[i][j] - A[i][k] * A[k][j];
    }
}

void run_lu_solve(const Matrix& LU, std::vector<Number>& x) {
  const int n = static_cast<int>(LU.size());
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < i; ++k) x[i] = x[i] - LU[i][k] * x[k];
  for (int i = n - 1; i >= 0; --i) {
    for (int k = i + 1; k < n; ++k) x[i] = x[i] - LU[i][k] * x[k];
    x[i] = x[i] / LU[i][i];
  }
}

/// L D L^T x = b with the inverse of D at hand.
void run_band_solve(int n, int half, std::vector<Number>& x) {
  const Number l{0.1}, inverse{0.5};
  for (int i = 0; i < n; ++i)
    for (int k = std::max(0, i - half); k < i; ++k) x[i] = x[i] - l * x[k];
  for (int i = n - 1; i >= 0; --i) {
    x[i] = inverse * x[i];
    for (int k = i + 1; k <= std::min(n - 1, i + half); ++k) x[i] = x[i] - l * x[k];
  }
}

void run_band_product(int n, int half) {
  for (int i = 0; i < n; ++i) {
    Number sum;
    for (int k = std::max(0, i - half); k <= std::min(n - 1, i + half); ++k)
      sum =
          k == std::max(0, i - half) ? Number{1.0} * Number{1.0} : sum + Number{1.0} * Number{1.0};
  }
}

}  // namespace

TEST_CASE("dense kernels cost what their closed forms say") {
  for (const int n : {1, 2, 7, 15, 60}) {
    CAPTURE(n);
    Matrix A = positive(n);
    std::vector<Number> x(n, Number{1.0});
    CHECK(count_of([&] { run_cholesky(A); }) == cholesky(n));
    CHECK(count_of([&] { run_cholesky_solve(A, x); }) == cholesky_solve(n, 1));
    CHECK(cholesky_solve(n, 7) == 7 * cholesky_solve(n, 1));
    A = positive(n);
    CHECK(count_of([&] { run_lu(A); }) == lu(n));
    CHECK(count_of([&] { run_lu_solve(A, x); }) == lu_solve(n, 1));
  }
  CHECK(product(6, 15, 7) == Operations{630, 588, 0});
}

TEST_CASE("banded kernels cost what their closed forms say, small ones too") {
  for (const int half : {1, 3})
    for (const int n : {1, 2, 3, 4, 8, 33}) {
      CAPTURE(n);
      CAPTURE(half);
      std::vector<Number> x(n, Number{1.0});
      CHECK(count_of([&] { run_band_solve(n, half, x); }) == band_solve(n, half));
      CHECK(count_of([&] { run_band_product(n, half); }) == band_product(n, half));
    }
}

TEST_CASE("twist matrices cost what the expressions of models/plane/plane.h do") {
  const Number a{2.0};
  const auto pair_sum = [&] { return a * a + a * a; };
  CHECK(count_of([&] {
          for (int k = 0; k < 6; ++k) (void)(a * a - a * a);  // cofactors
          (void)(Number{1.0} / (pair_sum() + a * a));         // determinant by the first row
          for (int k = 0; k < 6; ++k) (void)(a * a);          // scaled
        }) == twist_inverse());
  CHECK(count_of([&] {
          for (int k = 0; k < 3; ++k) (void)(a * a);              // cc, ss, cs
          (void)(a * a * a);                                      // shear
          for (int k = 0; k < 2; ++k) (void)(a * a + a + a * a);  // xx, yy
          (void)(a * (a - a) + (a - a) * a);                      // yx
          for (int k = 0; k < 2; ++k) (void)(pair_sum());         // rx, ry
        }) == twist_turn());
  CHECK(count_of([&] {
          for (int k = 0; k < 9; ++k) (void)(pair_sum() + a * a);        // A B
          for (int k = 0; k < 6; ++k) (void)(a - (pair_sum() + a * a));  // C - A B A^T
        }) == twist_eliminate());
}

TEST_CASE("the paper's formulas give its numbers") {
  std::int64_t sum = 0;
  for (const paper::Count& count : paper::table_2()) {
    CHECK(count.value == count.printed);
    sum += count.value;
  }
  CHECK(sum == paper::kTable2Total);
  const paper::InverseSizes sizes = paper::inverse_sizes();
  CHECK(sizes.printed == 5'832'000);
  CHECK(sizes.blade == 216'000);
  CHECK(sizes.blocks == 13'500);
}

TEST_CASE("formulations grow with the size as they should") {
  const auto ratio = [](Formulation formulation, const RotorSize& large, const RotorSize& small) {
    return static_cast<double>(count(formulation, large).total()) /
           static_cast<double>(count(formulation, small).total());
  };
  for (const Formulation formulation : {Formulation::structured, Formulation::subsystem})
    CHECK(ratio(formulation, {6, 4, 4}, {3, 4, 4}) == 2.0);
  CHECK(ratio(Formulation::structured, {3, 4, 128}, {3, 4, 64}) == approx(2.0).epsilon(0.05));
  CHECK(ratio(Formulation::subsystem, {3, 4, 128}, {3, 4, 64}) == approx(8.0).epsilon(0.15));
  CHECK(ratio(Formulation::augmented, {6, 8, 8}, {3, 8, 8}) == approx(8.0).epsilon(0.05));
  // A prototype with counting numbers needed N M (264 E + 187) for the recursive kernel.
  const double prototype = 3 * 4 * (264 * 4 + 187);
  CHECK(static_cast<double>(count(Formulation::structured).total()) > 0.9 * prototype);
  CHECK(static_cast<double>(count(Formulation::structured).total()) < 1.4 * prototype);
}
