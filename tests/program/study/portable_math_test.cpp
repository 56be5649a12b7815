#include "program/study/portable_math.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

using namespace spoke::study;

TEST_CASE("the portable logarithm and exponential are those of the library to round-off") {
  for (int i = -3000; i <= 3000; ++i) {
    const double x = std::exp(0.1 * i);
    const double log = portable_log(x);
    CHECK(std::abs(log - std::log(x)) <= 4e-16 * std::abs(std::log(x)) + 1e-17);
    const double at = 0.237 * i;
    if (std::abs(at) < 700.0)
      CHECK(std::abs(portable_exp(at) - std::exp(at)) <= 6e-16 * std::exp(at));
  }
  CHECK(portable_log(1.0) == 0.0);
  CHECK(portable_exp(0.0) == 1.0);
  CHECK(portable_exp(1e4) == INFINITY);
  CHECK(portable_exp(-1e4) == 0.0);
}

TEST_CASE("powers are products where the exponent is whole") {
  CHECK(portable_power(3.0, 4.0) == 81.0);
  CHECK(portable_power(-2.0, 3.0) == -8.0);
  CHECK(portable_power(2.0, -2.0) == 0.25);
  CHECK(portable_power(0.0, 0.0) == 1.0);
  CHECK(std::abs(portable_power(2.0, 0.5) - std::sqrt(2.0)) < 1e-15);
  CHECK(std::isnan(portable_power(-2.0, 0.5)));
}

TEST_CASE("the normal quantile is the inverse of the distribution") {
  for (const double p : {1e-12, 1e-6, 0.001, 0.02, 0.0749, 0.0751, 0.3, 0.5, 0.7, 0.93, 0.999}) {
    const double x = normal_quantile(p);
    CHECK(std::abs(0.5 * std::erfc(-x / std::sqrt(2.0)) - p) <
          3e-15 * std::max(p, 1e-1) + 2e-14 * p);
  }
  CHECK(normal_quantile(0.5) == 0.0);
  CHECK(std::abs(normal_quantile(0.975) - 1.959963984540054) < 1e-15);  // published
}
