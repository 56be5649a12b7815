// Zeros between two places of opposite sign.

#include "engine/bodies/air/find_zero.h"

#include <doctest/doctest.h>

#include <cmath>

namespace {

/// Returns the zero of a function between two places, and counts its evaluations.
template <class Function>
double find(const Function& function, double x, double y, int& count) {
  count = 0;
  const auto counted = [&](double at) {
    ++count;
    return function(at);
  };
  return spoke::air::find_zero(counted, x, function(x), y, function(y));
}

}  // namespace

TEST_CASE("find_zero: smooth functions take few evaluations") {
  int count = 0;
  CHECK(find([](double x) { return std::cos(x) - x; }, 0.0, 1.0, count) ==
        doctest::Approx(0.7390851332151607).epsilon(1e-14));
  CHECK(count <= 9);
  CHECK(find([](double x) { return x * x * x - 2.0; }, 2.0, 0.0, count) ==
        doctest::Approx(std::cbrt(2.0)).epsilon(1e-14));
  CHECK(count <= 12);
}

TEST_CASE("find_zero: kinks, jumps, flat and steep functions have zeros in bounded time") {
  int count = 0;
  CHECK(find([](double x) { return x < 0.3 ? -1.0 : 1.0; }, 0.0, 1.0, count) ==
        doctest::Approx(0.3).epsilon(1e-12));
  CHECK(count < 120);
  CHECK(find([](double x) { return std::cbrt(x - 0.1); }, 0.0, 1.0, count) ==
        doctest::Approx(0.1).epsilon(1e-12));
  CHECK(count < 120);
  CHECK(find([](double x) { return std::pow(x - 0.1, 9); }, 0.0, 1.0, count) ==
        doctest::Approx(0.1).epsilon(1e-2));
  CHECK(count < 120);
  CHECK(find([](double x) { return std::exp(40.0 * x) - 10.0; }, -1.0, 1.0, count) ==
        doctest::Approx(std::log(10.0) / 40.0).epsilon(1e-12));
  CHECK(count < 40);
  // At zero itself: to the smallest numbers, and no farther.
  CHECK(std::abs(find([](double x) { return x; }, -1.0, 0.5, count)) < 1e-100);
  CHECK(count <= 200);
}
