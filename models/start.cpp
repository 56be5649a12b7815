// The speeds at which each kind of drive can start, and the ramps that a start at an equilibrium
// leaves out.

#include "models/start.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <sstream>

namespace spoke {
namespace {

/// Returns the speed that a ramp up leads to; none for drives without a ramp.
std::optional<double> speed_after_ramp(const Drive& drive) {
  if (const auto* up = std::get_if<SpinUp>(&drive)) return up->speed;
  if (const auto* up_and_down = std::get_if<SpinUpHoldSpinDown>(&drive)) return up_and_down->speed;
  return std::nullopt;
}

bool is_free_in_space(const Scenario& scenario) {
  return scenario.space && scenario.space->hub.support == HubSupport::free;
}

/// Returns the speed that other keys give: that of the drive, or of a free hub in space about its
/// axis.
double said_speed(const Scenario& scenario) {
  if (is_free_in_space(scenario))
    return scenario.space->hub.angular_velocity.dot(scenario.space->hub.axis.normalized());
  return calc_initial_speed(drive_of(scenario));
}

std::string text_of(double speed) {
  std::ostringstream text;
  text << speed;
  return text.str();
}

/// Finds a fault of the start for a hub whose rotation is not prescribed.
StartFault find_free_speed_fault(const Scenario& scenario) {
  const bool is_torque = !std::holds_alternative<FreeDrive>(drive_of(scenario));
  const bool is_said = said_speed(scenario) != 0.0;
  const std::string key =
      is_free_in_space(scenario) ? "hub.angular_velocity" : "hub.drive.initial_speed";
  if (scenario.initial.speed && is_said)
    return {"speed", "given along with " + key + ", expected only one of them"};
  if (!scenario.initial.speed && !is_said && is_torque)
    return {"speed", "is missing, expected a speed: a torque has no steady one by itself"};
  return {};
}

StartFault find_prescribed_speed_fault(const Drive& drive, double speed) {
  const double first = calc_initial_speed(drive);
  const std::optional<double> then = speed_after_ramp(drive);
  if (speed == first || speed == then) return {};
  const std::string other = then ? ", or " + text_of(*then) + " after its ramp" : "";
  return {"speed", "is " + text_of(speed) + ", expected a speed that the drive has: " +
                       text_of(first) + " at its start" + other + " (rad/s)"};
}

/// Whether a free hub tumbles, so that it has no steady motion about its axis.
bool tumbles(const Scenario& scenario) {
  if (!is_free_in_space(scenario)) return false;
  const spatial::Hub& hub = scenario.space->hub;
  const spatial::Vector axis = hub.axis.normalized(), &spin = hub.angular_velocity;
  return (spin - axis * axis.dot(spin)).norm() > 1e-12 * spin.norm();
}

bool moves(const spatial::Joint& joint) {
  return std::any_of(
      joint.coordinates.begin(), joint.coordinates.end(),
      [](const spatial::JointCoordinate& coordinate) { return coordinate.initial_speed != 0.0; });
}
bool has_moving_joint(const spatial::Model& model) {
  for (const spatial::Blade& blade : model.blades)
    for (const spatial::BladeJoint& place : blade.joints)
      if (moves(place.joint)) return true;
  for (const spatial::Subsystem& subsystem : model.subsystems)
    for (const spatial::SubsystemJoint& place : subsystem.joints)
      if (moves(place.joint)) return true;
  return false;
}

/// Finds a fault of the start of rotors besides the first: their speeds are those that their drives
/// say.
StartFault find_further_speed_fault(const Scenario& scenario) {
  if (!scenario.space) return {};
  for (const spatial::Rotor& rotor : scenario.space->rotors) {
    const Drive& drive = rotor.hub.drive;
    const bool is_torque = !prescribes_motion(drive) && !std::holds_alternative<FreeDrive>(drive);
    if (is_torque && calc_initial_speed(drive) == 0.0)
      return {"state", "is an equilibrium, but the drive of the rotor \"" + rotor.hub.name +
                           "\" is a torque from rest, expected an initial_speed: a torque has no "
                           "steady one by itself"};
  }
  return {};
}

/// Finds a fault of a start at an equilibrium.
StartFault find_equilibrium_fault(const Scenario& scenario) {
  if (scenario.space && has_moving_joint(*scenario.space))
    return {"state",
            "is an equilibrium, but a joint has an initial_speed, expected only one of them"};
  if (tumbles(scenario))
    return {"state", "is an equilibrium, expected hub.angular_velocity along hub.axis"};
  if (StartFault fault = find_further_speed_fault(scenario); !fault.key.empty()) return fault;
  const Drive& drive = drive_of(scenario);
  return prescribes_motion(drive) ? find_prescribed_speed_fault(drive, start_speed(scenario))
                                  : find_free_speed_fault(scenario);
}

template <class Loads>
void skip_ramps(Loads& loads) {
  for (auto& load : loads) load.ramp = 0.0;
}
/// Ends the ramps of loads and gravity, for a rotor in the plane or a model in space.
template <class Model>
void skip_all_ramps(Model& model) {
  model.gravity_ramp = 0.0;
  skip_ramps(model.loads);
  skip_ramps(model.distributed_loads);
  skip_ramps(model.hub_loads);
}

void begin_at(double speed, Drive& drive) {
  if (auto* torque = std::get_if<TorqueDrive>(&drive)) torque->initial_speed = speed;
  if (auto* free = std::get_if<FreeDrive>(&drive)) free->initial_speed = speed;
  if (auto* by_speed = std::get_if<TorqueBySpeed>(&drive)) {
    by_speed->initial_speed = speed;
    by_speed->ramp = 0.0;
  }
  if (speed == calc_initial_speed(drive)) return;
  if (auto* up_and_down = std::get_if<SpinUpHoldSpinDown>(&drive))
    up_and_down->ramp = 0.0;
  else
    drive = ConstantSpeed{speed};
}

}  // namespace

const Drive& drive_of(const Scenario& scenario) {
  return scenario.space ? scenario.space->hub.drive : scenario.rotor.hub.drive;
}

StartFault find_start_fault(const Scenario& scenario) {
  const Initial& initial = scenario.initial;
  if (initial.state == InitialState::undeformed) {
    if (initial.speed) return {"speed", "would be ignored, expected only with an equilibrium"};
    return {};
  }
  StartFault fault = find_equilibrium_fault(scenario);
  if (!fault.key.empty()) fault.text += kStartUndeformed;
  return fault;
}

double start_speed(const Scenario& scenario) {
  assert(scenario.initial.state == InitialState::equilibrium);
  if (scenario.initial.speed) return *scenario.initial.speed;
  return speed_after_ramp(drive_of(scenario)).value_or(said_speed(scenario));
}

std::vector<double> start_speeds(const Scenario& scenario) {
  std::vector<double> speeds{start_speed(scenario)};
  if (scenario.space)
    for (const spatial::Rotor& rotor : scenario.space->rotors)
      speeds.push_back(
          speed_after_ramp(rotor.hub.drive).value_or(calc_initial_speed(rotor.hub.drive)));
  return speeds;
}

Scenario skip_start_up(const Scenario& scenario) {
  Scenario begun = scenario;
  if (scenario.initial.state == InitialState::undeformed) return begun;
  const std::vector<double> speeds = start_speeds(scenario);
  const double speed = speeds.front();
  if (!begun.space) {
    skip_all_ramps(begun.rotor);
    skip_ramps(begun.rotor.drags);
    begin_at(speed, begun.rotor.hub.drive);
    return begun;
  }
  spatial::Hub& hub = begun.space->hub;
  skip_all_ramps(*begun.space);
  if (is_free_in_space(scenario))
    hub.angular_velocity = speed * hub.axis.normalized();
  else
    begin_at(speed, hub.drive);
  for (std::size_t r = 0; r < begun.space->rotors.size(); ++r)
    begin_at(speeds[r + 1], begun.space->rotors[r].hub.drive);
  return begun;
}

}  // namespace spoke
