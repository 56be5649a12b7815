// Provokes each cause of divergence, and checks its name.

#include "engine/simulation/diagnosis.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <string>

#include "engine/bodies/kernels/plane/natural_frequencies.h"
#include "engine/simulation.h"
#include "engine/step/run/step_runner.h"
#include "models/error.h"
#include "tests/approx.h"
#include "tests/engine/rotors.h"

using namespace spoke;
using namespace spoke::test;
using spoke::testing::approx;

namespace {

/// Returns the message with which a simulation ends, the same on all executors and windows.
std::string diverge(const Scenario& scenario) {
  const auto message_of = [&](const SimulationOptions& options) -> std::string {
    try {
      Simulation simulation(scenario, options);
      simulation.run_until(scenario.integration.duration);
    } catch (const DivergenceError& error) {
      return error.what();
    }
    return "it did not diverge";
  };
  const std::string message = message_of({Formulation::structured, ExecutorKind::serial, 1, 1});
  CHECK(message == message_of({Formulation::structured, ExecutorKind::flow_graph, 2, 1}));
  CHECK(message == message_of({Formulation::structured, ExecutorKind::flow_graph, 2, 20}));
  return message;
}

/// Returns the message of a scenario that Simulation refuses, stepped by the layers below it.
std::string diverge_unchecked(const Scenario& scenario, const RunnerOptions& options) {
  const Integration& integration = scenario.integration;
  const bool is_rk4 = integration.method == IntegrationMethod::rk4;
  SystemContext<Plane> context;
  context.system = make_system(scenario.rotor);
  context.integrator.method =
      is_rk4 ? Method(Rk4{integration.step})
             : Method(make_generalized_alpha(integration.spectral_radius, integration.step));
  allocate(context, window_records(options, ring_bytes(context.system, 0)));
  StepRunner runner(context, options);
  const auto fail = [&](StepOutcome outcome, std::int64_t step) {
    const double time = static_cast<double>(step) * integration.step;
    return std::string(
        diagnose(scenario, context, name_subsystems(scenario.rotor), {outcome, time, step, {}})
            .what());
  };
  const StepOutcome start = runner.start();
  if (start != StepOutcome::done) return fail(start, 0);
  const StepOutcome outcome = runner.advance_to(options.planned_steps, false, [](std::int64_t) {});
  return outcome == StepOutcome::done ? "it did not diverge" : fail(outcome, runner.steps() + 1);
}

std::string diverge_unchecked(const Scenario& scenario) {
  const std::int64_t steps = std::llround(0.2 / scenario.integration.step);
  const std::string message = diverge_unchecked(scenario, {ExecutorKind::serial, 1, 1, steps});
  CHECK(message == diverge_unchecked(scenario, {ExecutorKind::flow_graph, 2, 1, steps}));
  CHECK(message == diverge_unchecked(scenario, {ExecutorKind::flow_graph, 2, 20, steps}));
  return message;
}

void check_parts(const std::string& message, std::initializer_list<const char*> parts) {
  CAPTURE(message);
  for (const char* part : parts) {
    CAPTURE(part);
    CHECK(message.find(part) != std::string::npos);
  }
}

std::string number(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

/// A load across the tip of one of three blades.
PointLoad tip_load(int blade, Curve factor) {
  PointLoad load;
  load.blade = BladeChoice::number(blade + 1);
  load.position = 8.0;
  const double azimuth = 2.0 * M_PI * blade / 3.0;
  load.force = {-std::sin(azimuth), std::cos(azimuth)};
  load.factor = std::move(factor);
  return load;
}

}  // namespace

TEST_CASE("rk4 above its stability limit is named with that limit") {
  Scenario scenario = spin_up_scenario(wu_haug_blade(4, 4), 0.005);
  scenario.integration.method = IntegrationMethod::rk4;
  const plane::FrequencyRange range = plane::calc_frequency_range(scenario.rotor);
  const std::string limit = number(calc_rk4_largest_step(range, {}));
  const std::string highest = number(range.highest);
  check_parts(diverge(scenario),
              {"diverged at t = ", "step ", "blade 1 / body ", " of node ", " / recovery\"",
               "the step of 0.005 s is above", limit.c_str(), highest.c_str()});
}

TEST_CASE("a divergence has what its sentence names as fields") {
  Scenario scenario = spin_up_scenario(wu_haug_blade(4, 4), 0.005);
  scenario.integration.method = IntegrationMethod::rk4;
  Divergence at;
  std::string message;
  try {
    Simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1}).run_until(1.0);
  } catch (const DivergenceError& error) {
    at = error.divergence();
    message = error.what();
  }
  REQUIRE(at.step);
  CHECK(*at.time == approx(0.005 * static_cast<double>(*at.step)));
  CHECK(at.subsystem == "blade 1");
  CHECK(at.node == at.subsystem + " / " + at.body + " / recovery");
  check_parts(message, {("step " + std::to_string(*at.step) + ": ").c_str(), at.node.c_str(),
                        at.quantity.c_str()});
}

