// The error of a step that generalized_alpha tells, against closed forms; that steps are iterated
// to a share of it; and what is said of steps that are too large.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engine/simulation.h"
#include "models/space/rotation_vector.h"
#include "tests/approx.h"
#include "tests/contains.h"
#include "tests/shipped.h"

using namespace spoke;
using namespace spoke::test;
using spoke::testing::approx;

namespace {

const SimulationOptions kSerial{Formulation::structured, ExecutorKind::serial, 1, 1};

/// Equal within a share of the value.
doctest::Approx within(double share, double value) { return approx(value).epsilon(share); }

Scenario parse(const std::string& text) {
  return parse_scenario("world = 'space'\n" + text, "steps.toml");
}

Scenario with_step(Scenario scenario, double step) {
  scenario.integration.step = step;
  return scenario;
}

/// A symmetric top on a spherical joint at its centre, turning freely.
constexpr double kAcross = 1.5, kAlong = 2.6;  // kg m^2
const space::Angular kSpin(0.4, 0.3, 0.9);     // rad/s
Scenario top_scenario(double duration) {
  Scenario scenario = parse(R"(
hub.drive.kind = 'fixed'
[[subsystem]]
name = 'top'
[[subsystem.body]]
name = 'body'
kind = 'rigid'
mass = 1.0
inertia = [1.5, 1.5, 2.6]
[[subsystem.joint]]
parent = 'hub'
child = 'body'
kind = 'spherical'
initial_speed = [0.4, 0.3, 0.9]
[integration]
duration = 1.0
)");
  scenario.integration.duration = duration;
  return scenario;
}

/// It precesses about its angular momentum, and turns about its axis in its own frame.
space::Rotation exact_top(double t) {
  const space::Angular momentum(kAcross * kSpin[0], kAcross * kSpin[1], kAlong * kSpin[2]);
  const double own = kSpin[2] * (1.0 - kAlong / kAcross);
  return space::exponential(space::Angular(momentum * (t / kAcross))) *
         space::exponential(space::Angular(0.0, 0.0, own * t));
}

/// Angle between the top and where it should be at the end [rad].
double error_of_top(Simulation& simulation) {
  simulation.run_until(INFINITY);
  space::Angular turn;
  for (int c = 0; c < 3; ++c) turn[c] = simulation.sensor("top.joint1." + std::to_string(c + 1));
  return logarithm(exact_top(simulation.time()).inverse() * space::exponential(turn)).norm();
}

/// A slow free hub with a body on a soft joint beside its axes. The first iteration of a step of
/// 2.5 ms changes nothing by more than 1e-10.
const char* const kSlow = R"(
[hub]
support = 'free'
mass = 4.0
inertia = [0.4, 0.6, 0.9]
angular_velocity = [0.1, 0.2, 0.1]
[[subsystem]]
name = 's'
[[subsystem.body]]
name = 'body'
kind = 'rigid'
mass = 1.0
center = [0.6, 0.2, 0.1]
inertia = [0.02, 0.06, 0.07]
[[subsystem.joint]]
parent = 'hub'
child = 'body'
kind = 'spherical'
offset = [0.2, 0.3, 0.0]
stiffness = 0.5
[integration]
duration = 2.0
)";

space::Angular turn_of_hub(const Scenario& scenario) {
  Simulation simulation(scenario, kSerial);
  simulation.run_until(INFINITY);
  return {simulation.sensor("hub.rotation.x"), simulation.sensor("hub.rotation.y"),
          simulation.sensor("hub.rotation.z")};
}

