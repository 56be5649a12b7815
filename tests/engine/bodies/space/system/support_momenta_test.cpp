// What a rotor on a support conserves: momenta of one that flies, energy of one on which nothing
// does work, and energy less work of all.

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "tests/engine/bodies/space/system/models.h"
#include "tests/engine/bodies/space/system/runs.h"

using namespace spoke;
using namespace spoke::test;

namespace {

constexpr double kMachineSeconds = 0.16;

/// Bodies of a support on a fuselage: a soft mast with a pylon on springs in all directions.
const std::string kMast = R"(
[[support.body]]
name = "mast"
kind = "beam"
length = 1.0
bodies = 1
elements = 2
[support.body.sections]
mass_per_length = 1.0
axial_stiffness = 2e4
lag_stiffness = 400.0
flap_stiffness = 300.0
torsion_stiffness = 300.0
[[support.body]]
name = "pylon"
kind = "rigid"
mass = 1.5
center = [0.1, 0.0, 0.05]
inertia = [0.05, 0.06, 0.07]
[[support.joint]]
child = "mast"
kind = "fixed"
orientation = [0.0, -1.2, 0.0]
offset = [0.2, 0.0, 0.3]
[[support.joint]]
parent = "mast"
child = "pylon"
kind = "bushing"
orientation = [0.0, 1.2, 0.0]
stiffness = [2e3, 3e3, 4e3, 60.0, 50.0, 40.0]
initial_speed = [0.3, 0.0, -0.2, 0.4, 0.0, 0.5]
[support.axle]
body = "pylon"
offset = [0.1, 0.0, 0.2]
orientation = [0.1, 0.2, 0.0]
)";
const std::string kFuselageText = kFuselageHub.substr(kFuselageHub.find("[support]"));

std::string hub_with(const std::string& drive) {
  return "[hub]\naxis = [0.2, 0.3, 1.0]\nradius = 0.1\nmass = 2.0\ncenter = [0.03, 0.02, 0.0]\n"
         "inertia = 0.5\ndrive = { " +
         drive + " }\n";
}
const std::string kFreeAxle = hub_with("kind = \"free\", initial_speed = 4.0");
const std::string kTorqueAxle = hub_with("kind = \"torque\", torque = 3.0, initial_speed = 4.0");
const std::string kSpinUpAxle = hub_with("kind = \"spin_up\", speed = 8.0, ramp = 0.5");

/// kTower without its damper.
const std::string kElasticTower = [] {
  std::string tower = kTower;
  return tower.erase(tower.find("damping = 0.1\n"), 14);
}();

const std::string kRotorPush =
    "[[hub_load]]\nposition = [0.1, 0.2, 0.0]\nforce = [1.0, 2.0, 3.0]\ntorque = [0.5, 0.3, 0.8]\n";
const std::string kTowerPush =
    "[[load]]\nsubsystem = \"support\"\nbody = \"tower\"\nframe = \"inertial\"\n"
    "force = [1.0, 3.0, -2.0]\nmoment = [0.2, 0.1, 0.3]\n";

/// Change of the energy, less work and plus what was dissipated, over a run [J].
double calc_machine_residual(const System<Space>& system, const Method& method,
                             Formulation formulation = Formulation::structured) {
  RunSetup setup{method};
  setup.formulation = formulation;
  Run<Space> run(system, setup);
  const double energy = calc_energy(run);
  run.advance_for(kMachineSeconds);
  CHECK(std::abs(run.work) > 1e-3);
  return std::abs(calc_energy(run) - energy - run.work + run.dissipated);
}

}  // namespace

