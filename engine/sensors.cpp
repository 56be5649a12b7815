#include "engine/sensors.h"

#include "engine/body_terms.h"
#include "engine/kinematics.h"

namespace spoke {
namespace {

/// Poses, twists and terms at the state in the table.
void evaluate_state(const System& system, StepData& data) {
  data.hub = calc_hub_state(data.hub_coordinates);
  for (std::size_t i = 0; i < data.subsystems.size(); ++i) {
    SubsystemData& subsystem = data.subsystems[i];
    calc_rotations(system.subsystems[i], subsystem);
    calc_poses(system.subsystems[i], subsystem);
    calc_velocities(system.subsystems[i], data.hub, subsystem);
  }
}

}  // namespace

Energies calc_energies(const System& system, StepData& data) {
  evaluate_state(system, data);
  const double hub_speed = data.hub.twist[kRotation];
  const Position hub_velocity = data.hub.twist.head<kPosition>();
  const Position hub_position{data.hub_coordinates.q[0], data.hub_coordinates.q[1]};
  Energies energies;
  energies.kinetic = 0.5 * system.hub.mass * hub_velocity.squaredNorm() +
                     0.5 * system.hub.inertia * hub_speed * hub_speed;
  energies.gravity = system.hub.mass * system.gravity.dot(hub_position);
  for (std::size_t i = 0; i < data.subsystems.size(); ++i)
    for (std::size_t j = 0; j < data.subsystems[i].bodies.size(); ++j) {
      const BodyData& body = data.subsystems[i].bodies[j];
      const BodyInertia inertia = calc_inertia(body);
      energies.kinetic +=
          calc_kinetic_energy(body, inertia, data.subsystems[i].twists[j], hub_speed);
      energies.strain += calc_strain_energy(body);
      const Pose& X_HB = data.subsystems[i].poses[j];
      const Position moment = body.model->body->mass * X_HB.p + Position(X_HB.R * inertia.S);
      energies.gravity += system.gravity.dot(
          Position(body.model->body->mass * hub_position + Position(data.hub.R * moment)));
    }
  return energies;
}

Twist calc_tip_displacement(const Subsystem& subsystem, const SubsystemData& data) {
  const Position undeformed = subsystem.root.p + subsystem.root.R * Position{subsystem.length, 0.0};
  Position tip =
      data.poses.back().p + data.poses.back().R * calc_outboard_position(data.bodies.back());
  double rotation = 0.0;
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    const BodyData& body = data.bodies[j];
    tip -= data.poses[j].R * Position{calc_foreshortening(body), 0.0};
    rotation += body.coordinates.q[body.outboard_at[kRotation]] -
                body.coordinates.q[body.inboard_at[kRotation]];
  }
  const Position displacement = tip - undeformed;
  return {displacement.x(), displacement.y(), rotation};
}

Sensors::Sensors(const System& system) {
  for (std::size_t i = 0; i < system.subsystems.size(); ++i) {
    const std::string blade = "blade" + std::to_string(i + 1);
    add(blade + ".tip.x", "m");
    add(blade + ".tip.y", "m");
  }
  if (system.hub.support == HubSupport::free) {
    add("hub.x", "m");
    add("hub.y", "m");
  }
  add("hub.angle", "rad");
  add("hub.speed", "rad/s");
  add("hub.torque", "N m");
  add("energy.kinetic", "J");
  add("energy.strain", "J");
  add("energy.work", "J");
  add("energy.dissipated", "J");
  add("energy.residual", "J");
}

void Sensors::add(std::string name, std::string unit) {
  names_.push_back(std::move(name));
  units_.push_back(std::move(unit));
}

void Sensors::start(const System& system, StepData& data) {
  const Energies energies = calc_energies(system, data);
  initial_energy_ = energies.kinetic + energies.strain;
  initial_gravity_ = energies.gravity;
}

const std::vector<double>& Sensors::measure(const System& system, const WorkDone& work,
                                            StepData& data) {
  const Energies energies = calc_energies(system, data);
  values_.clear();
  for (std::size_t i = 0; i < data.subsystems.size(); ++i) {
    const Twist tip = calc_tip_displacement(system.subsystems[i], data.subsystems[i]);
    values_.insert(values_.end(), {tip[0], tip[1]});
  }
  const CoordinateBlock& hub = data.hub_coordinates;
  if (system.hub.support == HubSupport::free) values_.insert(values_.end(), {hub.q[0], hub.q[1]});
  const double torque = data.hub_solution.reaction[kRotation] + data.hub_solution.applied_torque;
  const double done = work.by_drive_and_loads + (energies.gravity - initial_gravity_);
  const double residual =
      energies.kinetic + energies.strain - initial_energy_ + work.dissipated - done;
  values_.insert(values_.end(), {hub.q[kRotation], hub.v[kRotation], torque, energies.kinetic,
                                 energies.strain, done, work.dissipated, residual});
  return values_;
}

}  // namespace spoke
