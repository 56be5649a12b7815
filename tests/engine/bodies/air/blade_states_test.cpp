// States of inflow and stall: how they go on, stand and come to rest.

#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "engine/bodies/air/blade_air.h"
#include "models/air/section_polar.h"
#include "tests/approx.h"
#include "tests/engine/bodies/air/rigid_blade.h"

using namespace spoke;
using namespace spoke::test;
using Eigen::Vector3d;
using spoke::testing::approx;

namespace {

const std::vector<double> kPlaces = spread(0.0, 30.0, 13);

spatial::Air plate_air(spatial::Inflow inflow, spatial::Stall stall) {
  spatial::Air air = steady_air({make_airfoil("plate", plate_lift, 0.01)});
  air.inflow = inflow;
  air.stall = stall;
  return air;
}

air::BladeAir make(const spatial::Air& air) {
  return {
      make_blade(
          kPlaces, "plate", [](double) { return 1.5; }, [](double s) { return -0.25 + 0.006 * s; }),
      air, 3, 2.0, kPlaces};
}

constexpr auto kLag = spatial::Inflow::dynamic;
constexpr auto kAtOnce = spatial::Inflow::quasi_steady;
const Vector3d kBreeze(8.0, 0.0, 0.0);

BladePlace turning(double pitch) { return {.speed = 1.8, .pitch = pitch, .hub_radius = 2.0}; }

}  // namespace

TEST_CASE("blade_states: after long, states and loads are those of equilibrium") {
  for (const auto inflow : {kLag, kAtOnce})
    for (const auto stall : {spatial::Stall::dynamic, spatial::Stall::steady}) {
      const air::BladeAir blade = make(plate_air(inflow, stall));
      AirRun rest(blade), late(blade);
      rest.go(turning(0.02), kBreeze, kForever);
      late.go(turning(-0.1), Vector3d(2.0, 0.0, 0.0), kForever);
      for (int k = 0; k < 3; ++k) late.go(turning(0.02), kBreeze, 1e4);
      for (std::size_t i = 0; i < kPlaces.size(); ++i)
        CHECK((rest.loads[i].force - late.loads[i].force).norm() <
              1e-9 * rest.loads[i].force.norm());
      for (std::size_t i = 0; i < rest.state.size(); ++i)
        CHECK(late.state[i] == doctest::Approx(rest.state[i]).epsilon(1e-9));
      // Equilibrium goes on as it is.
      const std::vector<double> before = rest.state;
      rest.go(turning(0.02), kBreeze, 0.1);
      for (std::size_t i = 0; i < before.size(); ++i)
        CHECK(rest.state[i] == doctest::Approx(before[i]).epsilon(1e-12));
    }
}

TEST_CASE("blade_states: equilibrium does not depend on the states before") {
  const air::BladeAir blade = make(plate_air(kLag, spatial::Stall::dynamic));
  AirRun one(blade), two(blade);
  for (double& value : two.state) value = 1e3;
  one.go(turning(0.0), kBreeze, kForever);
  two.go(turning(0.0), kBreeze, kForever);
  CHECK(one.state == two.state);
}

TEST_CASE(
    "blade_states: steady options do not depend on time or states, and have equal equilibria") {
  const air::BladeAir steady = make(plate_air(kAtOnce, spatial::Stall::steady));
  const air::BladeAir lagging = make(plate_air(kLag, spatial::Stall::dynamic));
  AirRun one(steady), two(steady), three(lagging);
  one.go(turning(0.0), kBreeze, kForever);
  for (double& value : two.state) value = 7.0;
  for (const double elapsed : {0.0, 0.01, 5.0}) {
    two.go(turning(0.0), kBreeze, elapsed);
    CHECK(one.force() == two.force());
    CHECK(one.state == two.state);
  }
  three.go(turning(0.0), kBreeze, kForever);
  CHECK((one.force() - three.force()).norm() < 1e-12 * one.force().norm());
}

