// Loads of a blade: directions, sizes, sums, and what they do not depend on.

#include "engine/bodies/air/blade_air.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "tests/approx.h"
#include "tests/engine/bodies/air/rigid_blade.h"
#include "tests/message_of.h"

using namespace spoke;
using namespace spoke::test;
using Eigen::Vector3d;
using spoke::testing::approx;

namespace {

constexpr double kPi = std::numbers::pi;

/// Air of one plate without induction.
spatial::Air still_air(double drag, double moment = 0.0) {
  spatial::Air air = steady_air({make_airfoil("plate", plate_lift, drag, moment)});
  air.induction = spatial::Induction::none;
  return air;
}

const std::vector<double> kStations = spread(0.0, 10.0, 11);

spatial::BladeAerodynamics constant_blade(double chord, double twist, double center) {
  spatial::BladeAerodynamics blade = make_blade(
      kStations, "plate", [&](double) { return chord; }, [&](double) { return twist; });
  for (double& place : blade.center) place = center;
  return blade;
}

double norm_of(const Vector3d& a, const Vector3d& b) { return (a - b).norm(); }

}  // namespace

TEST_CASE("blade_air: a standing blade in wind has lift and drag of its sections") {
  constexpr double chord = 0.7, twist = 0.1, wind = 12.0, drag = 0.02, moment = -0.04, ahead = 0.15;
  const spatial::Air air = still_air(drag, moment);
  const air::BladeAir blade(constant_blade(chord, twist, ahead), air, 2, 1.0, kStations);
  CHECK(blade.count() == 11);
  CHECK(blade.radius() == 11.0);
  AirRun run(blade);
  // From ahead, which is along -y at azimuth 0: the flow goes along +y.
  const BladePlace place{.hub_radius = 1.0};
  run.go(place, {0.0, wind, 0.0}, kForever);
  const double pressure = 0.5 * air.density * wind * wind * chord;
  const double lift = plate_lift(twist);
  CHECK(run.seen[3].attack == approx(twist));
  CHECK(run.seen[3].relative_speed == approx(wind));
  CHECK(run.seen[3].lift == doctest::Approx(lift).epsilon(1e-4));
  CHECK(norm_of(run.force(), 10.0 * pressure * Vector3d(run.seen[3].lift, drag, 0.0)) < 1e-9);
  // Nose-up moment about the section's axis: of the coefficient, and of forces ahead of the axis.
  const double by_forces =
      ahead * (run.seen[3].lift * std::cos(twist) + drag * std::sin(twist)) * pressure;
  CHECK(run.seen[3].pitching_moment == approx(pressure * chord * moment + by_forces));
  CHECK(run.loads[5].moment.z() == approx(run.seen[5].pitching_moment));  // by 1 m of blade
  // From behind it lifts little; broadside it is pushed along.
  run.go(place, {0.0, -wind, 0.0}, kForever);
  CHECK(std::abs(run.seen[3].attack) > 3.0);
  run.go(place, {wind, 0.0, 0.0}, kForever);
  CHECK(run.seen[3].attack == approx(0.5 * kPi + twist));
  CHECK(run.force().x() == approx(10.0 * pressure * drag));
}

TEST_CASE("blade_air: air that is at rest against a blade, but for rounding, does nothing") {
  const spatial::Air air = steady_air({make_airfoil("plate", plate_lift, 0.02, -0.05)});
  const air::BladeAir blade(constant_blade(0.5, 0.7, 0.1), air, 3, 1.0, kStations);
  AirRun run(blade);
  const auto go = [&](const Vector3d& velocity, const Vector3d& wind) {
    std::vector<MarkerMotion> sections =
        move_blade({.azimuth = 0.4, .cone = -0.3}, blade.stations());
    for (MarkerMotion& section : sections) section.velocity += velocity;
    const air::RotorPlace rotor{Vector3d::Zero(), Vector3d::UnitX(), velocity, 0.0, wind};
    blade.evaluate(rotor, sections, std::vector<Vector3d>(blade.count(), wind), kForever,
                   run.state.data(), run.state.data(), run.loads, run.seen, false);
  };
  const Vector3d velocity(0.3, -0.6, 0.7);
  const Vector3d wind(0.1 + 0.2, -(0.1 + 0.5), 0.8 - 0.1);  // the same, but for the last bits
  REQUIRE(wind != velocity);
  go(velocity, wind);
  for (const air::StationAir& seen : run.seen) {
    CHECK(seen.attack == 0.0);
    CHECK(seen.axial_induction == 0.0);
    CHECK(seen.tangential_induction == 0.0);
    CHECK(seen.lift == plate_lift(0.0));
  }
  CHECK(run.force().isZero(0.0));
  // Along the axis it meets a rotor that stands as it does where nothing moves.
  go(velocity, wind + 8.0 * Vector3d::UnitX());
  const std::vector<air::StationAir> moving = run.seen;
  go(Vector3d::Zero(), {8.0, 0.0, 0.0});
  for (std::size_t k = 0; k < moving.size(); ++k) {
    CHECK(moving[k].attack == approx(run.seen[k].attack));
    CHECK(moving[k].axial_induction == approx(run.seen[k].axial_induction));
    CHECK(moving[k].tangential_induction == 0.0);  // air comes along the axis alone
    CHECK(run.seen[k].tangential_induction == 0.0);
  }
}

