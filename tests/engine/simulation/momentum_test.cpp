// Tests which models have residuals of momentum, and when these warn.

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "engine/simulation.h"
#include "engine/simulation/momentum_sensors.h"
#include "engine/simulation/observations.h"
#include "tests/approx.h"
#include "tests/shipped.h"

using namespace spoke;

namespace {

bool has_residuals(const Scenario& scenario, const Loads& loads = {}) {
  const Simulation simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1}, loads);
  const auto& names = simulation.sensor_names();
  const auto count = std::count_if(names.begin(), names.end(), [](const std::string& name) {
    return name.starts_with("momentum.residual.");
  });
  CHECK((count == 0 || count == 2));
  return count == 2;
}

}  // namespace

TEST_CASE("free models on which nothing acts have residuals of momentum") {
  Scenario tree = test::read_shipped("tree_of_bodies");
  CHECK(has_residuals(tree));
  tree.space->gravity = {0.0, 0.0, -9.81};
  CHECK_FALSE(has_residuals(tree));
  tree = test::read_shipped("tree_of_bodies");
  tree.space->hub_loads.emplace_back().force = {1.0, 0.0, 0.0};
  CHECK_FALSE(has_residuals(tree));
  CHECK_FALSE(has_residuals(test::read_shipped("articulated_rotor")));
  Scenario satellite = test::read_shipped("free_hub_satellite");
  satellite.rotor.loads.clear();
  satellite.rotor.distributed_loads.clear();
  satellite.rotor.hub_loads.clear();
  satellite.rotor.drags.clear();
  satellite.rotor.hub.drive = FreeDrive{1.0};
  CHECK(has_residuals(satellite));
  satellite.rotor.hub.drive = TorqueDrive{Curve(1.0), 0.0};
  CHECK_FALSE(has_residuals(satellite));
}

TEST_CASE("a free rotor in the plane keeps its momentum, and says so") {
  Scenario scenario = test::read_shipped("free_hub_satellite");
  scenario.rotor.loads.clear();
  scenario.rotor.distributed_loads.clear();
  scenario.rotor.hub_loads.clear();
  scenario.rotor.hub.drive = FreeDrive{0.5};
  scenario.integration.duration = 2.0;
  Sensor& sensor = scenario.sensors.emplace_back();
  sensor.quantity = SensorQuantity::momentum;
  sensor.name = "p";
  Simulation simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1});
  const double start = simulation.sensor("p.angular");
  double largest = 0.0;
  simulation.run_until(2.0, [&](double, std::span<const double> values) {
    const double residual = values[simulation.sensor_index("momentum.residual.angular")];
    largest = std::max(largest, residual);
  });
  CHECK(start > 0.0);
  CHECK(largest < 1e-4 * start);
  CHECK(simulation.warnings().empty());
}

TEST_CASE("a residual of momentum warns beyond its share of the largest size so far") {
  Observations seen;
  CHECK_FALSE(observe_momentum(1.0, {0.009, 1.0, 0.0, 1.0}, 0.01, seen));
  CHECK_FALSE(observe_momentum(2.0, {0.015, 2.0, 0.0, 1.0}, 0.01, seen));
  CHECK_FALSE(observe_momentum(3.0, {0.015, 1.0, 0.0, 0.0}, 0.01, seen));
  CHECK_FALSE(observe_momentum(4.0, {1.0, 1.0, 1.0, 1.0}, 0.0, seen));  // no limit
  seen = {};
  CHECK(observe_momentum(5.0, {0.0, 1.0, 0.02, 1.0}, 0.01, seen));
  CHECK(seen.momentum.is_angular == 1.0);
  CHECK(seen.momentum.share == 0.02);
  CHECK_FALSE(observe_momentum(6.0, {0.0, 1.0, 0.05, 1.0}, 0.01, seen));  // once
  CHECK(seen.momentum.first_step == 5.0);
  CHECK(seen.momentum.step == 6.0);
}