/// Tumbles so fast that the default step loses momentum and gains energy.
const char* const kTumbling = R"(
[hub]
support = 'free'
mass = 4.0
inertia = [0.4, 0.6, 0.9]
angular_velocity = [12.0, 32.0, -16.0]
[[subsystem]]
name = 'left'
[[subsystem.body]]
name = 'arm'
kind = 'rigid'
mass = 1.0
center = [0.6, 0.0, 0.1]
inertia = [0.02, 0.06, 0.07]
[[subsystem.body]]
name = 'end'
kind = 'rigid'
mass = 0.5
center = [0.3, 0.05, 0.0]
inertia = [0.01, 0.02, 0.025]
[[subsystem.joint]]
parent = 'hub'
child = 'arm'
kind = 'spherical'
offset = [0.2, 0.0, 0.0]
stiffness = 120.0
[[subsystem.joint]]
parent = 'arm'
child = 'end'
kind = 'revolute'
axis = [0, 0, 1]
offset = [1.0, 0.0, 0.0]
stiffness = 60.0
[[subsystem]]
name = 'right'
[[subsystem.body]]
name = 'boom'
kind = 'rigid'
mass = 0.8
center = [-0.5, 0.0, 0.0]
inertia = [0.01, 0.05, 0.05]
[[subsystem.joint]]
parent = 'hub'
child = 'boom'
kind = 'spherical'
offset = [-0.2, 0.1, 0.0]
stiffness = 120.0
[[sensor]]
name = 'p'
quantity = 'momentum'
[integration]
duration = 10.0
)";

/// Results of a run of the tumbling model.
struct Tumbled {
  std::vector<Warning> warnings;
  StepAccuracy accuracy;
  double energy = 0.0;    ///< largest residual by the energy [-]
  double momentum = 0.0;  ///< largest change of the angular momentum about the hub, by itself [-]
  double told = 0.0;      ///< largest momentum.residual.angular [kg m^2/s]
};

struct Momentum {
  space::Position linear;
  space::Angular angular;
};
Momentum momentum_of(const Simulation& simulation) {
  const auto read = [&](const char* name) { return simulation.sensor(name); };
  return {{read("p.x"), read("p.y"), read("p.z")},
          {read("p.angular.x"), read("p.angular.y"), read("p.angular.z")}};
}

Tumbled tumble(double step, Formulation formulation = Formulation::structured) {
  Simulation simulation(with_step(parse(kTumbling), step),
                        {formulation, ExecutorKind::serial, 1, 1});
  const Momentum start = momentum_of(simulation);
  const double energy = simulation.sensor("energy.kinetic");
  Tumbled tumbled;
  simulation.run_until(INFINITY, [&](double, std::span<const double> values) {
    const auto at = [&](const char* name) { return values[simulation.sensor_index(name)]; };
    const space::Position hub(at("hub.x"), at("hub.y"), at("hub.z"));
    const space::Position p(at("p.x"), at("p.y"), at("p.z"));
    const space::Angular l(at("p.angular.x"), at("p.angular.y"), at("p.angular.z"));
    const space::Angular change = l - start.angular - cross(hub, space::Position(p - start.linear));
    tumbled.momentum = std::max(tumbled.momentum, change.norm() / start.angular.norm());
    tumbled.told = std::max(tumbled.told, at("momentum.residual.angular"));
    tumbled.energy = std::max(tumbled.energy, std::abs(at("energy.residual")) / energy);
  });
  CHECK(tumbled.told == within(1e-6, tumbled.momentum * start.angular.norm()));
  tumbled.warnings = simulation.warnings();
  tumbled.accuracy = simulation.step_accuracy();
  return tumbled;
}

const Warning* find(const std::vector<Warning>& warnings, WarningKind kind) {
  const auto found = std::find_if(warnings.begin(), warnings.end(),
                                  [kind](const Warning& warning) { return warning.kind == kind; });
  return found == warnings.end() ? nullptr : &*found;
}

}  // namespace

TEST_CASE("the error of a step is that of the closed form of a top") {
  for (const double step : {0.1, 0.05, 0.02}) {
    CAPTURE(step);
    Simulation simulation(with_step(top_scenario(step), step), kSerial);
    const double error = error_of_top(simulation);
    const StepAccuracy told = simulation.step_accuracy();
    CHECK(told.place == "the joint of top / body 1");
    CHECK(told.time == approx(step));
    CHECK(told.error == within(0.25, error));
  }
}

