// The shipped rotor whose blades are chains of solids, against the beam equation.

#include "tests/shipped.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include "engine/simulation.h"
#include "models/scenario.h"
#include "tests/approx.h"

using namespace spoke;
using spoke::testing::approx;

TEST_CASE("the Wu-Haug rotor of solid tubes lags as the beam equation says") {
  const Scenario scenario = test::read_shipped("wu_haug_solid");
  SimulationOptions options;
  options.executor = ExecutorKind::serial;
  Simulation simulation(scenario, options);
  const std::size_t y = simulation.sensor_index("blade1.displacement.y"),
                    z = simulation.sensor_index("blade1.displacement.z");
  double lag = 0.0, flap = 0.0;
  simulation.run_until(7.5, [&](double, std::span<const double> sensors) {
    lag = std::min(lag, sensors[y]);
    flap = std::max(flap, std::abs(sensors[z]));
  });
  // docs/formulation.md, section 8.1.
  CHECK(lag == approx(-0.53411139).epsilon(1e-4));
  CHECK(flap < 1e-6);
  CHECK(simulation.warnings().empty());
}
