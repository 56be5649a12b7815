// Reads sensors, the table and the wind.

#include "engine/simulation/control_record.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "engine/bodies/kernels/pitch_control.h"
#include "models/system/spatial_system.h"
#include "models/tree/hub_place.h"

namespace spoke {
namespace {

std::size_t find_sensor(const SimulatedModel& model, const std::string& name) {
  const std::vector<std::string>& names = model.sensor_names();
  const auto found = std::find(names.begin(), names.end(), name);
  assert(found != names.end());
  return static_cast<std::size_t>(found - names.begin());
}

/// Returns the direction from the axis of the hub to the root of a subsystem, frame of the hub with
/// z along its axis.
Eigen::Vector3d outward(const Subsystem<Space>& subsystem, const spatial::Tree& tree) {
  Eigen::Vector3d root = subsystem.root.p;
  root.z() = 0.0;
  const double length = root.norm();
  if (length > 0.0) return root / length;
  return {std::cos(tree.azimuth), std::sin(tree.azimuth), 0.0};
}

/// Returns the speed of what the drive of the first rotor turns, on the hub's side of a gearbox.
double find_drive_speed(const SystemContext<Space>& space, double hub_speed) {
  if (space.system.rotors.empty()) return hub_speed;
  const SupportedRotor& rotor = space.system.rotors.front();
  if (rotor.driven == rotor.body) return hub_speed;
  return space.data.subsystems[static_cast<std::size_t>(rotor.subsystem)]
             .bodies[static_cast<std::size_t>(rotor.driven)]
             .joint.coordinates.v[0] /
         rotor.gear_ratio;
}

/// Returns the angle that a subsystem is demanded, and its rate; zero where it is demanded none.
space::PrescribedMotion demanded(const SubsystemData<Space>& subsystem, double t) {
  return subsystem.controls.empty() ? space::PrescribedMotion{} : follow(subsystem.controls[0], t);
}

}  // namespace

ControlMeasurement::ControlMeasurement(const Scenario& scenario, SimulatedModel& model)
    : direction_(scenario.space->outer_control->direction),
      speed_(find_sensor(model, "hub.speed")),
      angle_(find_sensor(model, "hub.angle")),
      torque_(find_sensor(model, "hub.torque")) {
  const System<Space>& system = model.space()->system;
  const std::vector<spatial::Tree> trees = spatial::build_trees(*scenario.space);
  const std::vector<std::string>& names = model.sensor_names();
  auto column = names.begin();
  for (std::size_t i = 0; i < trees.size(); ++i) {
    column = std::find_if(column, names.end(),
                          [](const std::string& name) { return name.ends_with(".root.moment.x"); });
    assert(column != names.end());
    const bool is_support = scenario.space->support && i + 1 == trees.size();
    if (!is_support && trees[i].rotor == 0) {
      blades_.push_back(i);
      moments_.push_back(static_cast<std::size_t>(column - names.begin()));
      along_.emplace_back(0.0, 0.0, direction_);
      across_.push_back(outward(system.subsystems[i], trees[i]).cross(along_.back()));
    }
    ++column;
  }
}

ControlRecord ControlMeasurement::measure(const Scenario& scenario, SimulatedModel& model, double t,
                                          std::span<const double> sensors) const {
  constexpr double turn = 2.0 * std::numbers::pi;
  const SystemContext<Space>& space = *model.space();
  ControlRecord record;
  record.time = t;
  record.sensors = sensors;
  record.speed = direction_ * sensors[speed_];
  const double angle = direction_ * sensors[angle_];
  record.azimuth = angle - turn * std::floor(angle / turn);
  const double drive_speed = find_drive_speed(space, sensors[speed_]);
  record.drive_speed = direction_ * drive_speed;
  record.torque = direction_ * calc_torque(drive_of(space.system), t, drive_speed);
  record.shaft_torque = direction_ * sensors[torque_];
  for (std::size_t k = 0; k < blades_.size(); ++k) {
    const space::PrescribedMotion pitch = demanded(space.data.subsystems[blades_[k]], t);
    const double* const at = sensors.data() + moments_[k];
    const Eigen::Vector3d moment(at[0], at[1], at[2]);
    record.blades.push_back(
        {pitch.value, pitch.rate, moment.dot(across_[k]), moment.dot(along_[k])});
  }
  if (scenario.space->support) record.yaw = demanded(space.data.subsystems.back(), t).value;
  add_nacelle(scenario, model, record);
  return record;
}

/// Adds what is measured along and across the axis of the rotor, about the vertical.
void ControlMeasurement::add_nacelle(const Scenario& scenario, SimulatedModel& model,
                                     ControlRecord& record) const {
  const System<Space>& system = model.space()->system;
  const Eigen::Vector3d gravity = system.gravity;
  const Eigen::Vector3d up =
      gravity.norm() > 0.0 ? Eigen::Vector3d(-gravity.normalized()) : Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d axis =
      direction_ *
      (model.hub_pose().rotation * spatial::rotor_placement(scenario.space->hub).rotation).col(2);
  const Eigen::Vector3d level = axis - axis.dot(up) * up;
  const Eigen::Vector3d wind =
      system.wind
          ? Eigen::Vector3d(system.wind->velocity(find_hub_place(*scenario.space), record.time))
          : Eigen::Vector3d::Zero();
  record.wind_speed = (wind - wind.dot(up) * up).norm();
  constexpr double least = 1e-6;  // of an axis that is not upright
  if (level.norm() < least) return;
  const Eigen::Vector3d ahead = level.normalized();
  const Eigen::Vector3d aside = up.cross(ahead);
  if (record.wind_speed > 0.0) record.yaw_error = std::atan2(wind.dot(aside), wind.dot(ahead));
  const Eigen::Vector3d acceleration = model.hub_frame(record.time).acceleration;
  record.fore_aft = acceleration.dot(ahead);
  record.side_side = acceleration.dot(aside);
}

}  // namespace spoke
