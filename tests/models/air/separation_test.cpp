// The split of lift into that of attached and of separated flow.

#include "models/air/separation.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

using namespace spoke;

namespace {

constexpr double kStraight = std::numbers::pi;
constexpr double kOneDegree = kStraight / 180.0;

std::vector<double> make_angles(double step) {
  std::vector<double> angles{-kStraight};
  while (angles.back() < kStraight - 1.5 * step) angles.push_back(angles.back() + step);
  angles.push_back(kStraight);
  return angles;
}

/// A separation point that is 1 near zero lift and goes to 0.
double point_of(double from_zero) {
  const double x = (std::abs(from_zero) - 9.0 * kOneDegree) / (20.0 * kOneDegree);
  if (x <= 0.0) return 1.0;
  if (x >= 1.0) return 0.0;
  return 0.5 * (1.0 + std::cos(kStraight * x));
}

}  // namespace

TEST_CASE("separation: Kirchhoff's lift gives its separation point back") {
  constexpr double slope = 6.0, zero_lift = -0.05;
  const std::vector<double> angles = make_angles(0.5 * kOneDegree);
  std::vector<double> lift;
  for (const double angle : angles) {
    const double root = std::sqrt(point_of(angle - zero_lift));
    const double attached = slope * std::sin(angle - zero_lift);
    lift.push_back(0.25 * attached * (1.0 + root) * (1.0 + root));
  }
  const air::Separation split = air::separate(angles, lift);
  CHECK(split.zero_lift == doctest::Approx(zero_lift).epsilon(1e-4));
  CHECK(split.slope == doctest::Approx(slope).epsilon(1e-4));
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double from_zero = angles[i] - zero_lift;
    CAPTURE(from_zero);
    if (std::abs(from_zero) < 50.0 * kOneDegree && std::abs(from_zero) > kOneDegree) {
      CHECK(split.point[i] == doctest::Approx(point_of(from_zero)).epsilon(2e-3));
      CHECK(split.attached[i] == doctest::Approx(slope * std::sin(from_zero)).epsilon(1e-4));
    }
  }
}

TEST_CASE("separation: the two parts make up the lift, whatever it is") {
  const std::vector<double> angles = make_angles(0.9 * kOneDegree);
  for (int kind = 0; kind < 20; ++kind) {
    std::vector<double> lift;
    for (const double angle : angles)
      lift.push_back(std::sin(2.0 * angle) * (1.0 + 0.3 * std::sin(kind * angle)) +
                     2.0 * std::sin(angle) * std::exp(-std::pow(angle / 0.2, 2)) + 0.02 * kind);
    lift.back() = lift.front();
    const air::Separation split = air::separate(angles, lift);
    for (std::size_t i = 0; i < angles.size(); ++i) {
      const double f = split.point[i];
      CHECK(f >= 0.0);
      CHECK(f <= 1.0);
      CHECK(f * split.attached[i] + (1.0 - f) * split.separated[i] ==
            doctest::Approx(lift[i]).epsilon(1e-9));
      if (std::abs(angles[i] - split.zero_lift) > 60.0 * kOneDegree) CHECK(f == 0.0);
      // Separated flow lifts less than attached flow.
      if (f > 0.0) CHECK(std::abs(split.separated[i]) <= std::abs(split.attached[i]) + 1e-12);
    }
  }
}

TEST_CASE("separation: without lift, or lift that rises, no flow is attached") {
  const std::vector<double> angles{-kStraight, 0.0, kStraight};
  for (const std::vector<double>& lift :
       {std::vector<double>{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}, {-1.0, -1.0, -1.0}}) {
    const air::Separation split = air::separate(angles, lift);
    CHECK(split.slope == 0.0);
    CHECK(split.point == std::vector<double>{0.0, 0.0, 0.0});
    CHECK(split.separated == lift);
    CHECK(split.attached == lift);
  }
}
