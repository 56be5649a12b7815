// Tests closed loops at rest: propped beams, a link that leaves no freedom, and runs that start at
// an equilibrium.

#include <doctest/doctest.h>

#include <cmath>

#include "engine/linearize.h"
#include "engine/modes.h"
#include "engine/simulation.h"
#include "tests/engine/loop_models.h"
#include "tests/engine/small_motions/steady/blades.h"
#include "tests/engine/small_motions/steady/loop_mechanisms.h"
#include "tests/message_of.h"

namespace spoke {
namespace {

using Eigen::Vector3d;
using test::message_of;

/// Props the tip of a unit blade in the plane on the hub.
Scenario make_propped(LoopKind kind, const std::string& more = {}) {
  Scenario scenario = test::make_planar({.bodies = 2, .elements = 4, .more = more});
  Loop prop;
  prop.name = "prop";
  prop.kind = kind;
  prop.to = test::place_on(LoopPlace::Carrier::hub, {1.0, 0.0, 0.0});
  if (kind == LoopKind::prismatic) prop.axes[0] = Vector3d::UnitX();
  if (kind == LoopKind::distance) prop.to.point.y() = -1e3;
  scenario.rotor.blades[0].loops = {prop};
  return scenario;
}

TEST_CASE("loop statics: a propped beam in the plane vibrates as beam theory says") {
  // Clamped and pinned: tan b = tanh b; clamped and guided along x: cos b cosh b = 1.
  const double pinned = 3.92660231, guided = 4.73004074;
  for (const LoopKind kind : {LoopKind::distance, LoopKind::revolute}) {
    const ModesResult modes = solve_modes(make_propped(kind), {.count = 1});
    CHECK(modes.modes[0].frequency == doctest::Approx(pinned * pinned).epsilon(1e-4));
  }
  const ModesResult modes = solve_modes(make_propped(LoopKind::prismatic), {.count = 1});
  CHECK(modes.modes[0].frequency == doctest::Approx(guided * guided).epsilon(2e-4));
}

TEST_CASE("loop statics: a prop bears three eighths of a uniform load") {
  const EquilibriumResult result = solve_equilibrium(
      make_propped(LoopKind::distance, "[[distributed_load]]\nforce_per_length = [0.0, 1e-3]\n"));
  const BladeEquilibrium& blade = result.blades.at(0);
  CHECK(blade.loops.at(0).tension.value() == doctest::Approx(0.375e-3).epsilon(1e-6));
  CHECK(blade.loops.at(0).force.y() == doctest::Approx(-0.375e-3).epsilon(1e-6));
  CHECK(blade.loads.front().moment.z() == doctest::Approx(0.125e-3).epsilon(1e-6));
  CHECK(std::abs(blade.tip_displacement.y()) < 1e-10);
}

const std::string kHeld = "drive = { kind = \"constant\", speed = 0.0 }\n";

TEST_CASE("loop statics: a link that leaves no freedom bears what the weight asks for") {
  // The centre of mass is half as far from the axis as the horn.
  const Scenario scenario = test::make_pitching(kHeld);
  const EquilibriumResult result = solve_equilibrium(scenario);
  const LoopLoad& link = result.blades.at(0).loops.at(0);
  CHECK(link.tension.value() == doctest::Approx(-0.5 * 2.0 * 9.81).epsilon(1e-12));
  CHECK(link.moment.norm() == 0.0);
  CHECK(message_of([&] { solve_modes(scenario, {}); }).find("nothing of the model moves") !=
        std::string::npos);
  // A plate that is raised by 5 mm pitches the horn.
  Scenario raised = scenario;
  raised.space->anchors[0].motion = spatial::MountMotion{
      spatial::VectorTable{{Curve(0.0), Curve(0.0), Curve({0.0, 1.0}, {0.0, 0.005})}},
      spatial::VectorHarmonic{}};
  const double pitch = solve_equilibrium(raised).blades[0].joints.at(0).value;
  const double rod = std::hypot(0.1 - 0.1 * std::cos(pitch), 0.3 - 0.005 + 0.1 * std::sin(pitch));
  CHECK(pitch > 0.04);
  CHECK(rod == doctest::Approx(0.3).epsilon(1e-12));
}

TEST_CASE("loop statics: where the hub turns, the tilt of a swashplate counts with its mean") {
  Scenario scenario = test::make_pitching("drive = { kind = \"constant\", speed = 9.0 }\n");
  spatial::VectorHarmonic tilted, raised;
  tilted.constant = {0.05, -0.03, 0.0};
  raised.constant = {0.0, 0.0, 0.004};
  const auto solve = [&](const spatial::VectorHarmonic& rotation) {
    scenario.space->anchors[0].motion = spatial::MountMotion{raised, rotation};
    return solve_equilibrium(scenario).blades[0].joints.at(0).value;
  };
  // The length of the link is that at t = 0, where the plate is tilted, unless it is given.
  scenario.space->subsystems[0].loops[0].length = 0.3;
  CHECK(solve(tilted) == doctest::Approx(solve(spatial::VectorHarmonic{})).epsilon(1e-12));
  scenario.space->anchors[0].turns_with_hub = false;
  CHECK(message_of([&] {
          solve(tilted);
        }).find("loop \"link\" closes on an anchor of the mount, against which the hub turns") !=
        std::string::npos);
  raised.rate = {0.0, 0.0, 0.1};
  CHECK(message_of([&] { solve(tilted); }).find("anchor \"plate\" moves without end") !=
        std::string::npos);
}

TEST_CASE("loop statics: a run that starts at an equilibrium stays there, and bears its forces") {
  Scenario scenario = make_scenario(test::FourBar{});
  scenario.initial.state = InitialState::equilibrium;
  scenario.integration.duration = 0.5;
  scenario.integration.step = 0.01;
  scenario.sensors = {
      test::loop_sensor(SensorQuantity::loop_reaction, "pin", "four-bar", "pin", SensorFrame::hub)};
  const EquilibriumResult rest = solve_equilibrium(scenario);
  Simulation simulation(scenario);
  simulation.run_until(0.5);
  const auto& names = simulation.sensor_names();
  int found = 0;
  for (std::size_t k = 0; k < names.size(); ++k)
    for (int c = 0; c < 3; ++c)
      if (names[k] == std::string("four-bar.pin.force.") + "xyz"[c]) {
        ++found;
        CHECK(simulation.sensor_values()[k] ==
              doctest::Approx(rest.blades[0].loops[0].force[c]).epsilon(1e-7));
      }
  CHECK(found == 3);
}

TEST_CASE("loop statics: sensors of loops are outputs of the linear system") {
  Scenario scenario = make_scenario(test::FourBar{});
  scenario.sensors = {
      test::loop_sensor(SensorQuantity::loop_reaction, "pin", "four-bar", "pin", SensorFrame::hub)};
  const LinearSystem system = solve_linear_system(scenario);
  CHECK(system.left_out.empty());
  // Under a static torque of the crank's motor the pin's force changes by C x + D u, A x + B u = 0.
  const Eigen::MatrixXd A(system.A), B(system.B), C(system.C), D(system.D);
  const Eigen::VectorXd by_motor = D.col(0) - C.col(0) * (B(1, 0) / A(1, 0));
  const auto force = [&](double torque) {
    Scenario loaded = scenario;
    loaded.space->subsystems[0].joints[0].joint.coordinates[0].effort = Curve(torque);
    return Vector3d(solve_equilibrium(loaded).blades[0].loops[0].force);
  };
  const Vector3d slope = (force(1e-3) - force(-1e-3)) / 2e-3;
  int found = 0;
  for (std::size_t k = 0; k < system.outputs.size(); ++k)
    for (int c = 0; c < 3; ++c)
      if (system.outputs[k].name == std::string("four-bar.pin.force.") + "xyz"[c]) {
        ++found;
        CHECK(by_motor[static_cast<Eigen::Index>(k)] == doctest::Approx(slope[c]).epsilon(1e-5));
      }
  CHECK(found == 3);
}

}  // namespace
}  // namespace spoke