TEST_CASE("blade_air: flow along the blade does not count") {
  const air::BladeAir blade(constant_blade(0.5, 0.05, 0.0), still_air(0.01), 2, 1.0, kStations);
  AirRun run(blade), along(blade);
  run.go({}, {3.0, 9.0, 0.0}, kForever);
  along.go({}, {3.0, 9.0, 40.0}, kForever);
  CHECK(norm_of(run.force(), along.force()) < 1e-12);
}

TEST_CASE("blade_air: a section that turns nose up has the lift of its three-quarter chord point") {
  constexpr double chord = 0.5, wind = 20.0, rate = 2.0;
  const air::BladeAir blade(constant_blade(chord, 0.02, 0.0), still_air(0.0), 2, 1.0, kStations);
  AirRun still(blade), turning(blade);
  still.go({}, {0.0, wind, 0.0}, kForever);
  turning.go({.pitch_rate = rate}, {0.0, wind, 0.0}, kForever);
  const double rise = std::atan(0.5 * chord * rate / wind);  // about the aerodynamic centre
  CHECK(turning.seen[4].lift - still.seen[4].lift ==
        doctest::Approx(2.0 * kPi * rise).epsilon(0.003));
  // It points across the wind all the same.
  CHECK(std::abs(turning.force().y()) < 1e-9);
}

TEST_CASE("blade_air: loads of stations have the sum and moment of loads that are linear between") {
  spatial::Air air = steady_air({make_airfoil("plate", plate_lift, 0.01, -0.05)});
  const std::vector<double> stations{0.0, 0.3, 1.7, 2.0, 5.0, 5.5, 9.0, 10.0};
  const air::BladeAir blade(constant_blade(0.6, -0.1, 0.05), air, 3, 1.5, stations);
  AirRun run(blade);
  const BladePlace place{.speed = 4.0, .azimuth = 0.7, .hub_radius = 1.5};
  run.go(place, {9.0, 0.0, 0.0}, kForever);
  double thrust = 0.0, torque = 0.0;
  constexpr int parts = 1000;
  for (std::size_t i = 0; i + 1 < stations.size(); ++i)
    for (int k = 0; k < parts; ++k) {
      const double share = (k + 0.5) / parts, length = (stations[i + 1] - stations[i]) / parts;
      const auto value = [&](double air::StationAir::*member) {
        return run.seen[i].*member + share * (run.seen[i + 1].*member - run.seen[i].*member);
      };
      thrust += length * value(&air::StationAir::axial_force);
      torque +=
          length * (value(&air::StationAir::radius) * value(&air::StationAir::tangential_force) +
                    value(&air::StationAir::axial_moment));
    }
  CHECK(blade.thrust(run.seen) == approx(thrust));
  CHECK(blade.torque(run.seen) == approx(torque));
  CHECK(run.force().x() == approx(thrust));
  CHECK(run.moment(place).x() == approx(torque));
}

TEST_CASE("blade_air: thrust and torque of a coned rotor are those of its forces, at any azimuth") {
  const air::BladeAir blade(constant_blade(0.6, -0.1, 0.05),
                            steady_air({make_airfoil("plate", plate_lift, 0.01, -0.05)}), 3, 1.5,
                            kStations);
  AirRun run(blade), other(blade);
  const BladePlace place{.speed = 4.0, .azimuth = 0.7, .cone = -0.1, .hub_radius = 1.5};
  BladePlace turned = place;
  turned.azimuth = 2.9;
  run.go(place, {9.0, 0.0, 0.0}, kForever);
  other.go(turned, {9.0, 0.0, 0.0}, kForever);
  CHECK(run.force().x() == approx(blade.thrust(run.seen)));
  CHECK(run.moment(place).x() == approx(blade.torque(run.seen)));
  CHECK(other.force().x() == approx(run.force().x()));
  CHECK(other.moment(turned).x() == approx(run.moment(place).x()));
  CHECK(run.seen[10].radius == approx(11.5 * std::cos(0.1)));
}

