// Frequencies of beams with strains of second order about states in which they are bent, turned or
// pulled.

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "tests/engine/bodies/space/nonlinear_beams.h"

namespace spoke::test {
namespace {

using doctest::Approx;
using spatial::LoadFrame;
using spatial::Vector;
using std::numbers::pi;

/// A soft blade ten times as stiff in lag as in flap, with the inertia of one material.
spatial::Beam make_strip(const Cut& cut) {
  return make_nonlinear_beam({.axial = 1e5,
                              .torsion = 0.5,
                              .flap = 1.0,
                              .lag = 10.0,
                              .flap_inertia = 1e-5,
                              .lag_inertia = 1e-4},
                             1.0, cut);
}

/// Checks frequencies against the right ones [rad/s].
void check_frequencies(const Scenario& scenario, const std::vector<std::string>& names,
                       const std::vector<double>& right, double tolerance) {
  const std::vector<double> found = find_frequencies(scenario, names);
  for (std::size_t k = 0; k < right.size(); ++k) {
    CAPTURE(names[k]);
    CHECK(found[k] == Approx(right[k]).epsilon(tolerance));
  }
}

}  // namespace

TEST_CASE("lag of a cantilever bent far in flap is one with its torsion") {
  // 25 % of the length; sixteen bodies of other strains (by curvature and chord).
  for (const Cut& cut : kCuts) {
    BeamTree beams;
    beams.add("strip", make_strip(cut));
    beams.push("strip", LoadFrame::inertial, {0.0, 0.0, 0.8});
    check_frequencies(beams.scenario, {"flap 1", "lag 1"}, {3.6872, 9.7147}, tolerance_of(cut));
  }
}

TEST_CASE("a pitched blade that turns under a force at its tip vibrates as many bodies do") {
  for (const Cut& cut : kCuts)
    for (const bool is_loaded : {false, true}) {
      CAPTURE(cut.bodies);
      CAPTURE(is_loaded);
      BeamTree beams;
      beams.model().hub.drive = ConstantSpeed{6.0};
      spatial::Joint& root = beams.add("strip", make_strip(cut)).joint;
      root.offset = {0.1, 0.0, 0.0};
      root.orientation = {0.3, 0.0, 0.0};
      const std::vector<std::string> names{"flap 1", "lag 1", "flap 2", "lag 2", "flap 3"};
      if (!is_loaded) {
        check_frequencies(beams.scenario, names, {7.43711, 11.8436, 27.3150}, 1e-4);
        continue;
      }
      beams.push("strip", LoadFrame::hub, {0.0, 0.5, 2.0});
      check_frequencies(beams.scenario, names, {7.3607, 11.6104, 27.1615, 65.170, 67.878},
                        tolerance_of(cut));
    }
}

TEST_CASE("a beam that turns vibrates as its differential equation has it") {
  // Unit length, mass and stiffness at 12 rad/s; lag is flap less the square of the speed.
  for (const auto& [cut, tolerance] :
       {std::pair(kOneOfEight, 1e-4), std::pair(kFourOfFour, 2e-5)}) {
    BeamTree beams;
    beams.model().hub.drive = ConstantSpeed{12.0};
    beams.add("beam", make_nonlinear_beam({.torsion = 10.0}, 1.0, cut));
    check_frequencies(beams.scenario, {"flap 1", "flap 2", "lag 1"}, {13.1702, 37.6031, 5.4272},
                      tolerance);
  }
}

TEST_CASE("a beam that a joint has turned by pi hangs as one that is mounted so") {
  for (const auto& [cut, tolerance] :
       {std::pair(kOneOfEight, 1e-5), std::pair(kFourOfFour, 1e-5)}) {
    double by[2];
    for (const bool by_joint : {false, true}) {
      BeamTree beams;
      beams.model().gravity = {0.0, 0.0, -9.81};
      spatial::Joint& root =
          beams
              .add("beam",
                   make_nonlinear_beam({.torsion = 10.0, .flap = 2.0, .lag = 4.0}, 1.0, cut),
                   by_joint ? spatial::JointKind::revolute : spatial::JointKind::fixed,
                   Vector::UnitY())
              .joint;
      root.orientation = {0.0, (by_joint ? -0.5 : 0.5) * pi, 0.0};
      if (by_joint) root.coordinates[0].motion = move({0.0}, {pi});
      by[by_joint] = find_frequencies(beams.scenario, {"flap 1"})[0];
    }
    CHECK(by[0] == Approx(6.3325).epsilon(tolerance));
    CHECK(by[1] == Approx(by[0]).epsilon(1e-9));
  }
}

TEST_CASE("a light link under a heavy bob vibrates as a string") {
  // Hinged at both ends under the tension N, which is weight: w = pi/L sqrt((N + EI pi^2/L^2)/m).
  // The bob, 200 times as heavy, gives way: m L/M by pi^2, of half the square.
  const double weight = 20.0 * 9.81, own = 0.5 * 0.1 * 9.81, stiffness = 0.5;
  const double right =
      pi * std::sqrt((weight + own + stiffness * pi * pi) / 0.1) * (1.0 + 0.1 / 20.0 / (pi * pi));
  for (const Cut& cut : kCuts) {
    BeamTree beams;
    beams.model().gravity = {0.0, 0.0, -9.81};
    spatial::Joint& hinge =
        beams
            .add("link",
                 make_nonlinear_beam({.flap = stiffness, .lag = stiffness, .mass = 0.1}, 1.0, cut),
                 spatial::JointKind::revolute, Vector::UnitY())
            .joint;
    hinge.name = "hinge";
    hinge.orientation = {0.0, 0.5 * pi, 0.0};
    beams.add("bob", make_ball(20.0, 1.0), spatial::JointKind::revolute, Vector::UnitY());
    CHECK(find_frequencies(beams.scenario, {"hinge flap 2"})[0] == Approx(right).epsilon(1e-4));
  }
}

}  // namespace spoke::test
