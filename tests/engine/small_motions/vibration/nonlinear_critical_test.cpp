// Critical loads of beams with strains of second order: columns under loads that follow them, and
// the kinds of axial moments, which are not conservative or not as dead loads are.

#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "engine/modes.h"
#include "tests/engine/bodies/space/nonlinear_beams.h"

namespace spoke::test {
namespace {

using doctest::Approx;
using spatial::LoadFrame;
using spatial::Vector;
using std::numbers::pi;

/// A cantilever of unit length, mass and stiffness, whose lag is stiffer.
BeamTree make_column(const Cut& cut) {
  BeamTree beams;
  beams.add("beam", make_nonlinear_beam({.axial = 1e9, .lag = 4.0}, 1.0, cut));
  return beams;
}

/// How errors of one body of eight elements and four of four are to be: within 5e-4, and as the
/// fourth power of the length of elements makes them, 16 times as large.
void check_orders(double right, double one, double four) {
  CHECK(one == Approx(right).epsilon(5e-4));
  CHECK(four == Approx(right).epsilon(5e-5));
  CHECK(std::abs(one - right) / std::abs(four - right) > 10.0);
}

/// A cantilever, equally stiff in all directions, with arms across its tip that have no mass to
/// speak of.
BeamTree make_shaft(const Cut& cut) {
  BeamTree beams;
  beams.add("shaft", make_nonlinear_beam(
                         {.axial = 1e6, .torsion = 1e5, .flap_inertia = 1e-6, .lag_inertia = 1e-6},
                         1.0, cut));
  beams.add("arms", make_ball(1e-6, 1e-8));
  return beams;
}

/// Adds an axial moment: dead forces in opposite directions at the ends of an arm.
void add_pair(const Vector& arm, const Vector& direction, double moment, BeamTree& beams) {
  for (const double side : {0.1, -0.1})
    beams.push("arms", LoadFrame::inertial, moment / (2.0 * side) * direction).point = side * arm;
}

}  // namespace

TEST_CASE("a column flutters under a force at its tip that follows it") {
  // Beck 1952: P L^2/EI.
  double found[2];
  for (int i = 0; i < 2; ++i) {
    BeamTree beams = make_column(kCuts[i]);
    beams.push("beam", LoadFrame::section, {-1.0, 0.0, 0.0});
    found[i] = find_critical_push(beams.scenario, 15.0, 24.0);
  }
  check_orders(20.05095, found[0], found[1]);
}

TEST_CASE("a column flutters under forces along it that follow it") {
  // Leipholz 1962: q L^3/EI.
  double found[2];
  for (int i = 0; i < 2; ++i) {
    BeamTree beams = make_column(kCuts[i]);
    beams.push_along("beam", LoadFrame::section, {-1.0, 0.0, 0.0});
    found[i] = find_critical_push(beams.scenario, 30.0, 48.0);
  }
  check_orders(40.0538, found[0], found[1]);
}

TEST_CASE("a column of four bodies buckles under a dead load as Euler has it") {
  BeamTree beams = make_column(kFourOfFour);
  beams.push("beam", LoadFrame::inertial, {-1.0, 0.0, 0.0});
  CHECK(find_critical_push(beams.scenario, 2.0, 3.0) == Approx(0.25 * pi * pi).epsilon(1e-6));
}

TEST_CASE("a shaft buckles under axial moments of dead forces by the number of their pairs") {
  // M L/EI = pi/2 for one pair, pi for two that share the moment: quasi- and semitangential
  // (Ziegler 1968). Twist by the moment itself, M L/GJ, makes a difference of its own size.
  for (const Cut& cut : kCuts) {
    BeamTree one = make_shaft(cut);
    add_pair(Vector::UnitY(), Vector::UnitZ(), 1.0, one);
    CHECK(find_critical_push(one.scenario, 1.0, 2.0) == Approx(0.5 * pi).epsilon(2e-4));
    BeamTree two = make_shaft(cut);
    add_pair(Vector::UnitY(), Vector::UnitZ(), 0.5, two);
    add_pair(Vector::UnitZ(), -Vector::UnitY(), 0.5, two);
    CHECK(find_critical_push(two.scenario, 2.0, 4.0) == Approx(pi).epsilon(2e-4));
  }
}

TEST_CASE("an axial moment that stands or follows makes a shaft unstable, however small it is") {
  // Ziegler's paradox: two equal frequencies become a pair with w^2 = 12.3616 -+ 0.1895 i at
  // M L/EI = 0.05, by the beam's differential equation.
  for (const Cut& cut : kCuts)
    for (const LoadFrame frame : {LoadFrame::inertial, LoadFrame::section}) {
      BeamTree beams;
      beams.add("shaft", make_nonlinear_beam({.axial = 1e6, .torsion = 1e3}, 1.0, cut));
      beams.push("shaft", frame, Vector::Zero(), {0.05, 0.0, 0.0});
      const ModesResult result = solve_modes(beams.scenario, {.count = 2});
      for (const Mode& mode : result.modes) {
        const std::complex<double> square = -mode.eigenvalue * mode.eigenvalue;
        CHECK(square.real() == Approx(12.3616).epsilon(1e-5));
        CHECK(std::abs(square.imag()) == Approx(0.1895).epsilon(2e-4));
      }
      CHECK(result.modes[0].eigenvalue.real() * result.modes[1].eigenvalue.real() < 0.0);
    }
}

}  // namespace spoke::test
