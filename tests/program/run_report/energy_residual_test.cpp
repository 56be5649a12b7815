// Remarks on an energy balance that does not close.

#include "program/run_report/energy_residual.h"

#include <doctest/doctest.h>

#include "tests/program/run_report/scenarios.h"

using namespace spoke;
using run_report::EnergyResidual;

namespace {

/// Finds the residual of a run whose kinetic energy was 100 J, and its residual 0 at 1 s and
/// `residual` [J] at 2 s.
EnergyResidual find(double residual, const Integration& integration) {
  Scenario scenario = test_scenario();
  scenario.integration = integration;
  const Simulation simulation(scenario, test_options());
  const std::vector<std::string>& names = simulation.sensor_names();
  SensorStatistics statistics(names.size());
  for (const double t : {1.0, 2.0}) {
    std::vector<double> values(names.size(), 0.0);
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (names[k] == "energy.kinetic") values[k] = 100.0;
      if (names[k] == "energy.residual" && t == 2.0) values[k] = residual;
    }
    statistics.add(t, values);
  }
  return run_report::find_energy_residual(simulation, statistics);
}

}  // namespace

TEST_CASE("energy that is lost to the method's own damping is told as that, and nothing else is") {
  Integration damping = test_scenario().integration;
  damping.spectral_radius = 0.8;
  Integration none = damping, rk4 = damping;
  none.spectral_radius = 1.0;
  rk4.method = IntegrationMethod::rk4;
  rk4.step = 1e-4;
  const EnergyResidual lost = find(-5.0, damping);
  CHECK(lost.value == -5.0);
  CHECK(lost.time == 2.0);
  CHECK(lost.share == 0.05);
  CHECK(lost.is_notable);
  CHECK(lost.explanation == "lost: the method damps vibrations that the step does not resolve");
  for (const EnergyResidual& other : {find(5.0, damping), find(-5.0, none), find(-5.0, rk4)}) {
    CHECK(other.is_notable);
    CHECK(other.explanation.empty());
  }
  CHECK_FALSE(find(-0.05, damping).is_notable);
  CHECK(find(-0.05, damping).explanation.empty());
}
