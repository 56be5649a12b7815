// Whole rotors against closed forms of momentum theory.

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "engine/bodies/air/rotor_coefficients.h"
#include "tests/approx.h"
#include "tests/engine/bodies/air/rigid_blade.h"

using namespace spoke;
using namespace spoke::test;
using Eigen::Vector3d;
using spoke::testing::approx;

namespace {

constexpr double kHalfTurn = std::numbers::pi;
constexpr int kBlades = 500;  // so many that nothing is lost at tip and root

double disc_area(double inner, double outer) { return kHalfTurn * (outer * outer - inner * inner); }

}  // namespace

TEST_CASE("rotor: the ideal turbine reaches Betz' limit, and Glauert's where it turns slowly") {
  // Chord for Glauert's optimum at each radius, of an aerofoil of lift 1 at any angle, without
  // drag.
  constexpr double wind = 10.0, root = 0.5, radius = 50.0;
  const spatial::Air air = steady_air({make_airfoil(
      "ideal", [](double) { return 1.0; }, 0.0)});
  // C_P by tip-speed ratio from Glauert's table (1935), which spans the whole disc.
  const std::pair<double, double> table[] = {
      {1.0, 0.416}, {2.0, 0.512}, {5.0, 0.570}, {60.0, 0.592}};
  for (const auto& row : table) {
    const double ratio = row.first, expected = row.second;
    const double speed = ratio * wind / radius;
    const auto chord = [&](double station) {
      const double r = root + station;
      const double angle = 2.0 / 3.0 * std::atan(wind / (speed * r));
      return 8.0 * kHalfTurn * r * (1.0 - std::cos(angle)) / kBlades;
    };
    const std::vector<double> stations = spread(0.0, radius - root, 400);
    std::vector<double> longer = stations;
    longer.back() += 0.2;
    const air::BladeAir blade(make_blade(longer, "ideal", chord, [](double) { return 0.0; }), air,
                              kBlades, root, stations);
    AirRun run(blade);
    run.go({.speed = speed, .hub_radius = root}, {wind, 0.0, 0.0}, kForever);
    const air::RotorCoefficients c =
        air::calc_wind_coefficients({kBlades * blade.thrust(run.seen),
                                     kBlades * blade.torque(run.seen), speed, radius, air.density},
                                    wind);
    CAPTURE(ratio);
    CHECK(c.power < 16.0 / 27.0);
    CHECK(c.power == doctest::Approx(expected).epsilon(0.006));
    CHECK(c.power == approx(c.torque * ratio));
    if (ratio > 50.0) {
      CHECK(c.thrust == doctest::Approx(8.0 / 9.0).epsilon(0.01));
      CHECK(run.seen[200].axial_induction == doctest::Approx(1.0 / 3.0).epsilon(1e-3));
    }
  }
}

