// Fast rotors: with the tension of rotation on the left-hand side, steps that accuracy allows take
// two or three passes, and end where passes to the last digits do.

#include <doctest/doctest.h>

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <string>

#include "engine/simulation.h"

using namespace spoke;

namespace {

Scenario make_scenario(const std::string& file, const Overrides& overrides, double step,
                       int steps) {
  Scenario scenario = read_scenario(std::string(SPOKE_MODELS_DIR) + "/" + file, overrides);
  scenario.integration.step = step;
  scenario.integration.duration = steps * step;
  return scenario;
}

/// The shipped helicopter rotor at full speed from its equilibrium on, lift risen.
Scenario make_articulated(const std::string& drive, double step, int steps) {
  return make_scenario("articulated_rotor.toml",
                       {"hub.drive=" + drive, "initial.state=equilibrium", "gravity.ramp=0",
                        "distributed_load.1.factor=[1,1]"},
                       step, steps);
}

const std::string kConstant = "{kind=\"constant\", speed=36}";
const std::string kMotor =
    "{kind=\"torque_by_speed\", speed=[0, 30, 36, 40], torque=[12000, 12000, 0, -8000],"
    " initial_speed=35}";

/// The shipped helicopter rotor from rest to speed within 0.6 s: through many roundings of the
/// speed.
Scenario make_spin_up(int steps) {
  return make_scenario("articulated_rotor.toml",
                       {"hub.drive={kind=\"spin_up\", speed=36, ramp=0.6}", "gravity.ramp=0.6",
                        "blade.strain=\"linear\""},
                       4e-3, steps);
}

Simulation run(const Scenario& scenario, ExecutorKind executor = ExecutorKind::serial,
               int threads = 1, int window = 1) {
  Simulation simulation(scenario, {Formulation::structured, executor, threads, window});
  simulation.run_until(scenario.integration.duration);
  return simulation;
}

/// Returns the number of passes in a step; the evaluation at the start is none.
double passes_of(const Simulation& simulation) {
  return static_cast<double>(simulation.evaluations() - 1) /
         static_cast<double>(simulation.steps());
}

/// Displacement of the first blade's tip at the end [m].
Eigen::Vector3d find_tip(const Scenario& scenario) {
  const Simulation simulation = run(scenario);
  return {simulation.sensor("blade1.tip.x"), simulation.sensor("blade1.tip.y"),
          simulation.sensor("blade1.tip.z")};
}

/// That passes leave little, beside what the step itself does or by all.
void check_left_error(Scenario scenario) {
  const Eigen::Vector3d usual = find_tip(scenario);
  Scenario fine = scenario;
  fine.integration.step /= 8.0;
  scenario.integration.tolerance = 1e-12;
  const Eigen::Vector3d exact = find_tip(scenario);
  const double left = (usual - exact).norm(), by_step = (exact - find_tip(fine)).norm();
  CAPTURE(left);
  CAPTURE(by_step);
  CHECK(left < 1e-6 * exact.norm() + 0.05 * by_step);
}

}  // namespace

TEST_CASE("tension of rotation costs no iterations: a helicopter's rotor") {
  for (const double step : {2e-3, 4e-3, 8e-3}) {
    CAPTURE(step);
    const Scenario scenario = make_articulated(kConstant, step, 60);
    CHECK(passes_of(run(scenario)) <= 3.0);
    check_left_error(scenario);
  }
}

TEST_CASE("tension of rotation costs no iterations: a helicopter's rotor that a motor turns") {
  const Scenario scenario = make_articulated(kMotor, 4e-3, 60);
  CHECK(passes_of(run(scenario)) <= 3.5);
  check_left_error(scenario);
}

TEST_CASE("tension of rotation costs no iterations: rotors of a turbine and a drone") {
  const Scenario turbine = make_scenario("nrel_5mw_rotor.toml", {}, 0.01, 100);
  CHECK(passes_of(run(turbine)) <= 2.5);
  check_left_error(turbine);
  // It rises to full speed within a tenth of the time of the shipped one, and goes on.
  const Scenario drone = make_scenario(
      "drone_rotor.toml", {"hub.drive={kind=\"spin_up\", speed=628.3185, ramp=0.05}"}, 4e-5, 1500);
  CHECK(passes_of(run(drone)) <= 2.5);
  check_left_error(drone);
}

TEST_CASE("a spin-up that makes the tension anew has one state, whatever executes it") {
  const Scenario scenario = make_spin_up(120);
  const std::uint64_t known = run(scenario).state_hash();
  CHECK(run(scenario, ExecutorKind::serial, 1, 7).state_hash() == known);
  CHECK(run(scenario, ExecutorKind::flow_graph, 2).state_hash() == known);
  CHECK(run(scenario, ExecutorKind::flow_graph, 3, 5).state_hash() == known);
  CHECK(run(scenario, ExecutorKind::openmp_levels, 2, 3).state_hash() == known);
}

TEST_CASE("a spin-up goes on from a saved state with the bits of the whole run") {
  const Scenario scenario = make_spin_up(120);
  const Simulation whole = run(scenario);
  for (const int split : {1, 37, 90}) {
    CAPTURE(split);
    Simulation first(scenario, {Formulation::structured, ExecutorKind::serial, 1, 1});
    first.run_until(split * first.step_size());
    Simulation fresh(scenario, {Formulation::structured, ExecutorKind::serial, 1, 5});
    fresh.restore(first.save());
    fresh.run_until(scenario.integration.duration);
    CHECK(fresh.state_hash() == whole.state_hash());
    CHECK(fresh.evaluations() == whole.evaluations());
    // One whose tension is that of a later speed goes back to it.
    Simulation used = run(scenario);
    used.restore(first.save());
    used.run_until(scenario.integration.duration);
    CHECK(used.state_hash() == whole.state_hash());
  }
}

TEST_CASE("energy of fast blades on a hub that flies keeps to order two") {
  const auto residual = [](double step) {
    Scenario scenario =
        make_scenario("drone_rotor.toml",
                      {"hub.support=free", "hub.mass=0.8", "hub.inertia=[1e-3, 1e-3, 2e-3]",
                       "hub.drive={kind=\"torque\", time=[0, 0.02, 0.08], torque=[0, 12.0, 12.0]}"},
                      step, 1);
    scenario.integration.duration = 0.08;
    const Simulation simulation = run(scenario);
    CHECK(simulation.sensor("hub.speed") > 300.0);
    return std::abs(simulation.sensor("energy.residual"));
  };
  const double large = residual(8e-5), half = residual(4e-5);
  CAPTURE(large);
  CAPTURE(half);
  CHECK(large / half > 3.2);
}
