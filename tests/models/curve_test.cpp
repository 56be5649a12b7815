#include "models/curve.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "tests/message_of.h"

using doctest::Approx;
using spoke::Curve;

namespace {

/// Integrates by the composite Simpson rule with n even intervals.
double simpson(const Curve& curve, double a, double b, int n) {
  const double h = (b - a) / n;
  double sum = curve.value(a) + curve.value(b);
  for (int i = 1; i < n; ++i) sum += (i % 2 == 1 ? 4.0 : 2.0) * curve.value(a + i * h);
  return sum * h / 3.0;
}

}  // namespace

TEST_CASE("a constant curve has one value and no derivative and a linear integral") {
  const Curve curve(3.5);
  for (const double t : {-2.0, 0.0, 7.0}) {
    CHECK(curve.value(t) == 3.5);
    CHECK(curve.derivative(t) == 0.0);
    CHECK(curve.integral(t) == Approx(3.5 * t));
  }
  CHECK(Curve().value(1.0) == 0.0);
}

TEST_CASE("a curve through two points is a line between them and constant outside") {
  const Curve curve({1.0, 3.0}, {2.0, 6.0});
  CHECK(curve.value(0.0) == 2.0);
  CHECK(curve.value(2.0) == Approx(4.0));
  CHECK(curve.value(9.0) == 6.0);
  CHECK(curve.derivative(2.0) == Approx(2.0));
  CHECK(curve.derivative(0.5) == 0.0);
  CHECK(curve.derivative(3.5) == 0.0);
  CHECK(curve.integral(1.0) == Approx(2.0));
  CHECK(curve.integral(3.0) == Approx(10.0));
  CHECK(curve.integral(4.0) == Approx(16.0));
  CHECK(curve.integral(-1.0) == Approx(-2.0));
}

// Chords 1 and 3: inner slope 6/(3/1 + 3/3) = 3/2; left end (3*1 - 3)/2 = 0; right (3*3 - 1)/2 = 4.
// First cubic 1.5 x^2 - 0.5 x^3, second 1 + 1.5 x + 2 x^2 - 0.5 x^3.
TEST_CASE("a curve through three equidistant points against a calculation by hand") {
  const Curve curve({0.0, 1.0, 2.0}, {0.0, 1.0, 4.0});
  CHECK(curve.derivative(0.0) == Approx(0.0));
  CHECK(curve.derivative(1.0) == Approx(1.5));
  CHECK(curve.derivative(2.0) == Approx(4.0));
  CHECK(curve.value(0.5) == Approx(0.3125));
  CHECK(curve.value(1.5) == Approx(2.1875));
  CHECK(curve.integral(1.0) == Approx(0.375));
  CHECK(curve.integral(2.0) == Approx(8.0 / 3.0));
}

// Chords 2, 1/2, -3 of lengths 1, 2, 1: slopes (4*2 - 1/2)/3 = 5/2, 9/(5/2 + 4/(1/2)) = 6/7,
// 0 at the peak, and (4*(-3) - 1/2)/3 = -25/6.
TEST_CASE("a curve through unequally spaced points has the weighted slopes") {
  const Curve curve({0.0, 1.0, 3.0, 4.0}, {0.0, 2.0, 3.0, 0.0});
  CHECK(curve.derivative(0.0) == Approx(2.5));
  CHECK(curve.derivative(1.0) == Approx(6.0 / 7.0));
  CHECK(curve.derivative(3.0) == Approx(0.0));
  CHECK(curve.derivative(4.0) == Approx(-25.0 / 6.0));
}

TEST_CASE("an end slope is at most three times its chord beside an extreme") {
  // Chords 1 and -6: the parabola's slope (3*1 + 6)/2 = 4.5 is cut to 3.
  CHECK(Curve({0.0, 1.0, 2.0}, {0.0, 1.0, -5.0}).derivative(0.0) == Approx(3.0));
}

