// Coefficients of sections: exact at the given points, linear between, periodic, blended.

#include "models/air/section_polar.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace spoke;
using air::SectionPolar;

namespace {

constexpr double kHalfTurn = std::numbers::pi;

/// Makes a polar of random points whose ends agree.
spatial::Polar random_polar(int seed, double reynolds, int points) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(0.01, 1.0);
  spatial::Polar polar;
  polar.reynolds = reynolds;
  double sum = 0.0;
  for (int i = 0; i < points; ++i) {
    polar.angle.push_back(sum);
    sum += i + 2 == points ? 0.0 : number(random) * number(random) * number(random);
    polar.lift.push_back(number(random) - 0.5);
    polar.drag.push_back(number(random));
    polar.moment.push_back(number(random) - 0.5);
  }
  const double last = polar.angle[points - 2] + 0.1;
  for (double& angle : polar.angle) angle = -kHalfTurn + angle * 2.0 * kHalfTurn / last;
  polar.angle.back() = kHalfTurn;
  polar.lift.back() = polar.lift.front();
  polar.drag.back() = polar.drag.front();
  polar.moment.back() = polar.moment.front();
  return polar;
}

/// Interpolates by searching all rows.
double search(const spatial::Polar& polar, const std::vector<double>& column, double angle) {
  for (std::size_t i = 0; i + 1 < polar.angle.size(); ++i) {
    if (angle < polar.angle[i] || angle > polar.angle[i + 1]) continue;
    const double share = (angle - polar.angle[i]) / (polar.angle[i + 1] - polar.angle[i]);
    return (1.0 - share) * column[i] + share * column[i + 1];
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

TEST_CASE("section_polar: points are exact, values between them linear") {
  const spatial::Airfoil airfoil{"a", {random_polar(1, 0.0, 300)}};
  const spatial::Polar& polar = airfoil.polars[0];
  const SectionPolar section(airfoil, airfoil, 0.3);
  const SectionPolar::Level level = section.level(1e6);
  for (std::size_t i = 0; i < polar.angle.size(); ++i) {
    const air::PolarValues values = section.values(level, polar.angle[i]);
    CHECK(values.lift == doctest::Approx(polar.lift[i]).epsilon(1e-12));
    CHECK(values.drag == doctest::Approx(polar.drag[i]).epsilon(1e-12));
    CHECK(values.moment == doctest::Approx(polar.moment[i]).epsilon(1e-12));
  }
  std::mt19937 random(2);
  std::uniform_real_distribution<double> number(-kHalfTurn, kHalfTurn);
  for (int k = 0; k < 2000; ++k) {
    const double angle = number(random);
    const air::PolarValues values = section.values(level, angle);
    CHECK(values.lift == doctest::Approx(search(polar, polar.lift, angle)).epsilon(1e-9));
    CHECK(values.drag == doctest::Approx(search(polar, polar.drag, angle)).epsilon(1e-9));
    CHECK(values.moment == doctest::Approx(search(polar, polar.moment, angle)).epsilon(1e-9));
    CHECK(section.lift(level, angle) == doctest::Approx(values.lift).epsilon(1e-12));
  }
}

TEST_CASE("section_polar: a turn more or less changes nothing") {
  const spatial::Airfoil airfoil{"a", {random_polar(3, 0.0, 40)}};
  const SectionPolar section(airfoil, airfoil, 0.0);
  const SectionPolar::Level level = section.level(0.0);
  for (double angle = -kHalfTurn + 1e-3; angle < kHalfTurn; angle += 0.01)
    for (const double turn : {-2.0 * kHalfTurn, 2.0 * kHalfTurn})
      if (std::abs(angle + turn) < 3.0 * kHalfTurn)
        CHECK(section.lift(level, angle + turn) ==
              doctest::Approx(section.lift(level, angle)).epsilon(1e-9));
  const double end = section.lift(level, kHalfTurn);
  CHECK(section.lift(level, -kHalfTurn) == doctest::Approx(end));
  CHECK(section.lift(level, kHalfTurn + 1e-9) == doctest::Approx(end).epsilon(1e-6));
  // What is no angle reads no memory that is not there.
  CHECK(std::isfinite(section.lift(level, std::numeric_limits<double>::quiet_NaN())));
  CHECK(std::isfinite(section.lift(level, std::numeric_limits<double>::infinity())));
  CHECK(std::isfinite(section.lift(level, -1e300)));
}

TEST_CASE("section_polar: sections between two aerofoils have coefficients between theirs") {
  const spatial::Airfoil inner{"a", {random_polar(4, 0.0, 50)}};
  const spatial::Airfoil outer{"b", {random_polar(5, 0.0, 80)}};
  const SectionPolar section(inner, outer, 0.25);
  const SectionPolar::Level level = section.level(0.0);
  for (double angle = -3.1; angle < 3.1; angle += 0.003) {
    const double expected = 0.75 * search(inner.polars[0], inner.polars[0].drag, angle) +
                            0.25 * search(outer.polars[0], outer.polars[0].drag, angle);
    CHECK(section.values(level, angle).drag == doctest::Approx(expected).epsilon(1e-9));
  }
}

TEST_CASE(
    "section_polar: Reynolds numbers count by their logarithm, and not beyond the given ones") {
  const spatial::Airfoil one{"a", {random_polar(6, 1e5, 30)}};
  const spatial::Airfoil two{"b", {random_polar(7, 1e5, 20), random_polar(8, 1e7, 25)}};
  const spatial::Airfoil three{
      "c", {random_polar(9, 1e4, 20), random_polar(10, 1e6, 25), random_polar(11, 1e7, 25)}};
  const auto drag = [](const spatial::Airfoil& airfoil, std::size_t k, double angle) {
    return search(airfoil.polars[k], airfoil.polars[k].drag, angle);
  };
  const SectionPolar single(one, two, 0.0), pair(two, two, 0.5), mixed(two, three, 0.5);
  for (double angle = -3.0; angle < 3.0; angle += 0.1) {
    CHECK(single.values(single.level(1e6), angle).drag == doctest::Approx(drag(one, 0, angle)));
    CHECK(pair.values(pair.level(1e6), angle).drag ==
          doctest::Approx(0.5 * (drag(two, 0, angle) + drag(two, 1, angle))));
    CHECK(pair.values(pair.level(1e3), angle).drag == doctest::Approx(drag(two, 0, angle)));
    CHECK(pair.values(pair.level(0.0), angle).drag == doctest::Approx(drag(two, 0, angle)));
    CHECK(pair.values(pair.level(1e9), angle).drag == doctest::Approx(drag(two, 1, angle)));
    // At 10^5.5: a quarter of the way in b, three quarters between the first two of c.
    const double in_two = 0.75 * drag(two, 0, angle) + 0.25 * drag(two, 1, angle);
    const double in_three = 0.25 * drag(three, 0, angle) + 0.75 * drag(three, 1, angle);
    CHECK(mixed.values(mixed.level(std::pow(10.0, 5.5)), angle).drag ==
          doctest::Approx(0.5 * (in_two + in_three)));
  }
}

TEST_CASE("section_polar: a polar without moments has none") {
  spatial::Airfoil airfoil{"a", {random_polar(12, 0.0, 10)}};
  airfoil.polars[0].moment.clear();
  const SectionPolar section(airfoil, airfoil, 0.0);
  CHECK(section.values(section.level(0.0), 0.5).moment == 0.0);
}