TEST_CASE("rk4 above its stability limit by damping is named with it") {
  Scenario scenario = spin_up_scenario(wu_haug_blade(4, 4), 0.005);
  scenario.integration.method = IntegrationMethod::rk4;
  scenario.rotor.damping.stiffness_factor = 1e-3;
  const plane::FrequencyRange range = plane::calc_frequency_range(scenario.rotor);
  const double limit = calc_rk4_largest_step(range, scenario.rotor.damping);
  CHECK(limit < 0.1 * calc_rk4_largest_step(range, {}));
  scenario.integration.step = 1.5 * limit;
  check_parts(diverge(scenario),
              {"stability limit of rk4", number(limit).c_str(), "its damping ratio by [damping] ",
               number(0.5e-3 * range.highest).c_str()});
}

TEST_CASE("strong linear drag is named, with a step that it allows") {
  Scenario scenario = spin_up_scenario(wu_haug_blade(4, 4), 0.005);
  const Blade& blade = scenario.rotor.blades[0];
  const double mass = blade.density * blade.area;
  scenario.rotor.drags = {{.linear_per_length = 1000.0 * mass}};
  const std::string message = diverge(scenario);
  constexpr const char* advice = "set integration.step to ";
  check_parts(message, {"linear drag slows the motion down at up to 1000 1/s", advice});
  scenario.integration.step = std::stod(message.substr(message.find(advice) + 24));
  scenario.integration.duration = 500.0 * scenario.integration.step;
  Simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1}).run_until(1.0);

  scenario.integration.method = IntegrationMethod::rk4;
  scenario.integration.step = 0.004;
  check_parts(diverge(scenario), {"stability limit of rk4",
                                  ", and linear drag slows the motion down at up to 1000 1/s"});
}

TEST_CASE("a linear body above its first natural frequency is named with both speeds") {
  Blade blade = wu_haug_blade(1, 4);
  blade.geometric_stiffening = false;
  const double first = plane::calc_first_frequency(blade);
  // (1.8751 / L)^2 sqrt(EI / (rho A)) of a cantilever
  const double bending = blade.youngs_modulus * blade.second_moment;
  CHECK(first == approx(std::pow(1.875104 / blade.length, 2) *
                        std::sqrt(bending / (blade.density * blade.area)))
                     .epsilon(1e-4));
  const std::string text = number(first);
  check_parts(diverge(spin_up_scenario(blade, 0.005)),
              {"blade 1 / body 1: ", "the hub turns at 3.", "above the blade's first natural",
               text.c_str(), "geometric_stiffening = true"});
}

TEST_CASE("stiffened blades are not blamed for lacking stiffness") {
  Scenario scenario = spin_up_scenario(wu_haug_blade(2, 2), 0.005);
  scenario.rotor.loads.push_back(tip_load(1, Curve({0.0, 3.0}, {0.0, 2000.0})));
  const std::string message = diverge(scenario);
  CHECK(message.find("without geometric stiffening") == std::string::npos);
  check_parts(message, {"diverged at t = ", "blade 2 / body "});
}