TEST_CASE("a curve passes through its points and is smooth there") {
  const std::vector<double> times = {-1.0, 0.5, 2.0, 2.25, 6.0, 10.0};
  const std::vector<double> values = {3.0, 3.0, -1.0, -4.0, 8.0, 8.5};
  const Curve curve(times, values);
  for (std::size_t k = 0; k < times.size(); ++k) CHECK(curve.value(times[k]) == values[k]);
  for (std::size_t k = 1; k + 1 < times.size(); ++k) {
    const double e = 1e-9;
    CHECK(curve.value(times[k] - e) == Approx(curve.value(times[k] + e)).epsilon(1e-7));
    CHECK(std::abs(curve.derivative(times[k] - e) - curve.derivative(times[k] + e)) < 1e-6);
  }
}

TEST_CASE("a curve stays between neighbouring points and is monotone there") {
  const std::vector<double> times = {0.0, 1.0, 1.1, 4.0, 5.0, 5.5};
  const std::vector<double> values = {0.0, 0.0, 5.0, 5.1, -3.0, -3.0};
  const Curve curve(times, values);
  for (std::size_t k = 0; k + 1 < times.size(); ++k) {
    const double rise = values[k + 1] - values[k];
    double last = values[k];
    for (int i = 1; i <= 200; ++i) {
      const double value = curve.value(times[k] + (times[k + 1] - times[k]) * i / 200.0);
      CHECK((value - last) * (rise >= 0.0 ? 1.0 : -1.0) >= -1e-12);
      last = value;
    }
  }
}

TEST_CASE("derivative and integral of a curve belong to its value") {
  const Curve curve({-2.0, 1.0, 1.5, 3.0}, {1.0, -2.0, 0.0, 4.0});
  const double e = 1e-5;
  for (double t = -3.03; t < 4.0; t += 0.17) {
    const double difference = (curve.value(t + e) - curve.value(t - e)) / (2.0 * e);
    CHECK(curve.derivative(t) == Approx(difference).epsilon(1e-6));
    const double growth = (curve.integral(t + e) - curve.integral(t - e)) / (2.0 * e);
    CHECK(std::abs(curve.value(t) - growth) < 1e-6);
  }
  CHECK(curve.integral(0.0) == 0.0);
  // The rule is exact for cubics, so piece by piece it has only round-off.
  double sum = simpson(curve, 0.0, 1.0, 2) + simpson(curve, 1.0, 1.5, 2);
  sum += simpson(curve, 1.5, 3.0, 2) + simpson(curve, 3.0, 4.0, 2);
  CHECK(curve.integral(4.0) == Approx(sum).epsilon(1e-13));
}

TEST_CASE("at a time that is no number a curve has no value") {
  for (const Curve& curve : {Curve(2.0), Curve({0.0, 1.0, 3.0}, {1.0, 2.0, 0.0})})
    for (const auto function : {&Curve::value, &Curve::derivative, &Curve::integral})
      CHECK(std::isnan((curve.*function)(std::nan(""))));
}

TEST_CASE("a curve refuses points that are none") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto message = [](std::vector<double> times, std::vector<double> values) {
    return spoke::test::message_of([&] { Curve(std::move(times), std::move(values)); });
  };
  const std::string sizes = ", expected as many of each, at least one";
  CHECK(message({}, {}) == "a curve has 0 times and 0 values" + sizes);
  CHECK(message({0.0, 1.0}, {1.0}) == "a curve has 2 times and 1 value" + sizes);
  CHECK(message({0.0, 0.0}, {1.0, 2.0}) ==
        "time 2 of a curve is 0, expected more than the one before it, 0");
  CHECK(message({1.0, 0.5}, {1.0, 2.0}) ==
        "time 2 of a curve is 0.5, expected more than the one before it, 1");
  CHECK(message({0.0, nan}, {1.0, 2.0}) == "time 2 of a curve is nan, expected a finite number");
  CHECK(message({0.0, 1.0}, {1.0, nan}) == "value 2 of a curve is nan, expected a finite number");
}
