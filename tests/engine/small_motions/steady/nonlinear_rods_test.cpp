// Equilibria of beams with strains of second order beside exact rods, which bend and twist by any
// angle.

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "engine/equilibrium.h"
#include "tests/engine/bodies/space/nonlinear_beams.h"
#include "tests/engine/small_motions/steady/elastic_rod.h"

namespace spoke::test {
namespace {

using doctest::Approx;
using spatial::LoadFrame;
using spatial::Vector;

BladeEquilibrium settle(const BeamTree& beams) {
  return solve_equilibrium(beams.scenario).blades.at(0);
}

/// Errors of a tip: of its place by the largest displacement, and of its rotation [rad].
struct TipError {
  double place, turn;
};

TipError compare(const BladeEquilibrium& found, const RodTip& right) {
  const Vector& vector = found.tip_rotation;
  const Eigen::AngleAxisd turn(vector.norm(), vector.normalized());
  return {(found.tip_displacement - right.displacement).norm() / right.displacement.norm(),
          Eigen::Quaterniond(turn).angularDistance(right.rotation)};
}

double turn_of(const RodTip& right) {
  return Eigen::Quaterniond::Identity().angularDistance(right.rotation);
}

/// Solves a cantilever under a dead force at its tip.
template <class MakeBeam>
TipError find_error(MakeBeam&& make_beam, const Cut& cut, const Vector& force,
                    const RodTip& right) {
  BeamTree beams;
  beams.add("beam", make_beam(cut));
  beams.push("beam", LoadFrame::inertial, force);
  return compare(settle(beams), right);
}

/// Checks one body of eight elements and four of four, and that errors fall with the square of the
/// length of elements or faster.
template <class MakeBeam>
void check_rod(MakeBeam&& make_beam, const Vector& force, const RodTip& right) {
  for (const Cut& cut : kCuts) {
    CAPTURE(cut.bodies);
    const TipError error = find_error(make_beam, cut, force, right);
    CHECK(error.place < tolerance_of(cut));
    CHECK(error.turn < tolerance_of(cut) * turn_of(right));
  }
  const TipError coarse = find_error(make_beam, {1, 8}, force, right),
                 fine = find_error(make_beam, {1, 16}, force, right);
  CHECK(coarse.place / fine.place > 3.5);  // 4 in the limit
  CHECK(coarse.turn / fine.turn > 3.5);
}

}  // namespace

TEST_CASE("flap and lag together twist a cantilever as a rod") {
  const ElasticRod rod{1.0, 1e5, {0.5, 1.0, 10.0}};
  const Vector force(0.0, 1.5, 0.3);
  const RodTip right = solve_rod(rod, force);
  CHECK(right.rotation.toRotationMatrix()(2, 1) == Approx(-0.091235).epsilon(1e-4));
  check_rod(
      [](const Cut& cut) {
        return make_nonlinear_beam({.axial = 1e5, .torsion = 0.5, .flap = 1.0, .lag = 10.0}, 1.0,
                                   cut);
      },
      force, right);
}

TEST_CASE("the Princeton beam of few bodies bends and twists as a rod") {
  // Dowell and Traybar 1975, stiffnesses as measured; 3 pounds at 45 degrees.
  const double axial = 71.7e9 * 12.377e-3 * 3.2024e-3, share = 13.345 * std::sqrt(0.5);
  const ElasticRod rod{0.508, axial, {3.10357, 2.42873, 36.2794}};
  const Vector force(0.0, share, share);
  check_rod(
      [axial](const Cut& cut) {
        return make_nonlinear_beam(
            {.axial = axial, .torsion = 3.10357, .flap = 2.42873, .lag = 36.2794, .mass = 0.113},
            0.508, cut);
      },
      force, solve_rod(rod, force));
}

TEST_CASE("a bent and twisted beam with all couplings of its section deforms as a rod") {
  // The axis is a spline as the beam's own, bent by half a radian along z and 0.3 along y; twist
  // 0.8 rad; stiffness coupled throughout. The rod by shooting: r' = Q (t + R g), Q' = Q (R k)~, m'
  // = -r' x n, (g; k) = C^-1 ((Q R)^T n; (Q R)^T m).
  const RodTip right{{-0.02959227, 0.02074451, 0.06996041},
                     Eigen::Quaterniond(Eigen::AngleAxisd(
                         Vector(-0.0613891, -0.10852598, 0.0051971).norm(),
                         Vector(-0.0613891, -0.10852598, 0.0051971).normalized()))};
  const std::vector<double> station{0.0, 0.2, 0.4, 0.6, 0.8, 0.95};
  Eigen::Matrix<double, 6, 1> size;
  size << 1e4, 3e3, 4e3, 0.5, 1.0, 10.0;
  size = size.cwiseSqrt();
  Eigen::Matrix<double, 6, 6> coupling = Eigen::Matrix<double, 6, 6>::Identity();
  const auto couple = [&coupling](int i, int j, double value) {
    coupling(i, j) = coupling(j, i) = value;
  };
  couple(0, 3, 0.05);
  couple(0, 4, 0.2);
  couple(0, 5, -0.15);
  couple(1, 2, 0.1);
  couple(1, 3, 0.15);
  couple(1, 5, 0.1);
  couple(2, 3, -0.1);
  couple(2, 4, -0.1);
  couple(3, 4, 0.2);
  couple(3, 5, -0.1);
  couple(4, 5, 0.15);
  const auto make_beam = [&](const Cut& cut) {
    spatial::Beam beam;
    beam.length = 0.95;
    beam.bodies = cut.bodies;
    beam.elements = cut.elements;
    beam.strain = spatial::BeamStrain::nonlinear;
    spatial::Sections& sections = beam.sections;
    sections.station = station;
    sections.sweep = {0.0, 0.006, 0.024, 0.052, 0.09, 0.125};
    sections.prebend = {0.0, 0.003, 0.02, 0.065, 0.15, 0.25};
    for (const double x : station) sections.twist.push_back(0.8 * x / 0.95);
    sections.stiffness_6x6.assign(station.size(), size.asDiagonal() * coupling * size.asDiagonal());
    sections.mass_per_length.assign(station.size(), 1.0);
    sections.flap_inertia = sections.lag_inertia = std::vector<double>(station.size(), 1e-4);
    return beam;
  };
  check_rod(make_beam, {-0.1, 0.5, 0.3}, right);
}

TEST_CASE("a beam that a loop holds at its end, too, bears its load by tension") {
  // The extensible elastica between two clamps, by shooting, 20 N/m at EI = 1, EA = 1e4: middle,
  // and the force along the line of the clamps. Von Karman's theory: 0.03207, 25.13.
  for (const Cut& cut : kCuts) {
    CAPTURE(cut.bodies);
    BeamTree beams;
    beams.add("beam", make_nonlinear_beam({.axial = 1e4, .lag = 3.0}, 1.0, cut));
    beams.close(LoopKind::fixed, "beam", {1.0, 0.0, 0.0});
    beams.push_along("beam", LoadFrame::hub, {0.0, 0.0, 20.0});
    const BladeEquilibrium found = settle(beams);
    double middle = 0.0;
    for (const Eigen::Vector3d& node : found.nodes) middle = std::max(middle, node.z());
    CHECK(middle == Approx(0.0321609).epsilon(tolerance_of(cut)));
    CHECK(found.loops.at(0).force.x() == Approx(24.9488).epsilon(tolerance_of(cut)));
  }
}

TEST_CASE("one body in steady rotation flaps and lags by half its length") {
  // Legendre-Galerkin solution of the inextensible elastica in rotation, error below 1e-7.
  struct Known {
    Vector load, tip;
  };
  for (const Known& known : {Known{{0.0, 0.0, 20.0}, {0.846496699, 0.0, 0.511126803}},
                             Known{{0.0, 10.0, 20.0}, {0.68658103, 0.52092083, 0.45523851}}}) {
    const auto find_error = [&known](const Cut& cut) {
      BeamTree beams;
      beams.model().hub.drive = ConstantSpeed{6.0};
      beams.add("beam", make_nonlinear_beam({.axial = 1e6}, 1.0, cut));
      beams.push_along("beam", LoadFrame::hub, known.load);
      const Vector place = settle(beams).tip_displacement + Vector::UnitX();
      return (place - known.tip).norm() / (known.tip - Vector::UnitX()).norm();
    };
    for (const Cut& cut : kCuts) CHECK(find_error(cut) < tolerance_of(cut));
    if (known.load.y() == 0.0) CHECK(find_error({1, 8}) / find_error({1, 16}) > 3.5);
  }
}

TEST_CASE("a beam that turns fast sags by its weight as its differential equation has it") {
  for (const Cut& cut : kCuts) {
    BeamTree beams;
    beams.model().hub.drive = ConstantSpeed{30.0};
    beams.model().gravity = {0.0, 0.0, -0.5};
    beams.add("beam", make_nonlinear_beam({.torsion = 1e3, .flap = 10.0, .lag = 1e4}, 1.0, cut));
    CHECK(settle(beams).tip_displacement.z() == Approx(-6.351215e-4).epsilon(1e-4));
  }
}

}  // namespace spoke::test
