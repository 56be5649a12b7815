// A swashplate beside the axle of a hub on a support: it moves with what carries the axle, and its
// forces rest there.

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "engine/simulation.h"
#include "tests/engine/bodies/space/system/models.h"
#include "tests/engine/bodies/space/system/runs.h"
#include "tests/shipped.h"

using namespace spoke;
using namespace spoke::test;

namespace {

const SimulationOptions kSerialRun{Formulation::structured, ExecutorKind::serial, 1};

spatial::VectorHarmonic make_harmonic(const spatial::Vector& constant,
                                      const spatial::Vector& amplitude, double frequency) {
  spatial::VectorHarmonic made;
  made.constant = constant;
  made.amplitude = amplitude;
  made.frequency = frequency;
  return made;
}

/// The rotor of helicopter_rotor.toml, whose pitch links stand on a swashplate, for a while in
/// which it has turned by some radians.
Scenario linked_helicopter() {
  Scenario scenario = read_shipped("helicopter_rotor");
  scenario.space->hub.drive = SpinUp{10.0, 0.3};
  spatial::MountMotion tilt;
  tilt.translation = make_harmonic({0.0, 0.0, 0.01}, {0.0, 0.0, 0.005}, 9.0);
  tilt.rotation = make_harmonic({0.03, -0.02, 0.0}, {0.01, 0.0, 0.0}, 7.0);
  scenario.space->anchors.at(0).motion = tilt;
  scenario.integration.method = IntegrationMethod::generalized_alpha;
  scenario.integration.step = 1e-3;
  scenario.integration.duration = 0.3;
  scenario.integration.tolerance = 1e-10;
  return scenario;
}

/// Puts its hub on a rigid body that is fixed to the ground, the swashplate beside the axle.
void put_on_block(Scenario& scenario) {
  spatial::Model& model = *scenario.space;
  spatial::Subsystem& tree = model.subsystems.emplace_back();
  tree.name = spatial::kSupportName;
  tree.bodies.push_back(
      {"block", spatial::RigidBody{50.0, spatial::Vector::Zero(), spatial::Tensor::Identity()}});
  tree.joints.emplace_back().child = "block";
  tree.joints.back().parent = "ground";
  model.support = spatial::Support{};
  model.support->axle.body = "block";
  for (Anchor& anchor : model.anchors) anchor.frame = Anchor::Frame::axle;
}

/// Puts another hub before that of a model on a block, which stands still. `on_it`: whether that
/// one carries the rotor, rather than the block.
void put_behind_another(bool on_it, spatial::Model& model) {
  spatial::Rotor& lifter = model.rotors.emplace_back();
  lifter.hub = model.hub;
  lifter.hub.name = "lifter";
  lifter.axle = model.support->axle;
  model.hub = {};
  model.hub.name = "plain";
  model.hub.mass = 2.0;
  model.hub.drive = FixedDrive{};
  for (spatial::Blade& blade : model.blades) blade.rotor = 1;
  for (spatial::Subsystem& subsystem : model.subsystems)
    if (!is_support(model, subsystem)) subsystem.rotor = 1;
  for (spatial::HubLoad& load : model.hub_loads) load.rotor = 1;
  for (Anchor& anchor : model.anchors) anchor.rotor = 1;
  if (!on_it) return;
  spatial::Subsystem post;
  post.name = "post";
  post.bodies.push_back(
      {"post", spatial::RigidBody{5.0, spatial::Vector::Zero(), spatial::Tensor::Identity()}});
  post.joints.emplace_back().child = "post";
  model.subsystems.insert(model.subsystems.begin(), post);
  lifter.axle.subsystem = lifter.axle.body = "post";
}

void check_same_sensors(const Scenario& held, const Scenario& supported) {
  Simulation a(held, kSerialRun), b(supported, kSerialRun);
  a.run_until(held.integration.duration);
  b.run_until(held.integration.duration);
  for (const std::string& name : a.sensor_names()) {
    if (name.starts_with("energy.")) continue;  // what the drive does, and what moves the plate
    CAPTURE(name);
    // Loops close to 1e-7; forces, of up to 1e5 N, are those of the last iterate.
    const bool is_motion = name.find(".tip.") != std::string::npos || name.ends_with(".angle") ||
                           name.find(".hinges") != std::string::npos;
    CHECK(std::abs(b.sensor(name) - a.sensor(name)) < (is_motion ? 2e-5 : 1.0));
  }
}

/// A hub on a fuselage that flies, with two blades whose pitch a tilted plate sets.
const std::string kPlateOnFuselage = R"(
[hub]
axis = [0.1, 0.2, 1.0]
radius = 0.1
mass = 2.0
inertia = 0.5
drive = { kind = "spin_up", speed = 8.0, ramp = 0.1 }
[support]
from = "free"
mass = 4.0
inertia = [0.4, 0.5, 0.6]
velocity = [0.3, -0.2, 0.5]
angular_velocity = [0.5, -0.4, 0.7]
[support.axle]
offset = [0.1, 0.0, 0.4]
orientation = [0.0, 0.1, 0.0]
[[anchor]]
name = "swashplate"
frame = "axle"
turns_with_hub = true
motion = { translation = { constant = [0.0, 0.0, -0.2] }, rotation = { constant = [0.1, -0.05, 0.0] } }
)";
const std::string kLinkedBlades = kBooms + R"(
[[blade.joint]]
name = "pitch"
station = 0.4
kind = "revolute"
axis = [1.0, 0.0, 0.0]
[[blade.loop]]
name = "link"
kind = "distance"
from = { station = 0.4, point = [0.0, 0.1, 0.0] }
to = { anchor = "swashplate", point = [0.5, 0.1, 0.0] }
)";

}  // namespace