TEST_CASE("a machine that flies keeps energy and momentum: rk4, of order 4") {
  for (const std::string& machine :
       {kBooms + kFuselageText, kBooms + kFuselageText + kMast, kTree + kFuselageText + kMast}) {
    const System<Space> system = make_system(parse_model(make_text(kFreeAxle, machine)));
    const Drift whole = calc_drift(system, Rk4{1e-3}, kMachineSeconds);
    const Drift half = calc_drift(system, Rk4{5e-4}, kMachineSeconds);
    CAPTURE(whole.energy);
    CAPTURE(half.energy);
    CHECK(half.energy < 1e-6);
    CHECK(whole.energy / half.energy > 13.0);
    CHECK(whole.momentum.norm() < 1e-6);
    CHECK(half.momentum.norm() < 1e-7);
  }
}

TEST_CASE("a drive that acts against its support changes no momentum of a machine that flies") {
  for (const std::string& hub : {kTorqueAxle, kSpinUpAxle})
    for (const Formulation formulation : formulations()) {
      CAPTURE(name_of(formulation));
      const System<Space> system =
          make_system(parse_model(make_text(hub, kBooms + kHinges + kFuselageText + kMast)));
      RunSetup setup{Rk4{5e-4}};
      setup.formulation = formulation;
      Run<Space> run(system, setup);
      const space::Twist before = calc_momentum(run);
      CHECK(before.norm() > 1.0);
      const double speed = run.context.data.rotors[0].turn.speed;
      run.advance_for(0.5 * kMachineSeconds);
      CHECK(std::abs(run.context.data.rotors[0].turn.speed - speed) > 0.1);
      CHECK((calc_momentum(run) - before).norm() < 1e-7);
    }
}

TEST_CASE("a machine that flies keeps energy and momentum: generalized_alpha, of order 2") {
  const System<Space> system =
      make_system(parse_model(make_text(kFreeAxle, kBooms + kFuselageText + kMast)));
  const auto drift = [&](double h) {
    return calc_drift(system, make_generalized_alpha(1.0, h), kMachineSeconds);
  };
  const Drift whole = drift(5e-4), half = drift(2.5e-4);
  CHECK(whole.energy / half.energy > 3.5);
  CHECK(half.momentum.norm() < 1e-4);
  CHECK(whole.momentum.norm() / half.momentum.norm() > 3.5);
}

TEST_CASE("a rotor on an elastic support from the ground keeps its energy, of order 4") {
  const System<Space> system =
      make_system(parse_model(make_text(kFreeAxle, kBooms + kElasticTower, kGravity)));
  const Drift whole = calc_drift(system, Rk4{1e-3}, kMachineSeconds);
  const Drift half = calc_drift(system, Rk4{5e-4}, kMachineSeconds);
  CHECK(half.energy < 1e-6);
  CHECK(whole.energy / half.energy > 13.0);
}

TEST_CASE("energy of a rotor on a support grows by what drive, mount, loads and dampers do") {
  const std::string ship =
      "[hub.mount]\n"
      "translation = { rate = [3.0, 0.5, 0.0], amplitude = [0.2, 0.1, 0.4], frequency = 5.0 }\n"
      "rotation = { constant = [0.1, 0.0, 0.2], amplitude = [0.3, -0.2, 0.0], frequency = 4.0 }\n";
  const std::string texts[] = {
      make_text(kTorqueAxle, kBooms + kHinges + kTower, kGravity + kTowerPush),
      make_text(kSpinUpAxle, kBooms + kHinges + kPitch + kTower, kRisingGravity + kRotorPush),
      make_text(kSpinUpAxle + ship, kBooms + kTower, kGravity),
      make_text(kTorqueAxle + ship, kBooms + kTower, kRisingGravity + kTowerPush),
      make_text(kTorqueAxle, kMotors + kFuselageText + kMast, kGravity + kRotorPush)};
  for (const std::string& text : texts) {
    const System<Space> system = make_system(parse_model(text));
    const double whole = calc_machine_residual(system, Rk4{1e-3});
    const double half = calc_machine_residual(system, Rk4{5e-4});
    CAPTURE(whole);
    CAPTURE(half);
    CHECK(half < 1e-6);
    CHECK(whole / half > 13.0);
  }
}
