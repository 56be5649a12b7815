// Blades that pass a tower: what they meet there, and that the rest of a model knows nothing of it.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "engine/bodies/air/tower_flow.h"
#include "engine/linearize.h"
#include "engine/simulation.h"
#include "models/scenario.h"

using namespace spoke;
using Eigen::Vector3d;

namespace {

constexpr double kOverhang = 6.0, kTurnRate = 1.0, kHubRadius = 1.5, kWindSpeed = 10.0;

/// Returns a rotor of stiff blades on a stiff tower of 80 m, the first blade downwards at t = 0.
/// `side`: 1 behind the tower, -1 ahead of it. `drag`: a table of the tower's; may be empty.
std::string make_turbine(double side, const std::string& drag) {
  const std::string stiff =
      "axial_stiffness = 1e15\nflap_stiffness = 1e17\nlag_stiffness = 1e17\n"
      "torsion_stiffness = 1e17\n";
  return "world = \"space\"\n[hub]\naxis = [1, 0, 0]\nmass = 10.0\ninertia = 1.0\nradius = 1.5\n"
         "drive = { kind = \"constant\", speed = 1.0 }\n"
         "[support]\nfrom = \"ground\"\n"
         "[[support.body]]\nname = \"tower\"\nkind = \"beam\"\nlength = 80.0\nelements = 4\n"
         "bodies = 2\n[support.body.sections]\nmass_per_length = 1000.0\n" +
         stiff + (drag.empty() ? "" : "[support.body.drag]\n" + drag) +
         "[[support.joint]]\nchild = \"tower\"\nkind = \"fixed\"\n"
         "orientation = [0, -1.5707963267948966, 0]\n"
         "[support.axle]\nbody = \"tower\"\norientation = [0, 1.5707963267948966, 0]\noffset = [0, "
         "0, " +
         std::to_string(-side * kOverhang) +
         "]\n[blade]\ncount = 2\nlength = 50.0\nbodies = 1\nelements = 4\n[blade.sections]\n"
         "mass_per_length = 100.0\n" +
         stiff +
         "[blade.aerodynamics]\nstation = [10, 20, 30, 40, 50]\nchord = 1.0\ntwist = 0\n"
         "airfoil = \"thin\"\n"
         "[air]\n[aerodynamics]\ninduction = \"none\"\nstall = \"static\"\n"
         "[wind]\nvelocity = [10, 0, 0]\n"
         "[[airfoil]]\nname = \"thin\"\nangle = [-3.141592653589793, 0, 3.141592653589793]\n"
         "lift = [0, 0, 0]\ndrag = [0.1, 0.1, 0.1]\n"
         "[[sensor]]\nname = \"mid\"\nquantity = \"air_flow\"\nposition = 30.0\n"
         "[[sensor]]\nname = \"before\"\nquantity = \"wind\"\nposition = 30.0\n"
         "[integration]\nstep = 0.02\nduration = 6.28\n";
}

/// Returns a column of a run, step by step, over a turn.
std::vector<double> run_column(const std::string& text, const std::string& name) {
  const Scenario scenario = parse_scenario(text, "turbine.toml");
  Simulation simulation(scenario);
  const std::size_t column = simulation.sensor_index(name);
  std::vector<double> values;
  const int steps = 314;
  for (int k = 0; k < steps; ++k) {
    simulation.run_until(simulation.time() + scenario.integration.step);
    values.push_back(simulation.sensor_values()[column]);
  }
  return values;
}

}  // namespace

TEST_CASE("tower flow: blades meet the flow around the tower as the geometry has it") {
  const std::string bak = "diameter = 4.0\ncoefficient = 0.5\npotential = \"bak\"\n";
  const air::TowerFlow flow{spatial::TowerPotential::bak, spatial::TowerShadow::none};
  const std::array<air::TowerPoint, 2> axis{
      {{{0, 0, 0}, {}, 4.0, 0.5}, {{0, 0, 80}, {}, 4.0, 0.5}}};
  const Vector3d wind(kWindSpeed, 0.0, 0.0);
  const std::vector<double> met = run_column(make_turbine(-1.0, bak), "blade1.mid.relative_speed");
  for (std::size_t k = 0; k < met.size(); ++k) {
    const double angle = kTurnRate * 0.02 * static_cast<double>(k + 1);
    const double radius = kHubRadius + 30.0;
    // The first blade hangs down at t = 0, and turns about +x.
    const Vector3d along(0.0, std::sin(angle), -std::cos(angle));
    const Vector3d around(0.0, std::cos(angle), std::sin(angle));
    const Vector3d place = Vector3d(-kOverhang, 0.0, 80.0) + radius * along;
    const Vector3d air = wind + air::calc_tower_flow(flow, axis, place, wind);
    const Vector3d against = air - kTurnRate * radius * around;
    const double expected = (against - against.dot(along) * along).norm();
    CHECK(met[k] == doctest::Approx(expected).epsilon(1e-7));
  }
}

