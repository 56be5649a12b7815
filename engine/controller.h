#pragma once

// Controllers of the program's own, and what is between a simulation and a controller that is not
// the scenario's: measurements and commands.

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "spoke/export.h"

namespace spoke {

/// What a controller is told of a blade or a subsystem on the hub.
struct ControlledBlade {
  double pitch = 0.0;       ///< angle of its pitch joints, `sign` and their own motion aside [rad]
  double pitch_rate = 0.0;  ///< [rad/s]
  double out_of_plane_moment = 0.0;  ///< at its root, that of forces along the axis [N m]
  double in_plane_moment = 0.0;      ///< that of forces in the sense of rotation [N m]
};

/// Measurements that a controller gets at a sample, of the state at the end of a step. Speeds,
/// angles and torques count in the sense in which the rotor turns, `direction` of the scenario; an
/// axis is along it.
struct ControlRecord {
  double time = 0.0;          ///< [s]
  double period = 0.0;        ///< to the next sample [s]
  bool is_first = true;       ///< whether it is the first sample of a simulation
  double speed = 0.0;         ///< of the hub about its axle, against what carries it [rad/s]
  double azimuth = 0.0;       ///< of the hub, from 0 to 2 pi [rad]
  double drive_speed = 0.0;   ///< of what the drive turns, on the hub's side of a gearbox [rad/s]
  double torque = 0.0;        ///< of the drive, likewise; a generator's is negative [N m]
  double shaft_torque = 0.0;  ///< the sensor hub.torque [N m]
  double wind_speed = 0.0;    ///< horizontal, where the hub was at the start [m/s]
  double yaw = 0.0;           ///< of the joint that yaws the support [rad]
  double yaw_error = 0.0;     ///< angle of the wind from the rotor's axis, about the vertical [rad]
  double fore_aft = 0.0;   ///< acceleration of the hub's origin along the axis, horizontal [m/s^2]
  double side_side = 0.0;  ///< across it, horizontal [m/s^2]
  std::vector<ControlledBlade> blades{};  ///< of the first rotor, in the order of the scenario
  std::span<const double> sensors{};      ///< as Simulation::sensor_values()
};

/// What a controller demands. It holds until the next sample.
struct ControlCommands {
  /// Of the drive, in place of the scenario's, on the hub's side of a gearbox, in the sense of
  /// rotation; a generator's is negative. It is reached evenly in the period that follows [N m].
  double torque = 0.0;
  std::vector<double> pitch{};  ///< of each blade, see ControlledBlade::pitch [rad]
  double yaw_rate = 0.0;        ///< [rad/s]
  double brake = 0.0;           ///< share of the brake's torque, from 0 to 1
};

/// A controller: the program gives one to a simulation of a scenario with [control.program]
/// (SimulationOptions::controller). It is called in samples, at t = 0 and then in each period, on
/// the thread that makes the steps, between two of them: whatever runs these, it is given the same
/// bits in the same order. An object serves one simulation.
class SPOKE_EXPORT Controller {
 public:
  virtual ~Controller() = default;
  /// Is told the names of the sensors, in the order of ControlRecord::sensors, before the first
  /// sample.
  virtual void begin(const std::vector<std::string>& /*sensors*/) {}
  /// Sets `commands`, which are those of the sample before; at the first one the torque of the
  /// scenario's drive and the pitch at the start. What it throws leaves the function that makes the
  /// steps, and the simulation stands at the step before. Commands that are not finite, or a brake
  /// beyond 0 to 1, throw DivergenceError there.
  virtual void control(const ControlRecord& record, ControlCommands& commands) = 0;

  /// Returns what it keeps from sample to sample, for Simulation::save() and checkpoints; none:
  /// simulations with it are not saved. One that keeps nothing returns an empty text.
  virtual std::optional<std::string> save() const { return std::nullopt; }
  /// Goes to what save() has returned, of this object or of another one made alike. Throws
  /// InputError if that is not its own.
  virtual void restore(const std::string& /*saved*/) {}
  /// Returns a copy for Simulation::clone(); null: simulations with it are not cloned.
  virtual std::shared_ptr<Controller> clone() const { return nullptr; }
};

}  // namespace spoke