TEST_CASE("the error of a step of an oscillator") {
  // q = cos(w t)/10: the step leaves out (1/12 + (af - am)^2/4) h^3 q'''.
  const Scenario scenario = parse(R"(
hub.drive.kind = 'fixed'
[[subsystem]]
name = 'mass'
[[subsystem.body]]
name = 'body'
kind = 'rigid'
mass = 2.0
inertia = [1, 1, 1]
[[subsystem.joint]]
parent = 'hub'
child = 'body'
kind = 'prismatic'
axis = [1, 0, 0]
stiffness = 50.0
initial = 0.1
[integration]
step = 0.01
duration = 3.0
)");
  Simulation simulation(scenario, kSerial);
  simulation.run_until(INFINITY);
  const double d = (1.0 - 0.8) / (1.0 + 0.8), reach = std::sqrt(1.5 / 2.0);
  const double expected = (1.0 / 12.0 + d * d / 4.0) * std::pow(0.01 * 5.0, 3) * 0.1 / reach;
  CHECK(simulation.step_accuracy().error == within(0.05, expected));
}

TEST_CASE("smaller steps have the method's order, down to the least errors") {
  SUBCASE("a top") {
    std::vector<double> errors;
    for (const double step : {0.008, 0.004, 0.002, 0.001}) {
      Simulation simulation(with_step(top_scenario(2.0), step), kSerial);
      errors.push_back(error_of_top(simulation));
    }
    CAPTURE(errors.back());
    for (std::size_t k = 1; k < errors.size(); ++k)
      CHECK(errors[k - 1] / errors[k] == within(0.03, 4.0));
    CHECK(errors.back() < 1e-6);
  }
  SUBCASE("a hub with a body, against rk4") {
    // Where the iteration goes on to 1e-10 the third ratio is 1.7.
    Scenario fine = with_step(parse(kSlow), 0.002);
    fine.integration.method = IntegrationMethod::rk4;
    const space::Angular expected = turn_of_hub(fine);
    std::vector<double> errors;
    for (const double step : {0.01, 0.005, 0.0025, 0.00125})
      errors.push_back((turn_of_hub(with_step(parse(kSlow), step)) - expected).norm());
    CAPTURE(errors.back());
    for (std::size_t k = 1; k < errors.size(); ++k)
      CHECK(errors[k - 1] / errors[k] == within(0.03, 4.0));
    CHECK(errors.back() < 1e-8);
  }
}

TEST_CASE("a tolerance that is given is kept") {
  const auto passes = [](double step, const std::string& keys) {
    const Scenario scenario = parse(kSlow + keys);
    Simulation simulation(with_step(scenario, step), kSerial);
    simulation.run_until(INFINITY);
    return static_cast<double>(simulation.evaluations() - 1) /
           static_cast<double>(simulation.steps());
  };
  // Where one iteration does what the step's error asks for.
  CHECK(passes(0.0025, "") < 1.01);
  CHECK(passes(0.0025, "iterate_to = 'tolerance'") < 1.01);
  CHECK(passes(0.01, "") < 1.2);
  CHECK(passes(0.01, "tolerance = 1e-14") > 1.9);
  CHECK(passes(0.01, "tolerance = 1e-14\niterate_to = 'error'") > 1.9);
  // At large steps it asks for less than 1e-10.
  CHECK(passes(0.2, "") < 3.0);
  CHECK(passes(0.2, "tolerance = 1e-10") > 4.0);
  CHECK(passes(0.2, "iterate_to = 'tolerance'") > 4.0);
}

TEST_CASE("a step that is too large for a tumbling hub is told, with one that is not") {
  const Tumbled coarse = tumble(0.005);
  CHECK(coarse.energy > 0.02);
  CHECK(coarse.momentum > 0.02);
  const Warning* warning = find(coarse.warnings, WarningKind::step_error);
  REQUIRE(warning);
  CAPTURE(warning->text);
  CHECK(contains(warning->text, "the step is too large for the motion"));
  CHECK(contains(warning->text, "take an integration.step of 0.00"));
  REQUIRE(find(coarse.warnings, WarningKind::momentum));
  CHECK(contains(find(coarse.warnings, WarningKind::momentum)->text, "the angular momentum of"));
  CHECK(coarse.accuracy.error > 1e-3);
  const Tumbled fine = tumble(coarse.accuracy.step);
  CHECK(fine.accuracy.error <= 2e-4);
  CHECK(fine.energy < 0.002);
  CHECK(fine.momentum < 0.005);
  CHECK(fine.warnings.empty());
}