TEST_CASE("rotor: a blade of ideal twist hovers with uniform inflow, and its figure of merit") {
  constexpr double radius = 6.0, root = 0.6, speed = 80.0, chord_sum = 1.2, tip_pitch = 0.02;
  constexpr double drag = 0.008;
  for (const double drag_now : {0.0, drag}) {
    const spatial::Air air = steady_air({make_airfoil("plate", plate_lift, drag_now)});
    const std::vector<double> stations = spread(0.0, radius - root, 300);
    std::vector<double> longer = stations;
    longer.back() += 0.01;
    const auto twist = [&](double station) { return tip_pitch * radius / (root + station); };
    const air::BladeAir blade(
        make_blade(
            longer, "plate", [&](double) { return chord_sum / kBlades; }, twist),
        air, kBlades, root, stations);
    AirRun run(blade);
    run.go({.speed = speed, .hub_radius = root}, Vector3d::Zero(), kForever);
    // Inflow by blade elements and momentum with a lift slope of 2 pi (Gessow & Myers):
    const double solidity = chord_sum / (kHalfTurn * radius), slope = 2.0 * kHalfTurn;
    const double inflow =
        solidity * slope / 16.0 * (std::sqrt(1.0 + 32.0 * tip_pitch / (solidity * slope)) - 1.0);
    const double induced = inflow * speed * radius;
    for (std::size_t i = 50; i < stations.size() - 5; i += 10)
      CHECK(-run.seen[i].induced_axial == doctest::Approx(induced).epsilon(0.01));
    // Thrust by blade elements; by momentum it is that of the induced velocity.
    const double thrust = kBlades * blade.thrust(run.seen);
    const double share = 1.0 - std::pow(root / radius, 2);
    const double tip = speed * radius;
    const double by_elements = solidity * slope / 4.0 * (tip_pitch - inflow) * share * air.density *
                               disc_area(0.0, radius) * tip * tip;
    CHECK(thrust == doctest::Approx(by_elements).epsilon(0.01));
    CHECK(std::sqrt(thrust / (2.0 * air.density * disc_area(root, radius))) ==
          doctest::Approx(induced).epsilon(0.01));
    // Power: induced, and of the sections' drag.
    const air::RotorCoefficients c = air::calc_tip_coefficients(
        {thrust, kBlades * blade.torque(run.seen), speed, radius, air.density});
    const double profile = solidity * drag_now / 8.0 * (1.0 - std::pow(root / radius, 4));
    CHECK(c.power == approx(c.torque));
    CHECK(c.power == doctest::Approx(c.thrust * inflow + profile).epsilon(0.01));
    const double merit = std::pow(c.thrust, 1.5) / std::sqrt(2.0) / c.power;
    const double ideal = std::pow(c.thrust, 1.5) / std::sqrt(2.0 * share);
    CHECK(merit == doctest::Approx(ideal * std::sqrt(share) / (ideal + profile)).epsilon(0.01));
  }
}

TEST_CASE("rotor: tip and root losses lower the thrust by Prandtl's factor") {
  // Three blades lose where 500 with the same area do not.
  const std::vector<double> stations = spread(0.0, 20.0, 80);
  const spatial::Air air = steady_air({make_airfoil("plate", plate_lift, 0.0)});
  const auto thrust = [&](int blades) {
    const air::BladeAir blade(
        make_blade(
            stations, "plate", [&](double) { return 3.0 / blades; }, [](double) { return -0.05; }),
        air, blades, 2.0, stations);
    AirRun run(blade);
    run.go({.speed = 3.0, .hub_radius = 2.0}, {8.0, 0.0, 0.0}, kForever);
    // At the tip itself lift goes to that of the empirical curve, not beyond.
    CHECK(run.seen.back().axial_induction > run.seen[40].axial_induction);
    CHECK(run.seen.front().axial_induction > run.seen[20].axial_induction);
    return blades * blade.thrust(run.seen);
  };
  const double few = thrust(3), many = thrust(kBlades);
  CHECK(few < 0.98 * many);
  CHECK(few > 0.8 * many);
}

TEST_CASE("rotor: standing, idling, turning backward and in a vortex ring all is finite") {
  const std::vector<double> stations = spread(0.0, 20.0, 15);
  spatial::Air air = steady_air({make_airfoil("plate", plate_lift, 0.01, -0.05)});
  for (const bool dynamic : {false, true}) {
    air.inflow = dynamic ? spatial::Inflow::dynamic : spatial::Inflow::quasi_steady;
    air.stall = dynamic ? spatial::Stall::dynamic : spatial::Stall::steady;
    const air::BladeAir blade(make_blade(
                                  stations, "plate", [](double s) { return s > 19.0 ? 0.0 : 1.0; },
                                  [](double s) { return 0.2 - 0.01 * s; }),
                              air, 3, 0.0, stations);
    AirRun run(blade);
    for (const double speed : {0.0, 1e-9, 2.0, -2.0, 30.0})
      for (const double axial : {0.0, 1e-12, 5.0, -5.0, 20.0, 1e3})
        for (const double across : {0.0, 1e-9, 30.0})
          for (const double pitch : {0.0, 1.5, -3.0}) {
            run.go({.speed = speed, .azimuth = 0.3, .pitch = pitch}, {axial, across, 0.0},
                   kForever);
            run.go({.speed = speed, .azimuth = 0.4, .pitch = pitch}, {axial, across, 1.0}, 0.1);
            CHECK(run.force().allFinite());
            for (const double value : run.state) CHECK(std::isfinite(value));
          }
  }
}

