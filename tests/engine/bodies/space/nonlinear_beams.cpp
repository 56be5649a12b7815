// Describes the beams, and asks the engine for modes and critical loads.

#include "tests/engine/bodies/space/nonlinear_beams.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "engine/critical.h"
#include "engine/modes.h"

namespace spoke::test {
namespace {

constexpr const char* kTree = "s";
constexpr const char* kPush = "push";

}  // namespace

spatial::Beam make_nonlinear_beam(const UniformSection& section, double length, const Cut& cut) {
  const auto along = [](double value) { return std::vector<double>{value, value}; };
  spatial::Beam beam;
  beam.length = length;
  beam.bodies = cut.bodies;
  beam.elements = cut.elements;
  beam.strain = spatial::BeamStrain::nonlinear;
  spatial::Sections& sections = beam.sections;
  sections.station = {0.0, length};
  sections.axial_stiffness = along(section.axial);
  sections.flap_stiffness = along(section.flap);
  sections.lag_stiffness = along(section.lag);
  sections.torsion_stiffness = along(section.torsion);
  sections.mass_per_length = along(section.mass);
  sections.flap_inertia = along(section.flap_inertia);
  sections.lag_inertia = along(section.lag_inertia);
  return beam;
}

spatial::RigidBody make_ball(double mass, double inertia) {
  spatial::RigidBody ball;
  ball.mass = mass;
  ball.inertia = inertia * Eigen::Matrix3d::Identity();
  return ball;
}

BeamTree::BeamTree() {
  scenario.name = "beams";
  scenario.limits.deflection = 0.0;
  spatial::Model& model = scenario.space.emplace();
  model.hub.drive = FixedDrive{};
  model.subsystems.push_back({.name = kTree});
}

spatial::SubsystemJoint& BeamTree::add(const std::string& name,
                                       const std::variant<spatial::Beam, spatial::RigidBody>& shape,
                                       spatial::JointKind kind, const spatial::Vector& axis) {
  spatial::SubsystemJoint joint;
  joint.parent = tree().bodies.empty() ? "hub" : tree().bodies.back().name;
  joint.child = name;
  joint.joint.kind = kind;
  joint.joint.axes[0] = axis;
  spatial::Body body{name, {}};
  std::visit([&body](const auto& any) { body.shape = any; }, shape);
  tree().bodies.push_back(body);
  return tree().joints.emplace_back(joint);
}

spatial::PointLoad& BeamTree::push(const std::string& body, spatial::LoadFrame frame,
                                   const spatial::Vector& force, const spatial::Vector& moment) {
  spatial::PointLoad load;
  load.place.subsystem = kTree;
  load.place.body = body;
  load.frame = frame;
  load.force = force;
  load.moment = moment;
  load.name = kPush;
  return model().loads.emplace_back(load);
}

spatial::DistributedLoad& BeamTree::push_along(const std::string& body, spatial::LoadFrame frame,
                                               const spatial::Vector& force_per_length) {
  spatial::DistributedLoad load;
  load.place.subsystem = kTree;
  load.place.body = body;
  load.frame = frame;
  load.force_per_length = force_per_length;
  load.name = kPush;
  return model().distributed_loads.emplace_back(load);
}

Loop& BeamTree::close(LoopKind kind, const std::string& body, const spatial::Vector& place) {
  Loop loop;
  loop.name = "loop" + std::to_string(tree().loops.size());
  loop.kind = kind;
  loop.from.name = body;
  loop.to.carrier = LoopPlace::Carrier::hub;
  loop.to.point = place;
  return tree().loops.emplace_back(loop);
}

void BeamTree::watch(const std::string& name, const std::string& body,
                     std::optional<double> position) {
  Sensor sensor;
  sensor.name = name;
  sensor.subsystem = kTree;
  sensor.body = body;
  sensor.position = position;
  sensor.frame = SensorFrame::inertial;
  scenario.sensors.push_back(sensor);
}

void BeamTree::run_for(double step, double duration) {
  scenario.integration.step = step;
  scenario.integration.duration = duration;
}

spatial::MotionTable move(const std::vector<double>& times, const std::vector<double>& values) {
  return {Curve(times, values)};
}

std::vector<double> find_frequencies(const Scenario& scenario,
                                     const std::vector<std::string>& names) {
  const ModesResult result = solve_modes(scenario);
  std::vector<double> frequencies;
  for (const std::string& name : names) {
    const auto mode = std::find_if(result.modes.begin(), result.modes.end(),
                                   [&name](const Mode& any) { return any.name == name; });
    REQUIRE_MESSAGE(mode != result.modes.end(), name);
    frequencies.push_back(mode->frequency);
  }
  return frequencies;
}

double find_critical_push(const Scenario& scenario, double from, double to) {
  CriticalOptions options;
  options.of = std::string("load=") + kPush;
  options.from = from;
  options.to = to;
  options.points = 4;
  options.count = 6;
  const CriticalResult result = solve_critical(scenario, options);
  REQUIRE(result.critical);
  return result.critical->value;
}

}  // namespace spoke::test
