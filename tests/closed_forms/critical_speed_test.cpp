// Blades of one linear body without geometric stiffening: in the plane of rotation the centrifugal
// force takes from its stiffness what the tension would give back, so that it has no stable shape
// beyond the speed of its natural frequency at rest.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include "engine/simulation.h"
#include "models/error.h"
#include "models/scenario.h"

using namespace spoke;

namespace {

// First natural frequency of the blade: 3.5160 rad/s, the cantilever's with EI = rhoA = L = 1.
constexpr double kFrequency = 3.5160;

const std::string kBlade = R"(
world = "space"
[hub]
inertia = 1.0
[hub.drive]
kind = "constant"
speed = 1.0
[blade]
count = 1
length = 1.0
bodies = 1
elements = 4
geometric_stiffening = false
[blade.sections]
mass_per_length = 1.0
axial_stiffness = 1e6
lag_stiffness = 1.0
flap_stiffness = 1.0
torsion_stiffness = 1.0
lag_inertia = 1e-9
flap_inertia = 1e-9
[[load]]
frame = "section"
force = [0.0, 1e-3, 0.0]
ramp = 5.0
[integration]
step = 0.01
duration = 60.0
)";

Simulation turn_at(double speed) {
  const Scenario scenario =
      parse_scenario(kBlade, "blade.toml", {"hub.drive.speed=" + std::to_string(speed)});
  return Simulation(scenario, {.executor = ExecutorKind::serial});
}

}  // namespace

TEST_CASE("below its critical speed a linear body in space keeps its shape") {
  Simulation simulation = turn_at(0.97 * kFrequency);
  double largest = 0.0;
  const std::size_t tip = simulation.sensor_index("blade1.tip.y");
  simulation.run_until(60.0, [&](double, std::span<const double> sensors) {
    largest = std::max(largest, std::abs(sensors[tip]));
  });
  // Its static deflection is P L^3 / 3 EI / (1 - 0.97^2), nearly: 5.6 mm.
  CHECK(largest > 5e-3);
  CHECK(largest < 12e-3);
}

TEST_CASE("beyond its critical speed a linear body in space diverges, and is named") {
  Simulation simulation = turn_at(1.03 * kFrequency);
  try {
    simulation.run_until(60.0);
    FAIL("does not diverge");
  } catch (const DivergenceError& error) {
    const std::string sentence = error.what();
    CHECK(sentence.find("blade 1 / body 1: displacement v of node 4") != std::string::npos);
    CHECK(sentence.find("(node \"blade 1 / body 1 / recovery\")") != std::string::npos);
    CHECK(simulation.time() > 6.0);  // 5 mm grow by cosh(0.87 t), until 1 m
  }
}
