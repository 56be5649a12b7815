#include "tests/engine/small_motions/steady/loop_mechanisms.h"

#include <cmath>

namespace spoke::test {

using spatial::Vector;

Scenario make_mechanism(const spatial::Subsystem& subsystem) {
  Scenario scenario;
  scenario.name = "mechanism";
  spatial::Model& model = scenario.space.emplace();
  model.hub.mass = 1.0;
  model.hub.drive = ConstantSpeed{0.0};
  model.subsystems = {subsystem};
  return scenario;
}

spatial::Body make_rigid(const std::string& name, double mass, const Vector& center,
                         const Vector& inertia) {
  spatial::RigidBody body;
  body.mass = mass;
  body.center = center;
  body.inertia = inertia.asDiagonal();
  return {name, body};
}

spatial::SubsystemJoint make_joint(const std::string& parent, const std::string& child,
                                   spatial::JointKind kind, const Vector& offset,
                                   const Vector& axis) {
  spatial::SubsystemJoint joint;
  joint.parent = parent;
  joint.child = child;
  joint.joint.kind = kind;
  joint.joint.offset = offset;
  if (spatial::count_axes(kind) > 0) joint.joint.axes[0] = axis;
  return joint;
}

LoopPlace on_hub(const Vector& point) {
  LoopPlace place;
  place.carrier = LoopPlace::Carrier::hub;
  place.point = point;
  return place;
}

spatial::Beam make_beam(const UniformBeam& beam) {
  spatial::Beam made;
  made.length = beam.length;
  made.bodies = 1;
  made.elements = beam.elements;
  made.geometric_stiffening = beam.stiffening;
  const auto both = [](double value) { return std::vector<double>{value, value}; };
  made.sections.station = {0.0, beam.length};
  made.sections.axial_stiffness = both(beam.axial);
  made.sections.lag_stiffness = both(beam.lag);
  made.sections.flap_stiffness = both(beam.flap);
  made.sections.torsion_stiffness = both(beam.torsion);
  made.sections.mass_per_length = both(beam.mass_per_length);
  return made;
}

std::array<double, 3> FourBar::angles(double crank_angle) const {
  const double x = ground - crank * std::cos(crank_angle), y = -crank * std::sin(crank_angle);
  const double distance = std::hypot(x, y);
  const double open = std::acos((coupler * coupler + distance * distance - rocker * rocker) /
                                (2.0 * coupler * distance));
  const double of_coupler = std::atan2(y, x) + open;
  return {crank_angle, of_coupler,
          std::atan2(coupler * std::sin(of_coupler) - y, coupler * std::cos(of_coupler) - x)};
}

double FourBar::energy(double crank_angle) const {
  const auto [theta, phi, psi] = angles(crank_angle);
  const double heights = masses[0] * 0.5 * crank * std::sin(theta) +
                         masses[1] * (crank * std::sin(theta) + 0.5 * coupler * std::sin(phi)) +
                         masses[2] * 0.5 * rocker * std::sin(psi);
  return gravity * heights + 0.5 * stiffness * (theta - rest) * (theta - rest);
}

double FourBar::inertia(double crank_angle) const {
  // a theta' n(theta) + b phi' n(phi) = c psi' n(psi), n = (-sin, cos).
  const auto [theta, phi, psi] = angles(crank_angle);
  const double of_coupler = crank * std::sin(psi - theta) / (coupler * std::sin(phi - psi));
  const double of_rocker = crank * std::sin(phi - theta) / (rocker * std::sin(phi - psi));
  const double x = -crank * std::sin(theta) - 0.5 * coupler * of_coupler * std::sin(phi);
  const double y = crank * std::cos(theta) + 0.5 * coupler * of_coupler * std::cos(phi);
  return masses[0] * crank * crank / 3.0 + masses[1] * (x * x + y * y) +
         masses[1] * coupler * coupler / 12.0 * of_coupler * of_coupler +
         masses[2] * rocker * rocker / 3.0 * of_rocker * of_rocker;
}

Scenario make_scenario(const FourBar& bars) {
  const auto [theta, phi, psi] = bars.angles(bars.rest);
  const auto make_bar = [](const char* name, double mass, double length) {
    const double inertia = mass * length * length / 12.0;
    return make_rigid(name, mass, {0.5 * length, 0.0, 0.0}, {0.1 * inertia, inertia, inertia});
  };
  spatial::Subsystem four_bar;
  four_bar.name = "four-bar";
  four_bar.bodies = {make_bar("crank", bars.masses[0], bars.crank),
                     make_bar("coupler", bars.masses[1], bars.coupler),
                     make_bar("rocker", bars.masses[2], bars.rocker)};
  using spatial::JointKind;
  four_bar.joints = {make_joint("hub", "crank", JointKind::revolute),
                     make_joint("crank", "coupler", JointKind::revolute, {bars.crank, 0, 0}),
                     make_joint("hub", "rocker", JointKind::revolute, {bars.ground, 0, 0})};
  four_bar.joints[0].joint.coordinates[0].initial = theta;
  four_bar.joints[0].joint.coordinates[0].stiffness = bars.stiffness;
  four_bar.joints[0].joint.coordinates[0].rest = bars.rest;
  four_bar.joints[1].joint.coordinates[0].initial = phi - theta;
  four_bar.joints[2].joint.coordinates[0].initial = psi;
  Loop loop;
  loop.name = "pin";
  loop.kind = LoopKind::revolute;
  loop.from = on_body("coupler", {bars.coupler, 0, 0});
  loop.to = on_body("rocker", {bars.rocker, 0, 0});
  loop.axes[0] = Vector::UnitZ();
  four_bar.loops = {loop};
  Scenario scenario = make_mechanism(four_bar);
  scenario.space->gravity = {0.0, -bars.gravity, 0.0};
  return scenario;
}

}  // namespace spoke::test
