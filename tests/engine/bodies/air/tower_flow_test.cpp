// The flow around a tower against closed forms: a cylinder in potential flow, the balance of
// momentum of its drag.

#include "engine/bodies/air/tower_flow.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

using namespace spoke;
using Eigen::Vector3d;
using spatial::TowerPotential;
using spatial::TowerShadow;

namespace {

constexpr air::TowerFlow kAround{TowerPotential::cylinder, TowerShadow::none};
constexpr air::TowerFlow kBak{TowerPotential::bak, TowerShadow::none};
constexpr air::TowerFlow kBehind{TowerPotential::none, TowerShadow::powles};

/// Returns the mean over a circle about the axis of a function of the angle.
template <class Function>
double mean_over_circle(const Function& of) {
  constexpr int parts = 3600;
  double sum = 0.0;
  for (int k = 0; k < parts; ++k) sum += of(2.0 * std::numbers::pi * (k + 0.5) / parts) / parts;
  return sum;
}

/// A tower along z with a diameter of 6 m at its foot and 4 m at its top, 80 m high.
std::array<air::TowerPoint, 3> make_axis() {
  return {{{{0, 0, 0}, {}, 6.0, 0.5}, {{0, 0, 40}, {}, 5.0, 0.5}, {{0, 0, 80}, {}, 4.0, 0.5}}};
}

}  // namespace

TEST_CASE("tower flow: a cylinder stops the wind ahead and behind and doubles it at its sides") {
  for (const double x : {-1.0, 1.0}) {
    CHECK(air::calc_cylinder_flow(kAround, x, 0.0, 1.0).along == doctest::Approx(-1.0));
    CHECK(air::calc_cylinder_flow(kAround, 0.0, x, 1.0).along == doctest::Approx(1.0));
  }
  // No air passes its surface.
  mean_over_circle([](double angle) {
    const double x = std::cos(angle), y = std::sin(angle);
    const air::CylinderFlow added = air::calc_cylinder_flow(kAround, x, y, 1.0);
    const double through = (1.0 + added.along) * x + added.across * y;
    CHECK(std::abs(through) < 1e-12);
    return 0.0;
  });
  // Within it flow is that on its surface, and finite on its axis.
  const air::CylinderFlow inside = air::calc_cylinder_flow(kAround, 0.3, 0.4, 1.0);
  const air::CylinderFlow surface = air::calc_cylinder_flow(kAround, 0.6, 0.8, 1.0);
  CHECK(inside.along == doctest::Approx(surface.along));
  CHECK(inside.across == doctest::Approx(surface.across));
  CHECK(air::calc_cylinder_flow(kAround, 0.0, 0.0, 1.0).along == -1.0);
}

TEST_CASE("tower flow: what a cylinder adds has no mean, and falls with the square of distance") {
  for (const double r : {1.5, 4.0}) {
    const auto along = [r](double a) {
      return air::calc_cylinder_flow(kAround, r * std::cos(a), r * std::sin(a), 1.0).along;
    };
    CHECK(std::abs(mean_over_circle(along)) < 1e-12);
    CHECK(along(0.0) == doctest::Approx(-1.0 / (r * r)));
  }
}

TEST_CASE("tower flow: Bak's source feeds the wake that the drag needs") {
  // A source of strength Q in wind U bears rho U Q: with the coefficient c that is
  // rho/2 U^2 2 R c, so that Q = c U R; Q/(2 pi r) is its mean through a circle.
  constexpr double coefficient = 0.7;
  for (const double r : {2.0, 10.0}) {
    const double through = mean_over_circle([r](double a) {
      const auto added =
          air::calc_cylinder_flow(kBak, r * std::cos(a), r * std::sin(a), coefficient);
      return added.along * std::cos(a) + added.across * std::sin(a);
    });
    CHECK(2.0 * std::numbers::pi * r * through == doctest::Approx(coefficient).epsilon(1e-9));
  }
  // Without drag it is the cylinder, a tenth of its radius ahead.
  const auto shifted = air::calc_cylinder_flow(kBak, -2.1, 0.5, 0.0);
  const auto plain = air::calc_cylinder_flow(kAround, -2.0, 0.5, 0.0);
  CHECK(shifted.along == doctest::Approx(plain.along));
  CHECK(shifted.across == doctest::Approx(plain.across));
}

