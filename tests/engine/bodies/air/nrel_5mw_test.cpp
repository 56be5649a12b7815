// The NREL 5-MW rotor with rigid blades against its published performance.

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "engine/bodies/air/blade_air.h"
#include "models/air/airfoil_reader.h"
#include "tests/engine/bodies/air/rigid_blade.h"

using namespace spoke;
using namespace spoke::test;

namespace {

constexpr double kOneDegree = std::numbers::pi / 180.0;

/// Blade by Jonkman, Butterfield, Musial & Scott, NREL/TP-500-38060 (2009), table 3-1; its ends as
/// the stations beside them.
spatial::BladeAerodynamics make_nrel_blade() {
  spatial::BladeAerodynamics blade;
  blade.station = {0.0,   1.3667, 4.1,   6.8333, 10.25, 14.35,   18.45, 22.55,   26.65, 30.75,
                   34.85, 38.95,  43.05, 47.15,  51.25, 54.6667, 57.4,  60.1333, 61.5};
  blade.chord = {3.542, 3.542, 3.854, 4.167, 4.557, 4.652, 4.458, 4.249, 4.007, 3.748,
                 3.502, 3.256, 3.010, 2.764, 2.518, 2.313, 2.086, 1.419, 1.419};
  const double twist[] = {13.308, 13.308, 13.308, 13.308, 13.308, 11.480, 10.162,
                          9.011,  7.795,  6.544,  5.361,  4.188,  3.125,  2.319,
                          1.526,  0.863,  0.370,  0.106,  0.106};
  for (const double angle : twist) blade.twist.push_back(-angle * kOneDegree);
  const char* names[] = {"cylinder1", "cylinder1", "cylinder1", "cylinder2", "du40",
                         "du35",      "du35",      "du30",      "du25",      "du25",
                         "du21",      "du21",      "naca64",    "naca64",    "naca64",
                         "naca64",    "naca64",    "naca64",    "naca64"};
  for (const char* name : names) blade.airfoil.emplace_back(name);
  blade.center.assign(blade.station.size(), 0.0);
  return blade;
}

spatial::Air make_nrel_air() {
  std::vector<spatial::Airfoil> airfoils;
  for (const char* name :
       {"cylinder1", "cylinder2", "du40", "du35", "du30", "du25", "du21", "naca64"})
    airfoils.push_back(air::read_airfoil(
        std::string(SPOKE_MODELS_DIR) + "/airfoils/nrel_5mw/" + name + ".txt", name));
  return steady_air(airfoils);
}

air::BladeAir make_nrel(const spatial::Air& air) {
  return {make_nrel_blade(), air, 3, 1.5, spread(0.0, 61.5, 50)};
}

}  // namespace

TEST_CASE("nrel_5mw: power and thrust of rigid blades over wind, within 3 %") {
  const air::BladeAir blade = make_nrel(make_nrel_air());
  struct Row {
    double wind, speed, electric, thrust;  // m/s, rpm, kW, kN
  };
  // Of NREL's tables of reference turbines; electric power is 0.944 of the rotor's.
  for (const Row& row : {Row{5.0, 7.506, 403.9, 174.88}, Row{8.0, 9.156, 1771.17, 384.0},
                         Row{10.0, 11.431, 3448.38, 597.48}}) {
    const BladePlace place{
        .speed = row.speed * std::numbers::pi / 30.0, .cone = -2.5 * kOneDegree, .hub_radius = 1.5};
    AirRun run(blade);
    run.go(place, {row.wind, 0.0, 0.0}, kForever);
    CAPTURE(row.wind);
    CHECK(0.944e-3 * 3.0 * run.moment(place).x() * place.speed ==
          doctest::Approx(row.electric).epsilon(0.03).scale(0.0));
    CHECK(3e-3 * run.force().x() == doctest::Approx(row.thrust).epsilon(0.03).scale(0.0));
  }
}

TEST_CASE("nrel_5mw: what yaw costs by what carries air through the disc") {
  spatial::Air air = make_nrel_air();
  const auto mean_power = [&](spatial::MassFlow flow, double yaw) {
    air.mass_flow = flow;
    const air::BladeAir blade = make_nrel(air);
    double power = 0.0;
    for (int k = 0; k < 36; ++k) {
      const BladePlace place{.speed = 9.156 * std::numbers::pi / 30.0,
                             .azimuth = 10.0 * k * kOneDegree,
                             .hub_radius = 1.5};
      AirRun run(blade);
      run.go(place, {8.0 * std::cos(yaw), 8.0 * std::sin(yaw), 0.0}, kForever);
      power += run.moment(place).x() * place.speed / 36.0;
    }
    return power;
  };
  // About the cosine and its third power, as of programs that have either flow.
  const auto find_exponent = [&](spatial::MassFlow flow) {
    const double yaw = 20.0 * kOneDegree;
    return std::log(mean_power(flow, yaw) / mean_power(flow, 0.0)) / std::log(std::cos(yaw));
  };
  CHECK(std::abs(find_exponent(spatial::MassFlow::glauert) - 1.0) < 0.1);
  CHECK(std::abs(find_exponent(spatial::MassFlow::normal) - 3.0) < 0.2);
}
