// What a support may be made of besides beams and rigid bodies: solids, joints with stops, bodies
// beside the way to the axle; and loads on them.

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "engine/simulation.h"
#include "tests/engine/bodies/space/system/models.h"
#include "tests/engine/solids/solid_models.h"

using namespace spoke;
using namespace spoke::test;

namespace {

using spatial::Vector;

/// A hub with blades on a solid bar that stands on the ground.
Scenario make_on_bar(spatial::SolidCoordinates coordinates) {
  Scenario scenario = make_scenario(
      make_text(kTurnedHub, kBooms,
                "[support]\n[[support.body]]\nname = \"bar\"\nkind = \"rigid\"\nmass = 1.0\n"
                "inertia = 0.1\n[[support.joint]]\nchild = \"bar\"\nkind = \"fixed\"\n"
                "orientation = [0, -1.2, 0]\n[support.axle]\nbody = \"bar\"\n"
                "orientation = [0, 1.2, 0]\n" +
                    kGravity),
      5e-4, 0.02, IntegrationMethod::generalized_alpha);
  scenario.integration.tolerance = 1e-12;
  spatial::SolidBody bar = make_bar(slender_grid(), rubber());
  bar.coordinates = coordinates;
  if (coordinates == spatial::SolidCoordinates::reduced) bar.modes = 6;
  spatial::Model& model = *scenario.space;
  model.subsystems.back().bodies[0].shape = bar;
  model.support->axle.interface = "tip";
  return scenario;
}

Simulation run_bar(const Scenario& scenario, Formulation formulation) {
  Simulation simulation(scenario, {formulation, ExecutorKind::serial, 1});
  simulation.run_until(scenario.integration.duration);
  return simulation;
}

/// kTower with keys of its yaw joint in place of its spring.
std::string tower_with(const std::string& keys) {
  std::string tower = kTower;
  const std::string spring = "stiffness = 40.0\ndamping = 0.1\n";
  return tower.replace(tower.find(spring), spring.size(), keys);
}

Simulation make_tower(const std::string& tower, IntegrationMethod method,
                      Formulation formulation = Formulation::structured,
                      const std::string& blades = kBooms, const std::string& more = kGravity) {
  Scenario scenario = make_scenario(make_text(kTurnedHub, blades + tower, more), 1e-3, 1.0, method);
  scenario.integration.tolerance = 1e-12;
  return Simulation(scenario, {formulation, ExecutorKind::serial, 1});
}

}  // namespace

TEST_CASE("a solid carries a rotor: formulations agree, the axle stands on its tip") {
  const Scenario scenario = make_on_bar(spatial::SolidCoordinates::reduced);
  const Simulation structured = run_bar(scenario, Formulation::structured);
  CHECK(std::abs(structured.sensor("support.tip.z")) > 1e-5);
  for (const Formulation formulation : {Formulation::subsystem, Formulation::augmented}) {
    const Simulation other = run_bar(scenario, formulation);
    for (const char* name : {"support.tip.x", "support.tip.z", "blade1.tip.z", "hub.angle"})
      CHECK(std::abs(structured.sensor(name) - other.sensor(name)) < 1e-9);
  }
  Marker tip{2, 0, 0.0};
  tip.interface = "tip";
  CHECK((structured.marker(tip).position - structured.hub_pose().position).norm() < 1e-12);
  CHECK(std::abs(structured.sensor("energy.residual")) <
        1e-4 * structured.sensor("energy.kinetic"));
}

TEST_CASE("a solid under a rotor moves alike in nodal coordinates, with all its vibrations kept") {
  Scenario reduced = make_on_bar(spatial::SolidCoordinates::reduced);
  std::get<spatial::SolidBody>(reduced.space->subsystems.back().bodies[0].shape).modes = 60;
  const Simulation few = run_bar(reduced, Formulation::structured);
  const Simulation all =
      run_bar(make_on_bar(spatial::SolidCoordinates::nodal), Formulation::structured);
  for (const char* name : {"hub.x", "hub.z", "blade1.tip.z"})
    CHECK(few.sensor(name) == doctest::Approx(all.sensor(name)).epsilon(1e-3));
}

TEST_CASE("a stop of a support's joint holds what turns against it") {
  const std::string stopped = tower_with(
      "damping = 0.1\ntorque = 20.0\n"
      "stop = { lower = -0.05, upper = 0.05, stiffness = 4e3, damping = 20.0, width = 0.01 }\n");
  const auto method = IntegrationMethod::generalized_alpha;
  Simulation free = make_tower(tower_with("torque = 20.0\n"), method, Formulation::structured, "");
  free.run_until(0.3);
  const std::string column = "support.joint2";
  CHECK(std::abs(free.sensor(column)) > 0.2);
  for (const Formulation formulation : formulations()) {
    Simulation held = make_tower(stopped, method, formulation, "");
    double most = 0.0;
    held.run_until(0.3, [&, at = held.sensor_index(column)](double, std::span<const double> row) {
      most = std::max(most, std::abs(row[at]));
    });
    CHECK(most > 0.05);
    CHECK(most < 0.09);
  }
}

TEST_CASE("a body beside the way to the axle is carried along, and all have the ground's loads") {
  const std::string branch = R"(
[[support.body]]
name = "absorber"
kind = "rigid"
mass = 0.6
inertia = [0.01, 0.02, 0.02]
[[support.joint]]
name = "absorber"
parent = "tower"
station = 1.0
child = "absorber"
kind = "prismatic"
axis = [0.0, 1.0, 0.0]
stiffness = 60.0
initial_speed = 0.5
[[load]]
subsystem = "support"
body = "absorber"
frame = "inertial"
force = [0.0, 3.0, 1.0]
)";
  std::string tower = kTower;
  const std::size_t axle = tower.find("[support.axle]");
  const std::size_t loads = branch.find("[[load]]");
  tower.insert(axle, branch.substr(0, loads));
  const std::string more = kGravity + branch.substr(loads);
  const auto end = [&](Formulation formulation, IntegrationMethod method) {
    Simulation simulation = make_tower(tower, method, formulation, kBooms, more);
    simulation.run_until(0.05);
    return simulation;
  };
  for (const IntegrationMethod method :
       {IntegrationMethod::rk4, IntegrationMethod::generalized_alpha}) {
    const Simulation structured = end(Formulation::structured, method);
    CHECK(std::abs(structured.sensor("support.absorber")) > 0.01);
    for (const Formulation formulation : {Formulation::subsystem, Formulation::augmented}) {
      const Simulation other = end(formulation, method);
      for (const char* name : {"support.absorber", "support.tip.y", "blade1.tip.z", "hub.angle"})
        CHECK(std::abs(structured.sensor(name) - other.sensor(name)) < 1e-9);
    }
  }
  CHECK(std::abs(end(Formulation::structured, IntegrationMethod::rk4).sensor("energy.residual")) <
        1e-5);
}