TEST_CASE("tower flow: the shadow lacks the momentum of the drag, and is behind the tower alone") {
  constexpr double coefficient = 0.4, x = 400.0;
  // Far behind, rho U times the lacking flow, by U R, is the drag: the flow is the coefficient.
  double flow = 0.0;
  constexpr int parts = 20000;
  constexpr double width = 30.0;
  for (int k = 0; k < parts; ++k) {
    const double y = width * (2.0 * (k + 0.5) / parts - 1.0);
    flow -= air::calc_cylinder_flow(kBehind, x, y, coefficient).along * 2.0 * width / parts;
  }
  CHECK(flow == doctest::Approx(coefficient).epsilon(1e-3));
  CHECK(air::calc_cylinder_flow(kBehind, 9.0, 0.0, coefficient).along ==
        doctest::Approx(-coefficient / 3.0));
  CHECK(air::calc_cylinder_flow(kBehind, 9.0, 3.2, coefficient).along == 0.0);
  CHECK(air::calc_cylinder_flow(kBehind, -1.0, 0.0, coefficient).along == 0.0);
}

TEST_CASE("tower flow: a tower acts by its width there, across its axis and against its motion") {
  const auto axis = make_axis();
  // At 20 m of height it is 5.5 m wide.
  const Vector3d wind(10.0, 0.0, 3.0);
  const auto expected = air::calc_cylinder_flow(kAround, -8.0 / 2.75, 1.0 / 2.75, 0.5);
  const Vector3d added = air::calc_tower_flow(kAround, axis, {-8.0, 1.0, 20.0}, wind);
  CHECK((added - Vector3d(10.0 * expected.along, 10.0 * expected.across, 0.0)).norm() < 1e-12);
  // A tower that gives way in the wind sees less of it.
  auto moving = axis;
  for (air::TowerPoint& point : moving) point.velocity = {4.0, 0.0, 1.0};
  CHECK((air::calc_tower_flow(kAround, moving, {-8.0, 1.0, 20.0}, wind) - 0.6 * added).norm() <
        1e-12);
  CHECK(air::calc_tower_flow(kAround, axis, {-8.0, 1.0, 20.0}, {0, 0, 5}) == Vector3d::Zero());
  // Whatever the axes of the world are.
  const Eigen::AngleAxisd turn(0.7, Vector3d(1.0, -2.0, 0.5).normalized());
  auto turned = axis;
  for (air::TowerPoint& point : turned) point.position = turn * point.position;
  CHECK((air::calc_tower_flow(kAround, turned, turn * Vector3d(-8.0, 1.0, 20.0), turn * wind) -
         turn * added)
            .norm() < 1e-12);
}

TEST_CASE("tower flow: above its top a tower's flow fades within its radius, without a jump") {
  const auto axis = make_axis();
  const Vector3d wind(10.0, 0.0, 0.0);
  const auto at = [&](double z) {
    return air::calc_tower_flow(kAround, axis, {-5.0, 0.0, z}, wind).x();
  };
  CHECK(at(80.0) == doctest::Approx(-10.0 * 4.0 / 25.0));
  CHECK(at(80.0 + 1e-6) == doctest::Approx(at(80.0 - 1e-6)).epsilon(1e-5));
  CHECK(at(81.0) == doctest::Approx(0.5 * at(80.0)));
  CHECK(std::abs(at(82.0 - 1e-6)) < 1e-9);
  CHECK(at(83.0) == 0.0);
}
