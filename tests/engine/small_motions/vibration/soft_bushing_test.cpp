// Tests modes of solids on springs that are softer than the solid by many orders of magnitude:
// motions of a rigid body on its springs, and vibrations of a free one.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/modes.h"
#include "models/scenario.h"
#include "tests/engine/solids/solid_models.h"

namespace spoke {
namespace {

constexpr double kLength = 1.0, kWidth = 0.1, kDepth = 0.05, kDensity = 2700.0;  // m, kg/m^3
constexpr double kMass = kDensity * kLength * kWidth * kDepth;

/// A bar in nodal coordinates, and the kind of the end by which it is on its bushing.
struct Bar {
  int elements;
  spatial::InterfaceKind end;
};
constexpr Bar kLong{12, spatial::InterfaceKind::rigid};

/// Puts a bar on a bushing of equal stiffness in all directions.
Scenario make_bar_on_bushing(const Bar& kind, double stiffness) {
  spatial::SolidBody bar = test::make_bar({{kind.elements, 1, 1},
                                           {kLength, kWidth, kDepth},
                                           spatial::ElementKind::hex20,
                                           {0.0, -0.5 * kWidth, -0.5 * kDepth}},
                                          {7e10, 0.33, kDensity}, kind.end);
  bar.interfaces.pop_back();
  bar.coordinates = spatial::SolidCoordinates::nodal;
  spatial::Subsystem arm;
  arm.name = "arm";
  arm.bodies = {{"bar", bar}};
  spatial::SubsystemJoint joint;
  joint.child = "bar";
  joint.joint.kind = spatial::JointKind::bushing;
  joint.joint.coordinates.resize(6);
  for (spatial::JointCoordinate& coordinate : joint.joint.coordinates)
    coordinate.stiffness = stiffness;
  arm.joints = {joint};
  Scenario scenario;
  spatial::Model& model = scenario.space.emplace();
  model.hub.drive = FixedDrive{};
  model.subsystems = {arm};
  return scenario;
}

std::vector<double> find_frequencies(const Bar& bar, double stiffness, int count) {
  std::vector<double> found;  // rad/s
  for (const Mode& mode :
       solve_modes(make_bar_on_bushing(bar, stiffness), {.state = {.speed = 0.0}, .count = count})
           .modes) {
    CHECK(mode.eigenvalue.real() == 0.0);
    found.push_back(mode.eigenvalue.imag());
  }
  return found;
}

/// Returns the frequencies of the bar as a rigid body.
std::array<double, 6> find_rigid_frequencies(double k) {
  const double roll = kMass / 12.0 * (kWidth * kWidth + kDepth * kDepth);
  std::array<double, 6> frequencies{std::sqrt(k / kMass), std::sqrt(k / roll)};
  std::size_t at = 2;
  for (const double side : {kWidth, kDepth}) {
    // det [k - w^2 m, -w^2 c; -w^2 c, k - w^2 J] = 0
    const double J = kMass * (kLength * kLength / 3.0 + side * side / 12.0);
    const double c = 0.5 * kMass * kLength;
    const double a = kMass * J - c * c, b = k * (kMass + J);
    const double larger = 0.5 * (b + std::sqrt(b * b - 4.0 * a * k * k));
    frequencies[at++] = std::sqrt(larger / a);
    frequencies[at++] = std::sqrt(k * k / larger);
  }
  std::sort(frequencies.begin(), frequencies.end());
  return frequencies;
}

}  // namespace

TEST_CASE("a solid on a soft bushing moves as a rigid body there, and vibrates as a free one") {
  // 222 coordinates, and 438 or 456, of which not all roots are found.
  for (const Bar& bar :
       {Bar{6, spatial::InterfaceKind::rigid}, kLong, Bar{12, spatial::InterfaceKind::average}}) {
    CAPTURE(bar.elements);
    const std::vector<double> free = find_frequencies(bar, 1e-4, 9);
    REQUIRE(free.size() == 9);
    for (const double stiffness : {1e-1, 1e-3, 1e-6, 1e-10}) {
      CAPTURE(stiffness);
      const std::vector<double> found = find_frequencies(bar, stiffness, 9);
      REQUIRE(found.size() == 9);
      const std::array<double, 6> rigid = find_rigid_frequencies(stiffness);
      // The bar gives way by the ratio of the stiffnesses.
      const double gives = 3e-6 * stiffness;
      for (std::size_t k = 0; k < 6; ++k)
        CHECK(found[k] == doctest::Approx(rigid[k]).epsilon(gives + 1e-10));
      for (std::size_t k = 6; k < 9; ++k)
        CHECK(found[k] == doctest::Approx(free[k]).epsilon(gives + 1e-9));
    }
  }
}

TEST_CASE("roots are the same whether all are found or the lowest of them") {
  // Of one kilonewton a metre, where the ends of the spectrum are near enough for both.
  const std::vector<double> few = find_frequencies(kLong, 1e3, 9);
  const std::vector<double> more = find_frequencies(kLong, 1e3, 40);
  REQUIRE(more.size() == 40);
  for (std::size_t k = 0; k < few.size(); ++k)
    CHECK(few[k] == doctest::Approx(more[k]).epsilon(1e-10));
  CHECK(std::is_sorted(more.begin(), more.end()));
}

}  // namespace spoke