TEST_CASE("blade_states: no time leaves induced velocity and separation as they are") {
  const air::BladeAir blade = make(plate_air(kLag, spatial::Stall::dynamic));
  AirRun run(blade);
  run.go(turning(0.0), kBreeze, kForever);
  const AirRun before = run;
  run.go(turning(0.2), Vector3d(9.0, 0.0, 0.0), 0.0);
  CHECK(run.state == before.state);
  for (std::size_t i = 0; i < kPlaces.size(); ++i) {
    CHECK(run.seen[i].induced_axial == before.seen[i].induced_axial);
    CHECK(run.seen[i].induced_tangential == before.seen[i].induced_tangential);
    CHECK(run.seen[i].attack > before.seen[i].attack);
  }
}

TEST_CASE("blade_states: induced velocity can be held under all options") {
  for (const auto inflow : {kLag, kAtOnce}) {
    const air::BladeAir blade = make(plate_air(inflow, spatial::Stall::steady));
    AirRun run(blade);
    run.go(turning(0.0), kBreeze, kForever);
    const AirRun before = run;
    for (const double elapsed : {0.0, 1.0, kForever}) {
      run.go(turning(0.05), kBreeze, elapsed, true);
      for (std::size_t i = 0; i < kPlaces.size(); ++i)
        CHECK(run.seen[i].induced_axial == before.seen[i].induced_axial);
    }
  }
}

TEST_CASE("blade_states: a step in pitch overshoots in thrust and decays as Oye's filters") {
  const air::BladeAir blade = make(plate_air(kLag, spatial::Stall::steady));
  AirRun first(blade), last(blade);
  first.go(turning(0.0), kBreeze, kForever);
  last.go(turning(0.03), kBreeze, kForever);
  AirRun run = first;
  run.go(turning(0.03), kBreeze, 1e-9);  // the step
  const double begin = blade.thrust(first.seen), end = blade.thrust(last.seen);
  CHECK(end > begin);
  CHECK(blade.thrust(run.seen) > end + 0.3 * (end - begin));
  constexpr std::size_t place = 8;
  const double radius = blade.radius(), wind = kBreeze.x();
  const double from = -first.seen[place].induced_axial, to = -last.seen[place].induced_axial;
  REQUIRE(to / wind < 0.385);
  const double slow = 1.1 * radius / (wind - 1.3 * to);
  const double share = (2.0 + kPlaces[place]) / radius;
  const double fast = (0.39 - 0.26 * share * share) * slow;
  double thrust = blade.thrust(run.seen);
  for (int k = 1; k <= 40; ++k) {
    run.go(turning(0.03), kBreeze, 0.5);
    const double t = 0.5 * k;
    const double response =
        1.0 - std::exp(-t / fast) -
        0.4 * slow / (slow - fast) * (std::exp(-t / slow) - std::exp(-t / fast));
    CHECK(-run.seen[place].induced_axial ==
          doctest::Approx(from + (to - from) * response).epsilon(1e-6));
    CHECK(blade.thrust(run.seen) < thrust);
    thrust = blade.thrust(run.seen);
  }
  CHECK(thrust == doctest::Approx(end).epsilon(0.01));
}

TEST_CASE("blade_states: separation lags by four chords of flow, and lift with it") {
  spatial::Air air = plate_air(kAtOnce, spatial::Stall::dynamic);
  air.induction = spatial::Induction::none;
  constexpr double chord = 1.5, wind = 30.0;
  const air::BladeAir blade(
      make_blade(
          kPlaces, "plate", [&](double) { return chord; }, [](double) { return 0.0; }),
      air, 3, 2.0, kPlaces);
  const air::SectionPolar polar(air.airfoils[0], air.airfoils[0], 0.0);
  const auto level = polar.level(0.0);
  AirRun run(blade);
  const Vector3d flow(0.0, wind, 0.0);  // from ahead
  run.go({.pitch = 0.1}, flow, kForever);
  const double first = polar.values(level, 0.1).separation;
  CHECK(first == approx(1.0));
  run.go({.pitch = 0.35}, flow, 0.0);
  const air::PolarValues stalled = polar.values(level, 0.35);
  CHECK(stalled.separation < 0.6);
  CHECK(run.seen[5].lift == approx(stalled.lift + (1.0 - stalled.separation) * stalled.recovery));
  CHECK(run.seen[5].lift > 1.1 * stalled.lift);
  run.go({.pitch = 0.35}, flow, 1e-12);  // the step
  const double constant = 4.0 * chord / wind;
  double t = 0.0;
  for (const double step : {0.02, 0.1, 0.3}) {
    run.go({.pitch = 0.35}, flow, step);
    t += step;
    const double f = stalled.separation + (first - stalled.separation) * std::exp(-t / constant);
    CHECK(run.seen[5].lift == approx(stalled.lift + (f - stalled.separation) * stalled.recovery));
  }
  run.go({.pitch = 0.35}, flow, kForever);
  CHECK(run.seen[5].lift == approx(stalled.lift));
}