TEST_CASE("rotor: coefficients are none where there is nothing to divide by") {
  CHECK(air::calc_wind_coefficients({1.0, 1.0, 1.0, 1.0, 1.2}, 0.0).power == 0.0);
  CHECK(air::calc_tip_coefficients({1.0, 1.0, 0.0, 1.0, 1.2}).thrust == 0.0);
  const air::RotorCoefficients c = air::calc_wind_coefficients({2.0, 3.0, 4.0, 5.0, 1.5}, 6.0);
  const double force = 0.5 * 1.5 * kHalfTurn * 25.0 * 36.0;
  CHECK(c.thrust == approx(2.0 / force));
  CHECK(c.torque == approx(3.0 / (force * 5.0)));
  CHECK(c.power == approx(3.0 * 4.0 / (force * 6.0)));
}

TEST_CASE("rotor: what yaw costs by the flow that carries air through the disc") {
  // A fast rotor of 100 blades, of even lift: the wind in its plane hardly changes the flow from
  // ahead.
  constexpr double wind = 10.0, root = 2.0, radius = 50.0, speed = 20.0, kLoad = 0.6;
  constexpr int blades = 100;
  const std::vector<double> stations = spread(0.0, radius - root, 49);
  const auto chord = [](double station) {
    return 2.0 * kHalfTurn * kLoad * wind * wind /
           (blades * speed * speed * (root + station) * 0.9);
  };
  const auto mean_power = [&](spatial::MassFlow flow, double yaw) {
    spatial::Air air = steady_air({make_airfoil(
        "even", [](double) { return 0.9; }, 0.0)});
    air.mass_flow = flow;
    const air::BladeAir blade(make_blade(stations, "even", chord, [](double) { return 0.0; }), air,
                              blades, root, stations);
    AirRun run(blade);
    double power = 0.0;
    constexpr int azimuths = 36;
    for (int k = 0; k < azimuths; ++k) {
      run.go({.speed = speed, .azimuth = 2.0 * kHalfTurn * k / azimuths, .hub_radius = root},
             {wind * std::cos(yaw), wind * std::sin(yaw), 0.0}, kForever);
      power += blade.torque(run.seen) * speed / azimuths;
    }
    return power;
  };
  // With the same lift it has the same thrust T = 2 rho A v |w|, w the velocity through the disc or
  // the part of it normal to the disc, and the power T (U - v).
  const auto calc_share = [](bool counts_plane, double yaw) {
    const double normal = std::cos(yaw), plane = counts_plane ? std::sin(yaw) : 0.0;
    double low = 0.0, high = 0.5 * normal;  // by the wind
    for (int k = 0; k < 100; ++k) {
      const double v = 0.5 * (low + high);
      (4.0 * v * std::hypot(plane, normal - v) < kLoad ? low : high) = v;
    }
    return kLoad * (normal - low);
  };
  constexpr double yaw = 20.0 * kHalfTurn / 180.0;
  for (const spatial::MassFlow flow : {spatial::MassFlow::glauert, spatial::MassFlow::normal}) {
    const bool counts_plane = flow == spatial::MassFlow::glauert;
    CAPTURE(counts_plane);
    CHECK(mean_power(flow, yaw) / mean_power(flow, 0.0) ==
          doctest::Approx(calc_share(counts_plane, yaw) / calc_share(counts_plane, 0.0))
              .epsilon(2e-3));
  }
  CHECK(mean_power(spatial::MassFlow::glauert, 0.0) == mean_power(spatial::MassFlow::normal, 0.0));
  CHECK(mean_power(spatial::MassFlow::glauert, yaw) >
        1.03 * mean_power(spatial::MassFlow::normal, yaw));
}