TEST_CASE("too few bodies for the deflection are named with a number that would do") {
  Scenario scenario = spin_up_scenario(wu_haug_blade(1, 4), 0.005);
  scenario.rotor.hub.drive = SpinUp{0.0, 1.0};
  scenario.rotor.loads.push_back(tip_load(1, Curve({0.0, 10.0}, {0.0, 60.0})));
  check_parts(diverge(scenario),
              {"blade 2 / body 1: deflection v of node 4 = ", "blade 2 / body 1 had bent by 9",
               "too much for its linear elasticity", " bodies instead of 1"});
}

TEST_CASE("an iteration that does not converge is named with what to set") {
  Scenario scenario = spin_up_scenario(wu_haug_blade(4, 4), 0.1);
  scenario.integration.max_iterations = 2;
  check_parts(diverge(scenario),
              {"the iteration still changes a coordinate by ", "after 2 iterations", "/ recovery\"",
               "set integration.step to 0.05 or less", "integration.max_iterations above 2"});
  scenario.integration.step = 0.005;
  scenario.integration.max_iterations = 30;
  scenario.integration.tolerance = 1e-30;
  check_parts(diverge(scenario), {"that is round-off: set integration.tolerance to 1e-12"});
}

TEST_CASE("a load that is not finite is named in the step it appears in") {
  // The chords of this curve overflow: it is finite up to its second point only.
  const double huge = std::numeric_limits<double>::max();
  for (const IntegrationMethod method :
       {IntegrationMethod::generalized_alpha, IntegrationMethod::rk4}) {
    Scenario scenario = spin_up_scenario(wu_haug_blade(2, 4), 0.01);
    scenario.integration.method = method;
    if (method == IntegrationMethod::rk4) scenario.integration.step = 1e-4;
    Curve factor({0.0, 0.10503, 0.2, 0.3}, {0.0, 0.0, huge, -huge});
    scenario.rotor.loads.push_back(tip_load(2, factor));
    REQUIRE(std::isfinite(factor.value(0.105)));
    REQUIRE_FALSE(std::isfinite(factor.value(0.10505)));
    const bool is_rk4 = method == IntegrationMethod::rk4;
    check_parts(diverge_unchecked(scenario),
                {is_rk4 ? "t = 0.1051 s, step 1051: " : "t = 0.11 s, step 11: ",
                 "blade 3 / body 2: the load at x = 4 m in its frame is not finite",
                 "(node \"blade 3 / body 2 / mass\")", "correct it"});
  }
}

TEST_CASE("a load that is no number at the start is named at t = 0") {
  Scenario scenario = spin_up_scenario(wu_haug_blade(2, 4), 0.01);
  PointLoad load = tip_load(0, Curve(1.0));
  load.moment = std::numeric_limits<double>::quiet_NaN();
  scenario.rotor.loads.push_back(load);
  check_parts(diverge_unchecked(scenario),
              {"t = 0 s, step 0: blade 1 / body 2: the load at x = 4 m in its frame"});
}

TEST_CASE("a drive that is not finite is named") {
  Scenario scenario = spin_up_scenario(wu_haug_blade(2, 4), 0.01);
  const double huge = std::numeric_limits<double>::max();
  SUBCASE("prescribed motion") {
    scenario.rotor.hub.drive = SpeedTable{Curve({0.0, 0.10503, 0.2, 0.3}, {0.0, 0.0, huge, -huge})};
  }
  SUBCASE("torque") {
    scenario.rotor.hub.drive =
        TorqueDrive{Curve({0.0, 0.10503, 0.2, 0.3}, {0.0, 0.0, huge, -huge}), 0.0};
  }
  check_parts(diverge_unchecked(scenario), {"t = 0.11 s, step 11: ", "is not finite",
                                            "the drive's motion or torque is not finite"});
}