TEST_CASE("blade_states: of second order in the step in wind that varies") {
  const air::BladeAir blade = make(plate_air(kLag, spatial::Stall::dynamic));
  constexpr double end = 4.0;
  constexpr int places = 8;  // at which thrust is compared
  const auto thrusts = [&](int steps) {
    std::vector<double> seen;
    AirRun run(blade);
    const auto wind = [](double t) { return Vector3d(8.0 + 0.5 * std::sin(1.5 * t), 0.0, 0.0); };
    run.go(turning(0.02), wind(0.0), kForever);
    for (int k = 1; k <= steps; ++k) {
      run.go(turning(0.02), wind(end * k / steps), end / steps);
      if (k % (steps / places) == 0) seen.push_back(blade.thrust(run.seen));
    }
    return seen;
  };
  const std::vector<double> exact = thrusts(800);
  const auto error = [&](int steps) {
    const std::vector<double> coarse = thrusts(steps);
    double sum = 0.0;
    for (int k = 0; k < places; ++k) sum += std::abs(coarse[k] - exact[k]);
    return sum;
  };
  CHECK(error(16) / error(32) == doctest::Approx(4.0).epsilon(0.15));
  CHECK(error(32) < 1e-3 * exact[0]);
}

TEST_CASE("blade_states: a rotor that stops in still air loses its induced velocity") {
  const air::BladeAir blade = make(plate_air(kLag, spatial::Stall::dynamic));
  AirRun run(blade);
  run.go(turning(0.2), Vector3d::Zero(), kForever);  // hovers
  CHECK(run.force().x() > 0.0);
  const BladePlace stopped{.hub_radius = 2.0};
  double before = run.seen[6].induced_axial;
  CHECK(before < -0.5);
  for (int k = 0; k < 400; ++k) run.go(stopped, Vector3d::Zero(), 1.0);
  CHECK(std::abs(run.seen[6].induced_axial) < 0.2 * std::abs(before));
}

namespace {

constexpr double kChord = 1.5;

/// A plate in the plane of a rotor that stands, without induction.
air::BladeAir unsteady_plate() {
  spatial::Air air = plate_air(kAtOnce, spatial::Stall::steady);
  air.induction = spatial::Induction::none;
  air.attached_flow = spatial::AttachedFlow::unsteady;
  return {make_blade(
              kPlaces, "plate", [](double) { return kChord; }, [](double) { return 0.0; }),
          air, 3, 2.0, kPlaces};
}

}  // namespace

TEST_CASE("blade_states: lift after a step in pitch grows by Wagner's function") {
  const air::BladeAir blade = unsteady_plate();
  constexpr double wind = 40.0, small = 1e-5;
  const auto place = [](double pitch) { return BladePlace{.pitch = pitch, .hub_radius = 2.0}; };
  const Vector3d ahead(0.0, -wind, 0.0);
  constexpr std::size_t station = 6;
  const auto lift_after = [&](double pitch, double time) {
    AirRun run(blade);
    run.go(place(0.0), ahead, kForever);
    run.go(place(pitch), ahead, 1e-12);
    if (time > 0.0) run.go(place(pitch), ahead, time);
    return run.seen[station].lift;
  };
  AirRun first(blade), last(blade);
  first.go(place(0.0), ahead, kForever);
  last.go(place(small), ahead, kForever);
  const double from = first.seen[station].lift, to = last.seen[station].lift;
  REQUIRE(std::abs(to - from) > 1e-6);
  const double speed = first.seen[station].relative_speed;
  CHECK(speed == approx(wind));
  for (const double travel : {0.0, 0.5, 2.0, 10.0, 50.0, 400.0}) {  // in half chords
    const double time = travel * 0.5 * kChord / speed;
    const double share = (lift_after(small, time) - from) / (to - from);
    const double wagner =
        1.0 - 0.165 * std::exp(-0.0455 * travel) - 0.335 * std::exp(-0.3 * travel);
    CAPTURE(travel);
    CHECK(share == doctest::Approx(wagner).epsilon(1e-3));
  }
}

