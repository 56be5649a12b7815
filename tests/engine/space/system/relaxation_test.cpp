// Rotors under strong tension, with steps at which a plain iteration swings.

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <string>

#include "engine/simulation.h"

using namespace spoke;

namespace {

/// The shipped helicopter rotor at full speed from its equilibrium on, lift risen.
Scenario make_rotor(double step) {
  Scenario scenario =
      read_scenario(std::string(SPOKE_MODELS_DIR) + "/articulated_rotor.toml",
                    {"hub.drive={kind=\"constant\", speed=36}", "initial.state=equilibrium",
                     "gravity.ramp=0", "distributed_load.1.factor=[1,1]"});
  scenario.integration.step = step;
  scenario.integration.duration = 0.2;
  return scenario;
}

Simulation run(const Scenario& scenario, ExecutorKind executor = ExecutorKind::serial,
               int threads = 1, int window = 1) {
  Simulation simulation(scenario, {Formulation::structured, executor, threads, window});
  simulation.run_until(scenario.integration.duration);
  return simulation;
}

}  // namespace

TEST_CASE("tension: an iteration that swings ends where a plain one does, in half the passes") {
  Scenario scenario = make_rotor(4e-3);
  const Simulation relaxed = run(scenario);
  scenario.integration.iterations = 40;  // plain
  const Simulation plain = run(scenario);
  CHECK(relaxed.evaluations() < 12 * relaxed.steps());
  for (const char* sensor : {"blade1.tip.z", "blade1.tip.y", "blade3.hinges.1", "blade2.hinges.2"})
    CHECK(relaxed.sensor(sensor) == doctest::Approx(plain.sensor(sensor)).epsilon(1e-6));
}

TEST_CASE("tension: steps are made at which a plain iteration does not converge") {
  Scenario scenario = make_rotor(6e-3);
  const Simulation large = run(scenario);
  const Simulation small = run(make_rotor(1e-3));
  CHECK(large.evaluations() < 16 * large.steps());
  CHECK(large.sensor("blade1.hinges.1") ==
        doctest::Approx(small.sensor("blade1.hinges.1")).epsilon(0.05));
}

TEST_CASE("tension: relaxed runs have one state, whatever executes them") {
  const Scenario scenario = make_rotor(6e-3);
  const std::uint64_t known = run(scenario).state_hash();
  CHECK(run(scenario, ExecutorKind::serial, 1, 7).state_hash() == known);
  CHECK(run(scenario, ExecutorKind::flow_graph, 2).state_hash() == known);
  CHECK(run(scenario, ExecutorKind::flow_graph, 3, 5).state_hash() == known);
}
