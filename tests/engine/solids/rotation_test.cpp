// Frequencies of solids that rotate, against the same meshes in an independent program: K + K_G(w)
// + m (x) A(w), without the gyroscopic terms, which a slender bar hardly feels.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/modes.h"
#include "tests/engine/solids/solid_models.h"

using namespace spoke;
using namespace spoke::test;
using spatial::Vector;

namespace {

/// A bar of 1 m, 1 kg and bending stiffness 1 N m^2 on a hub, cut into pieces of equal length.
Scenario make_rotating_bar(int pieces, double speed) {
  GridMesh grid;
  grid.cells = {48 / pieces, 1, 1};
  grid.lengths = {1.0 / pieces, 0.01, 0.01};
  grid.shift = {0.0, -0.005, -0.005};
  Scenario scenario;
  scenario.title = "rotating bar";
  spatial::Model& model = scenario.space.emplace();
  model.hub.drive = ConstantSpeed{speed};
  spatial::Subsystem bar;
  bar.name = "bar";
  for (int i = 0; i < pieces; ++i) {
    spatial::SolidBody piece = make_bar(grid, {12.0 / 1e-8, 0.0, 1e4});
    if (i + 1 == pieces) piece.interfaces.pop_back();
    piece.modes = 12;
    bar.bodies.push_back({"piece" + std::to_string(i + 1), piece});
    spatial::SubsystemJoint joint;
    if (i > 0) joint.parent = bar.bodies[static_cast<std::size_t>(i - 1)].name;
    joint.child = bar.bodies.back().name;
    bar.joints.push_back(joint);
  }
  model.subsystems.push_back(bar);
  return scenario;
}

/// Returns the relative distance of the nearest frequency to the one expected [rad/s].
double find_error(const ModesResult& result, double expected) {
  double least = 1.0;
  for (const Mode& mode : result.modes)
    least = std::min(least, std::abs(mode.frequency / expected - 1.0));
  return least;
}

struct Expected {
  double speed;
  std::array<double, 3> flap, lag;
};

const std::array<Expected, 3> kExpected{
    {{0.0, {3.51599, 22.03353, 61.69085}, {3.51593, 22.03088, 61.67318}},
     {6.0, {7.36032, 26.80688, 66.66972}, {4.26343, 26.12716, 66.39902}},
     {12.0, {13.17027, 37.60084, 79.60117}, {5.42815, 35.63573, 78.69256}}}};

}  // namespace

TEST_CASE("a rotating bar, whole or in pieces, has the frequencies of its mesh under tension") {
  for (const int pieces : {1, 2, 3})
    for (const Expected& expected : kExpected) {
      ModeOptions options;
      options.count = 10;
      const ModesResult result = solve_modes(make_rotating_bar(pieces, expected.speed), options);
      // Rigid interfaces between pieces hold the sections there, which nu = 0 does not mind; in
      // pieces the bending between interfaces is linear.
      const double allowed = pieces == 1 ? 3e-4 : 1e-3;
      // Coriolis forces couple lag with stretching: of the order (2 w / w_axial)^2 of the square of
      // a frequency, half of that of the frequency. With w_axial = pi/2 sqrt(E / rho) / L = 544
      // rad/s that is 7e-6 w^2.
      const double by_stretch = 1e-5 * expected.speed * expected.speed;
      for (std::size_t k = 0; k < 3; ++k) {
        CAPTURE(pieces);
        CAPTURE(expected.speed);
        CAPTURE(k);
        CHECK(find_error(result, expected.flap[k]) < allowed);
        CHECK(find_error(result, expected.lag[k]) < allowed + by_stretch);
      }
    }
}
