// Runs of rotors on supports: saved and restored, split, in checkpoints, with drives that change.

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "engine/checkpoint.h"
#include "engine/simulation.h"
#include "models/error.h"
#include "tests/engine/bodies/space/system/models.h"
#include "tests/message_of.h"
#include "tests/shown_values.h"

using namespace spoke;
using namespace spoke::test;

namespace {

constexpr int kSupportedSteps = 30;

const std::string kSupportedSensors = R"(
[[sensor]]
name = "top"
quantity = "acceleration"
subsystem = "support"
body = "tower"
frame = "inertial"
[[sensor]]
name = "axle"
quantity = "joint_reaction"
subsystem = "support"
body = "hub"
[[sensor]]
quantity = "hub_reaction"
)";
const std::string kStrut =
    "[[support.loop]]\nname = \"strut\"\nkind = \"distance\"\n"
    "from = { body = \"nacelle\", point = [0.2, 0.3, 0.1] }\n"
    "to = { body = \"ground\", point = [1.0, 1.5, -0.5] }\n";

struct SupportedCase {
  const char* name;
  std::string text;
};

std::vector<SupportedCase> supported_cases() {
  return {{"turned on a tower",
           make_text(kTurnedHub, kBooms + kHinges + kTower, kGravity + kSupportedSensors)},
          {"driven on a tower with a strut",
           make_text(kDrivenHub, kBooms + kTower + kStrut, kRisingGravity + kSupportedSensors)},
          {"controlled on a tower",
           make_text(kTurnedHub, kBooms + kControlledPitch + kTower, kGravity)},
          {"fixed to a fuselage", make_text(kFuselageHub, kBooms + kHinges)}};
}

void make_steps(int steps, Simulation& simulation) {
  for (int n = 0; n < steps; ++n) simulation.step();
}

/// Calls `check(scenario, formulation)` for all cases, methods and formulations.
template <class Check>
void for_all_supported(Check&& check) {
  for (const SupportedCase& which : supported_cases())
    for (const IntegrationMethod method :
         {IntegrationMethod::rk4, IntegrationMethod::generalized_alpha})
      for (const Formulation formulation : formulations()) {
        CAPTURE(which.name);
        CAPTURE(name_of(method));
        CAPTURE(name_of(formulation));
        check(make_scenario(which.text, 1e-3, 1.0, method), formulation);
      }
}

}  // namespace

TEST_CASE("a rotor on a support goes on from a checkpoint with the bits of the whole run") {
  for_all_supported([](const Scenario& scenario, Formulation formulation) {
    const SimulationOptions options{formulation, ExecutorKind::serial, 1, 1};
    Simulation whole(scenario, options);
    make_steps(kSupportedSteps / 2, whole);
    const std::string checkpoint = make_checkpoint(whole.save());
    const std::vector<double> shown = values_of(whole);
    const HubFrame hub = whole.hub_frame();
    const Wrench reaction = whole.hub_reaction();
    make_steps(kSupportedSteps / 2, whole);
    Simulation other(scenario, options);
    make_steps(3, other);  // it has been elsewhere
    other.restore(parse_checkpoint(checkpoint, "test").state);
    CHECK(values_of(other) == shown);
    CHECK(other.hub_frame().position == hub.position);
    CHECK(other.hub_frame().acceleration == hub.acceleration);
    CHECK(other.hub_reaction().moment == reaction.moment);
    make_steps(kSupportedSteps / 2, other);
    CHECK(other.state_hash() == whole.state_hash());
    CHECK(other.evaluations() == whole.evaluations());
    CHECK(values_of(other) == values_of(whole));
  });
}

TEST_CASE("a run of a rotor on a support is that of its single steps, and of views between them") {
  for_all_supported([](const Scenario& scenario, Formulation formulation) {
    Simulation single(scenario, {formulation, ExecutorKind::serial, 1});
    Simulation together(scenario, {formulation, ExecutorKind::flow_graph, 2});
    for (int n = 0; n < kSupportedSteps; ++n) {
      single.step();
      TreeShape shape;  // views change no state
      single.calc_shape(static_cast<int>(single.size().subsystems) - 1, shape);
      CHECK(single.hub_frame().position == single.hub_pose().position);
    }
    together.run_until(kSupportedSteps * together.step_size());
    CHECK(together.state_hash() == single.state_hash());
    CHECK(values_of(together) == values_of(single));
  });
}

TEST_CASE("a state of a rotor on a support fits no other support") {
  const auto make = [](const std::string& support) {
    return Simulation(make_scenario(make_text(kTurnedHub, kBooms + support), 1e-3, 1.0),
                      {Formulation::structured, ExecutorKind::serial, 1});
  };
  std::string taller = kTower;
  taller.replace(taller.find("mass = 1.5"), 10, "mass = 1.6");
  const Simulation first = make(kTower);
  Simulation second = make(taller);
  const std::uint64_t before = second.state_hash();
  CHECK(message_of([&] { second.restore(first.save()); }) != "no error");
  CHECK(second.state_hash() == before);
}

TEST_CASE("the drive of a rotor on a support may change between steps") {
  const Scenario scenario = make_scenario(make_text(kTurnedHub, kBooms + kTower), 1e-3, 1.0);
  Simulation simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1});
  make_steps(10, simulation);
  const double speed = simulation.sensor("hub.speed");
  simulation.set_drive(TorqueDrive{Curve(-3.0), 0.0});
  CHECK(std::get<TorqueDrive>(simulation.drive()).torque.value(0.0) == -3.0);
  simulation.step();
  CHECK(simulation.sensor("hub.torque") == doctest::Approx(-3.0));
  make_steps(20, simulation);
  CHECK(simulation.sensor("hub.speed") < speed);
  CHECK(message_of([&] { simulation.set_drive(FixedDrive{}); }) != "no error");
}