TEST_CASE("a swashplate on a fixed support is one on the mount") {
  const Scenario held = linked_helicopter();
  Scenario supported = held;
  put_on_block(supported);
  check_same_sensors(held, supported);
}

TEST_CASE("a swashplate of a further rotor is one of the first, wherever the rotor stands") {
  Scenario first = linked_helicopter();
  put_on_block(first);
  for (const bool on_it : {false, true}) {
    Scenario further = first;
    put_behind_another(on_it, *further.space);
    Simulation a(first, kSerialRun), b(further, kSerialRun);
    a.run_until(first.integration.duration);
    b.run_until(first.integration.duration);
    int compared = 0;
    for (const std::string& name : a.sensor_names()) {
      if (!name.starts_with("blade")) continue;
      CAPTURE(name);
      CHECK(std::abs(b.sensor(name) - a.sensor(name)) < 1e-9 * (1.0 + std::abs(a.sensor(name))));
      ++compared;
    }
    CHECK(compared > 20);
    CHECK(b.sensor("lifter.hub.torque") == doctest::Approx(a.sensor("hub.torque")).epsilon(1e-9));
    const MarkerMotion plate = a.anchor_frame(0), same = b.anchor_frame(0);
    CHECK((plate.position - same.position).norm() < 1e-12);
    CHECK((plate.rotation - same.rotation).norm() < 1e-12);
    CHECK((plate.velocity - same.velocity).norm() < 1e-10);
  }
}

TEST_CASE("a swashplate on a support that the mount moves is one on that mount") {
  Scenario held = linked_helicopter();
  spatial::VectorHarmonic translation =
      make_harmonic(spatial::Vector::Zero(), {0.0, 0.02, 0.01}, 5.0);
  translation.rate = {1.0, 0.0, 0.0};
  held.space->hub.mount = spatial::MountMotion{
      translation, make_harmonic(spatial::Vector::Zero(), {0.05, -0.04, 0.03}, 6.0)};
  Scenario supported = held;
  put_on_block(supported);
  check_same_sensors(held, supported);
}

TEST_CASE("what a swashplate on a fuselage does changes no momentum") {
  const System<Space> system = make_system(parse_model(make_text(kPlateOnFuselage, kLinkedBlades)));
  for (const Formulation formulation : formulations()) {
    CAPTURE(name_of(formulation));
    RunSetup setup{Rk4{2.5e-4}};
    setup.formulation = formulation;
    Run<Space> run(system, setup);
    const space::Twist before = calc_momentum(run);
    CHECK(before.norm() > 1.0);
    run.advance_for(0.1);
    CHECK((calc_momentum(run) - before).norm() < 1e-6);
  }
}

TEST_CASE("a swashplate on a fuselage: formulations and executors agree") {
  const System<Space> system =
      make_system(parse_model(make_text(kPlateOnFuselage, kLinkedBlades, kGravity)));
  for (const Method& method : {Method{Rk4{5e-4}}, Method{make_generalized_alpha(0.8, 1e-3)}}) {
    Run<Space> structured(system, {method});
    structured.advance(40);
    for (const Formulation formulation : formulations()) {
      CAPTURE(name_of(formulation));
      RunSetup setup{method};
      setup.formulation = formulation;
      Run<Space> other(system, setup);
      other.advance(40);
      CHECK(largest_difference(structured, other) < 1e-9);
    }
    check_equal_bits(system, method, 40);
  }
}