TEST_CASE("blade_states: lift in oscillation has the size and the lag of Theodorsen's function") {
  const air::BladeAir blade = unsteady_plate();
  constexpr double wind = 40.0, small = 1e-5;
  const Vector3d ahead(0.0, -wind, 0.0);
  constexpr std::size_t station = 6;
  // C(k) by reduced frequency: Theodorsen, NACA report 496 (1935), table II.
  struct Row {
    double k, real, imaginary;
  };
  for (const Row& row : {Row{0.05, 0.9090, -0.1306}, Row{0.1, 0.8320, -0.1723},
                         Row{0.3, 0.6650, -0.1793}, Row{0.6, 0.5788, -0.1378}}) {
    const double frequency = row.k * wind / (0.5 * kChord), step = 2e-3 / frequency;
    AirRun run(blade);
    // A plunge in place of a pitch, which would turn the flow along the chord, too: the wind's.
    const auto wind_at = [&](double t) {
      return Vector3d(wind * small * std::sin(frequency * t), -wind, 0.0);
    };
    const BladePlace place{.hub_radius = 2.0};
    run.go(place, wind_at(0.0), kForever);
    const double mean = run.seen[station].lift;
    std::complex<double> sum = 0.0, quasi = 0.0;
    AirRun still(blade);
    still.go(place, Vector3d(wind * small, -wind, 0.0), kForever);
    const double amplitude = still.seen[station].lift - mean;
    const double period = 2.0 * std::numbers::pi / frequency;
    const int steps = static_cast<int>(std::round(period / step));
    const int transient = steps * static_cast<int>(std::ceil(60.0 * row.k + 3.0));
    for (int n = 1; n <= transient + steps; ++n) {
      const double t = n * period / steps;
      run.go(place, wind_at(t), period / steps);
      if (n <= transient) continue;
      const std::complex<double> turn = std::polar(1.0, -frequency * t);
      sum += (run.seen[station].lift - mean) * turn;
      quasi += amplitude * std::sin(frequency * t) * turn;
    }
    const std::complex<double> c = sum / quasi;
    CAPTURE(row.k);
    // Jones's approximation is within 0.02 of the function.
    CHECK(std::abs(c.real() - row.real) < 0.02);
    CHECK(std::abs(c.imag() - row.imaginary) < 0.02);
    using namespace std::complex_literals;
    const std::complex<double> jones =
        1.0 - 0.165 / (1.0 - 0.0455i / row.k) - 0.335 / (1.0 - 0.3i / row.k);
    CHECK(std::abs(c - jones) < 1e-4);
  }
}

TEST_CASE("blade_states: unsteady attached flow is at rest where nothing moves, and goes on") {
  spatial::Air air = plate_air(kLag, spatial::Stall::dynamic);
  const air::BladeAir steady = make(air);
  air.attached_flow = spatial::AttachedFlow::unsteady;
  const air::BladeAir unsteady = make(air);
  CHECK(unsteady.state_size() ==
        steady.state_size() / air::kStates * (air::kStates + air::kShedStates));
  AirRun one(steady), two(unsteady);
  one.go(turning(0.02), kBreeze, kForever);
  two.go(turning(0.02), kBreeze, kForever);
  CHECK(one.force() == two.force());
  two.go(turning(0.02), kBreeze, 0.1);
  CHECK((one.force() - two.force()).norm() < 1e-12 * one.force().norm());
  // No time leaves what the shed wake induces; half of a sudden angle is felt at once.
  AirRun jumped = two, later = two;
  jumped.go(turning(0.021), kBreeze, 0.0);
  const std::vector<double> before = two.state;
  CHECK(jumped.state == before);
  later.go(turning(0.021), kBreeze, 1e-9);
  CHECK((jumped.force() - later.force()).norm() < 1e-4 * jumped.force().norm());
}
