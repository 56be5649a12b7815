#include "program/run_report/curves.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>

#include "tests/approx.h"

using namespace spoke::run_report;
using spoke::testing::approx;

TEST_CASE("a short curves keeps every row") {
  Curves curves(2);
  for (int k = 0; k < 100; ++k) curves.add(0.1 * k, std::array{1.0 * k, -2.0 * k});
  CHECK(curves.rows_per_bucket() == 1);
  const auto curve = curves.curve(1);
  REQUIRE(curve.size() == 100);
  CHECK(curve[7].t == approx(0.7));
  CHECK(curve[7].value == -14.0);
}

TEST_CASE("a long curves keeps lowest and highest values where they were, and the last") {
  constexpr int kRows = 123457;
  Curves curves(1);
  for (int k = 0; k < kRows; ++k) {
    double value = std::sin(1e-4 * k);
    if (k == 77777) value = 9.0;  // a spike of one row
    if (k == 5000) value = -7.0;
    curves.add(k, std::array{value});
  }
  const auto curve = curves.curve(0);
  CHECK(curve.size() <= 2 * Curves::kMostBuckets + 1);
  CHECK(curve.size() > Curves::kMostBuckets / 2);
  CHECK(curves.rows_per_bucket() == 128);
  bool has_high = false, has_low = false;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (i > 0) CHECK(curve[i].t > curve[i - 1].t);
    has_high = has_high || (curve[i].t == 77777.0 && curve[i].value == 9.0);
    has_low = has_low || (curve[i].t == 5000.0 && curve[i].value == -7.0);
  }
  CHECK(has_high);
  CHECK(has_low);
  CHECK(curve.front().t == 0.0);
  CHECK(curve.back().t == kRows - 1);
  CHECK(curve.back().value == std::sin(1e-4 * (kRows - 1)));
}

TEST_CASE("many curves share the memory, with an odd number of buckets too") {
  constexpr std::size_t kCurves = 121;
  Curves curves(kCurves);
  CHECK(curves.most_buckets() == 330);
  Curves odd(kCurves + 1);
  CHECK(odd.most_buckets() == 327);
  std::array<double, kCurves + 1> values{};
  for (int k = 0; k <= 10000; ++k) {
    values.fill(k);
    odd.add(k, values);
  }
  const auto curve = odd.curve(kCurves);
  CHECK(curve.size() <= 2 * 327 + 1);
  CHECK(curve.front().value == 0.0);
  CHECK(curve.back().value == 10000.0);
  for (std::size_t i = 1; i < curve.size(); ++i) CHECK(curve[i].t - curve[i - 1].t <= 64.0);
}

TEST_CASE("values that are not finite leave a gap") {
  Curves curves(1);
  curves.add(0.0, std::array{1.0});
  curves.add(1.0, std::array{std::numeric_limits<double>::quiet_NaN()});
  curves.add(2.0, std::array{3.0});
  const auto curve = curves.curve(0);
  REQUIRE(curve.size() == 2);
  CHECK(curve[1].t == 2.0);
}