TEST_CASE(
    "tower flow: the wind before the rotor is that of no tower, and thrust dips at the tower") {
  const std::string both =
      "diameter = 4.0\ncoefficient = 0.5\npotential = \"cylinder\"\nshadow = \"powles\"\n";
  for (const double side : {-1.0, 1.0}) {
    CAPTURE(side);
    for (const double v : run_column(make_turbine(side, both), "blade1.before.x"))
      CHECK(v == kWindSpeed);
    // Thrust of these blades, which have drag alone, is least where the wind is slowest: where
    // the second one passes the tower, at half a turn.
    const std::vector<double> thrust = run_column(make_turbine(side, both), "air.thrust");
    const auto least = std::min_element(thrust.begin() + 80, thrust.begin() + 240);
    const double at = 0.02 * static_cast<double>(least - thrust.begin() + 1);
    CHECK(at == doctest::Approx(std::numbers::pi).epsilon(0.02));
    const std::vector<double> free = run_column(make_turbine(side, ""), "air.thrust");
    CHECK(*least < 0.97 * free[156]);
    // A quarter of a turn away from it the tower is far.
    CHECK(thrust[78] == doctest::Approx(free[78]).epsilon(0.01));
  }
}

TEST_CASE("tower flow: a tower that does nothing to the wind changes no bit") {
  const std::string column = "blade1.mid.relative_speed";
  CHECK(run_column(make_turbine(-1.0, "diameter = 4.0\ncoefficient = 0.0\n"), column) ==
        run_column(make_turbine(-1.0, ""), column));
}

TEST_CASE("sensors of the wind have that of their places as they move") {
  std::string text = make_turbine(-1.0, "");
  const std::string uniform = "[wind]\nvelocity = [10, 0, 0]\n";
  text.replace(text.find(uniform), uniform.size(),
               "[wind]\nvelocity = [10, 0, 0]\nshear_exponent = 0.2\nreference_height = 80\n"
               "horizontal_shear = 0.002\ngust = { amplitude = 4, duration = 6 }\n"
               "[[sensor]]\nname = \"at\"\nquantity = \"wind\"\nsubsystem = \"support\"\nbody = "
               "\"hub\"\n");
  const std::vector<double> at_blade = run_column(text, "blade1.before.x");
  const std::vector<double> at_hub = run_column(text, "support.at.x");
  for (std::size_t k = 0; k < at_blade.size(); ++k) {
    const double t = 0.02 * static_cast<double>(k + 1), radius = kHubRadius + 30.0;
    const double gust = t < 6.0 ? 2.0 * (1.0 - std::cos(2.0 * std::numbers::pi * t / 6.0)) : 0.0;
    const double height = 80.0 - radius * std::cos(kTurnRate * t);
    const double across = radius * std::sin(kTurnRate * t);
    CHECK(at_hub[k] == doctest::Approx(kWindSpeed + gust).epsilon(1e-9));
    CHECK(at_blade[k] ==
          doctest::Approx(kWindSpeed * (std::pow(height / 80.0, 0.2) + 0.002 * across) + gust)
              .epsilon(1e-9));
  }
}

TEST_CASE("linear models leave sensors of the wind out, on blades and on a support without drag") {
  std::string text = make_turbine(-1.0, "");
  const std::string two = "count = 2";
  text.replace(text.find(two), two.size(), "count = 3");
  text +=
      "[[sensor]]\nname = \"at\"\nquantity = \"wind\"\nsubsystem = \"support\"\nbody = \"hub\"\n";
  const std::vector<std::string> left =
      solve_linear_system(parse_scenario(text, "turbine.toml")).left_out;
  for (const char* name : {"support.at.x", "blade1.before.x"}) {
    CAPTURE(name);
    CHECK(std::find(left.begin(), left.end(), name) != left.end());
  }
}