TEST_CASE("blade_air: a rotor that turns the other way round is the image in a mirror") {
  spatial::BladeAerodynamics forward = constant_blade(0.6, -0.1, 0.05), backward = forward;
  backward.leads_backward = true;
  const spatial::Air air = steady_air({make_airfoil("plate", plate_lift, 0.01, -0.05)});
  const air::BladeAir one(forward, air, 3, 1.5, kStations), two(backward, air, 3, 1.5, kStations);
  AirRun run(one), image(two);
  const BladePlace place{.speed = 4.0, .cone = 0.05, .pitch = 0.03, .hub_radius = 1.5};
  BladePlace mirrored = place;
  mirrored.speed = -4.0;
  mirrored.backward = true;
  run.go(place, {9.0, 1.0, 2.0}, kForever);
  image.go(mirrored, {9.0, -1.0, 2.0}, kForever);
  for (std::size_t i = 0; i < kStations.size(); ++i) {
    const Vector3d f = run.loads[i].force, m = run.loads[i].moment;
    CHECK(norm_of(image.loads[i].force, Vector3d(f.x(), -f.y(), f.z())) < 1e-9 * f.norm());
    CHECK(norm_of(image.loads[i].moment, Vector3d(-m.x(), m.y(), -m.z())) < 1e-9 * m.norm());
    CHECK(image.seen[i].attack == approx(run.seen[i].attack));
    CHECK(image.seen[i].tangential_force == approx(run.seen[i].tangential_force));
    CHECK(image.seen[i].pitching_moment == approx(-run.seen[i].pitching_moment));
  }
  CHECK(two.torque(image.seen) == approx(one.torque(run.seen)));
}

TEST_CASE("blade_air: a rotor that moves with the wind is a rotor at rest in none") {
  const air::BladeAir blade(constant_blade(0.6, 0.1, 0.0),
                            steady_air({make_airfoil("plate", plate_lift, 0.01)}), 3, 1.5,
                            kStations);
  AirRun run(blade), moving(blade);
  const BladePlace place{.speed = 4.0, .azimuth = 1.0, .hub_radius = 1.5};
  const Vector3d wind(6.0, 3.0, -2.0), drift(-2.0, 5.0, 1.0);
  run.go(place, wind, kForever);
  std::vector<MarkerMotion> motion = move_blade(place, kStations);
  for (MarkerMotion& section : motion) section.velocity += drift;
  const std::vector<Vector3d> winds(kStations.size(), wind + drift);
  blade.evaluate({Vector3d::Zero(), Vector3d::UnitX(), drift, 4.0, wind + drift}, motion, winds,
                 kForever, moving.state.data(), moving.state.data(), moving.loads, {});
  CHECK(norm_of(run.force(), moving.force()) < 1e-9 * run.force().norm());
}

TEST_CASE("blade_air: in yaw the blade downstream has more induction") {
  const air::BladeAir blade(constant_blade(0.4, -0.1, 0.0),
                            steady_air({make_airfoil("plate", plate_lift, 0.0)}), 3, 1.0,
                            kStations);
  AirRun up(blade), down(blade), side(blade);
  const Vector3d wind(9.0, 0.0, 3.0);
  const auto induction = [&](AirRun& run, double azimuth) {
    run.go({.speed = 5.0, .azimuth = azimuth, .hub_radius = 1.0}, wind, kForever);
    return -run.seen[8].induced_axial;
  };
  const double downstream = induction(down, 0.0), upstream = induction(up, kPi);
  const double plain = 0.5 * (downstream + upstream);
  CHECK(downstream > 1.1 * upstream);
  // tan chi by the flow through the disc; the gain at this radius.
  const double half = 3.0 / (std::hypot(3.0, 9.0 - plain) + 9.0 - plain);
  CHECK(downstream / plain - 1.0 ==
        doctest::Approx(15.0 * kPi / 32.0 * half * 9.0 / 11.0).epsilon(1e-6));
}

TEST_CASE("blade_air: equal arguments give equal bits, in place or not") {
  spatial::Air air = steady_air({make_airfoil("plate", plate_lift, 0.01)});
  air.inflow = spatial::Inflow::dynamic;
  air.stall = spatial::Stall::dynamic;
  const air::BladeAir blade(constant_blade(0.6, -0.1, 0.0), air, 3, 1.5, kStations);
  AirRun one(blade);
  const BladePlace place{.speed = 4.0, .hub_radius = 1.5};
  one.go(place, {9.0, 0.0, 0.0}, kForever);
  AirRun two = one;
  one.go(place, {7.0, 1.0, 0.0}, 0.02);
  const std::vector<Vector3d> winds(kStations.size(), Vector3d(7.0, 1.0, 0.0));
  std::vector<double> after(two.state.size());
  blade.evaluate({Vector3d::Zero(), Vector3d::UnitX(), Vector3d::Zero(), 4.0, winds[0]},
                 move_blade(place, kStations), winds, 0.02, two.state.data(), after.data(),
                 two.loads, {});
  CHECK(after == one.state);
  for (std::size_t i = 0; i < kStations.size(); ++i) {
    CHECK(one.loads[i].force == two.loads[i].force);
    CHECK(one.loads[i].moment == two.loads[i].moment);
  }
}

TEST_CASE("blade_air: aerofoils must be there, and well") {
  const auto make = [](const spatial::Air& air) {
    return message_of(
        [&] { air::BladeAir(constant_blade(1.0, 0.0, 0.0), air, 2, 1.0, kStations); });
  };
  spatial::Air air = still_air(0.0);
  CHECK(make(air) == "no error");
  air.airfoils[0].polars[0].drag[5] = -1.0;
  CHECK(make(air).starts_with("aerofoil \"plate\": polar 1: row 6: drag is -1"));
  air.airfoils[0].name = "board";
  CHECK(make(air) == "aerofoil \"plate\" is none of those given");
}
