// Remarks on an energy balance that does not close.

#include "program/run_report/energy_residual.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "tests/program/run_report/scenarios.h"

using namespace spoke;
using run_report::EnergyResidual;

namespace {

/// Finds the residual of a run whose kinetic energy was `kinetic` [J], its work 100 J, and its
/// residual 0 at 1 s and `residual` [J] at 2 s.
EnergyResidual find(double residual, const Scenario& scenario, double kinetic) {
  const Simulation simulation(scenario, test_options());
  const std::vector<std::string>& names = simulation.sensor_names();
  SensorStatistics statistics(names.size());
  for (const double t : {1.0, 2.0}) {
    std::vector<double> values(names.size(), 0.0);
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (names[k] == "energy.kinetic") values[k] = kinetic;
      if (names[k] == "energy.work") values[k] = 100.0;
      if (names[k] == "energy.residual" && t == 2.0) values[k] = residual;
    }
    statistics.add(t, values);
  }
  return run_report::find_energy_residual(simulation, statistics);
}
EnergyResidual find(double residual, const Integration& integration) {
  Scenario scenario = test_scenario();
  scenario.integration = integration;
  return find(residual, scenario, 100.0);
}

/// A platform on six legs of given lengths, which leave it nothing to move in, on a hub that is
/// spun up; or on five of them.
Scenario make_platform(int legs) {
  std::string loops;
  for (int k = 0; k < legs; ++k) {
    const double foot = k * std::numbers::pi / 3.0, head = foot + (k % 2 == 0 ? 0.8 : -0.8);
    const auto place = [](double angle, double height) {
      return "[" + std::to_string(std::cos(angle)) + "," + std::to_string(std::sin(angle)) + "," +
             std::to_string(height) + "]";
    };
    loops += (k == 0 ? "" : ", ") + ("{ name='leg" + std::to_string(k)) +
             "', kind='distance', from={ body='platform', point=" + place(head, 0.0) +
             " }, to={ body='hub', point=" + place(foot, 0.0) + " } }";
  }
  return parse_scenario(
      "world='space'\n[hub.drive]\nkind='spin_up'\nspeed=4.0\nramp=5.0\n[[subsystem]]\n"
      "name='stewart'\nbody=[ { name='platform', kind='rigid', mass=10, inertia=1 } ]\n"
      "joint=[ { parent='hub', child='platform', kind='bushing', offset=[0,0,1],"
      " stiffness=[1,1,1,1,1,1] } ]\nloop=[" +
          loops + "]\n[integration]\nstep=0.01\nduration=2\n",
      "platform.toml");
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

TEST_CASE("where nothing can vibrate, nothing is said of vibrations") {
  const EnergyResidual locked = find(-5.0, make_platform(6), 100.0);
  CHECK(locked.is_notable);
  CHECK(locked.explanation.starts_with("of the work of prescribed motion"));
  CHECK(find(-5.0, make_platform(5), 100.0).explanation.starts_with("lost: the method damps"));
}

TEST_CASE("round-off of the balance of a model that stands still is not notable") {
  const EnergyResidual rest = find(-1e-13, make_platform(6), 1e-20);
  CHECK(rest.share > 1.0);
  CHECK_FALSE(rest.is_notable);
  CHECK(rest.explanation.empty());
}