TEST_CASE("all formulations tell the same error of a step") {
  Scenario scenario = with_step(parse(kTumbling), 0.005);
  scenario.integration.duration = 0.1;
  std::vector<double> errors;
  for (const Formulation formulation : formulations()) {
    Simulation simulation(scenario, {formulation, ExecutorKind::serial, 1, 1});
    simulation.run_until(INFINITY);
    errors.push_back(simulation.step_accuracy().error);
  }
  CHECK(errors[1] == within(1e-6, errors[0]));
  CHECK(errors[2] == within(1e-6, errors[0]));
}

TEST_CASE("a state that is restored has its error of a step and its iteration") {
  Scenario scenario = with_step(parse(kTumbling), 0.005);
  scenario.integration.duration = 1.0;
  Simulation whole(scenario, kSerial), part(scenario, kSerial), rest(scenario, kSerial);
  whole.run_until(INFINITY);
  part.run_until(0.5);
  rest.restore(part.save());
  rest.run_until(INFINITY);
  CHECK(rest.state_hash() == whole.state_hash());
  CHECK(rest.evaluations() == whole.evaluations());
  CHECK(rest.step_accuracy().error == whole.step_accuracy().error);
  CHECK(rest.step_accuracy().time == whole.step_accuracy().time);
}

TEST_CASE("the steps of shipped scenarios are small enough") {
  for (const char* name : {"andrews_squeezer",
                           "articulated_rotor",
                           "bricard",
                           "drone_rotor",
                           "four_bar",
                           "free_hub_satellite",
                           "ground_resonance",
                           "helicopter_on_gear",
                           "helicopter_rotor",
                           "nrel_5mw_rotor",
                           "nrel_5mw_turbine",
                           "paper_rotor",
                           "quadcopter",
                           "satellite_booms",
                           "simo_vu_quoc_beam",
                           "solid_blade_rotor",
                           "solid_bracket",
                           "spatial_wu_haug",
                           "spin_up_hold_spin_down",
                           "tree_of_bodies",
                           "vehicle",
                           "whirl_rotor",
                           "wu_haug_rotor",
                           "wu_haug_solid"}) {
    CAPTURE(name);
    Scenario scenario = read_shipped(name);
    Simulation simulation(scenario, kSerial);
    simulation.run_until(300 * simulation.step_size(), [](double, std::span<const double>) {});
    CHECK_FALSE(simulation.step_accuracy().place.empty());
    CHECK_FALSE(find(simulation.warnings(), WarningKind::step_error));
    CHECK_FALSE(find(simulation.warnings(), WarningKind::momentum));
  }
}

TEST_CASE("rk4 tells no error of a step") {
  Scenario scenario = with_step(parse(kSlow), 0.01);
  scenario.integration.method = IntegrationMethod::rk4;
  Simulation simulation(scenario, kSerial);
  simulation.run_until(0.1);
  CHECK(simulation.step_accuracy().place.empty());
  CHECK(simulation.step_accuracy().error == 0.0);
}

TEST_CASE("a hub without mass on a support leaves rigid bodies the length that errors go by") {
  const std::string text = R"(
hub = { inertia = 5.0, drive = { kind = 'constant', speed = 3.0 } }
[support]
body = [ { name = 'stage', kind = 'rigid', mass = 2.0, inertia = 1.0 } ]
joint = [ { parent = 'ground', child = 'stage', kind = 'prismatic', axis = [1, 0, 0], initial = 0.1, stiffness = 200.0 } ]
axle = { body = 'stage' }
[[subsystem]]
name = 'arm'
body = [ { name = 'rod', kind = 'rigid', mass = 1.0, center = [0.5, 0, 0], inertia = [0.01, 0.1, 0.1] } ]
joint = [ { parent = 'hub', child = 'rod', kind = 'revolute', axis = [0, 0, 1], offset = [0.1, 0, 0] } ]
[integration]
step = 0.01
duration = 1.0
)";
  Simulation simulation(parse(text), kSerial);
  simulation.run_until(1.0);
  CHECK(simulation.step_accuracy().error > 1e-7);
  CHECK(simulation.step_accuracy().error < 1e-2);
}
