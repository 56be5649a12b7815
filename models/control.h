#pragma once

// Controllers of a rotor, as data: they read the hub's speed and move joints. What comes from
// outside the scenario, a library or an object of the program, has its place here, too.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "models/curve.h"
#include "models/turbine_control.h"
#include "spoke/export.h"

namespace spoke {

/// Collective pitch: a proportional-integral controller of the hub's speed with a gain schedule and
/// limits, sampled in time (docs/scenario.md, [control.pitch]). The pitch angle theta grows towards
/// feather; each joint stands at its own motion plus sign theta.
struct PitchControl {
  /// Names of the joints, of blades and of subsystems on the hub: revolute, of a motion that the
  /// scenario prescribes.
  std::vector<std::string> joints{};
  double speed = 0.0;         ///< set point; negative where the rotor turns so [rad/s]
  double proportional = 0.0;  ///< pitch angle by speed error [s]
  double integral = 0.0;      ///< pitch angle by integral of the speed error [rad/rad]
  /// Gains have the factor 1/(1 + theta/half_gain_angle) [rad].
  std::optional<double> half_gain_angle = std::nullopt;
  /// Gains have this factor, over theta in place of time [rad]. Not along with half_gain_angle.
  std::optional<Curve> schedule = std::nullopt;
  double minimum = 0.0;                       ///< of theta [rad]
  double maximum = 0.0;                       ///< of theta [rad]
  std::optional<double> rate = std::nullopt;  ///< largest rate of theta [rad/s]; none: no limit
  std::optional<double> filter =
      std::nullopt;      ///< corner frequency of the low-pass on speed [rad/s]
  double initial = 0.0;  ///< theta at t = 0 [rad]
  double sign = 1.0;     ///< joint angle by theta: 1 or -1
  /// Time between samples, in steps to the nearest whole number from 1 on [s]; none: a step.
  std::optional<double> period = std::nullopt;
};

/// A number of a library's array that a sensor of the simulation gives.
struct LibraryRecord {
  int number = 1;        ///< in the array, from 1
  std::string sensor{};  ///< its name
  double factor = 1.0;   ///< number by value of the sensor
};

/// The place of a controller that is not the scenario's own: an object of the program, or a library
/// of Bladed's kind (docs/scenario.md, [control.program] and [control.library]); or what events
/// move where there is no controller. [control.turbine] is the place of laws of the scenario, too.
/// It is called in samples, between steps, and sets the torque of the drive, the pitch of each
/// blade and the yaw. Of several rotors it is that of the first one.
struct OuterControl {
  /// Names of the joints that follow the demanded pitch, as PitchControl::joints; may be empty.
  std::vector<std::string> joints{};
  double initial = 0.0;  ///< pitch angle at t = 0 [rad]
  double sign = 1.0;     ///< joint angle by pitch angle: 1 or -1
  /// Name of a joint of the support that follows the demanded rate of yaw, likewise; may be empty.
  std::string yaw_joint{};
  /// Sense in which the rotor turns about its axis: 1 or -1. Speeds, angles and torques of a
  /// controller count along it.
  double direction = 1.0;
  double brake_torque = 0.0;  ///< of the brake that is on in full, on the hub's side [N m]
  double brake_speed = 0.01;  ///< from which on it has that torque [rad/s]
  /// Time between samples, in steps to the nearest whole number from 1 on [s]; none: a step.
  std::optional<double> period = std::nullopt;

  bool has_controller = true;                      ///< false: events alone move the joints
  std::optional<TurbineLaws> laws = std::nullopt;  ///< in place of a library and of an object

  // Of a library.
  std::string file{};   ///< the library; empty: an object of the program
  std::string input{};  ///< accINFILE, the file that it reads its parameters from; may be empty
  std::string name{};   ///< avcOUTNAME, with which names of files begin that it writes
  /// Turns of the generator for one of the hub; none: those of the drive train, or 1.
  std::optional<double> gear_ratio = std::nullopt;
  /// Whether it demands the pitch of each blade by itself, of at most three, else of all alike.
  bool individual_pitch = false;
  double efficiency = 1.0;               ///< electrical power by that of the generator's shaft
  std::vector<LibraryRecord> records{};  ///< that sensors give

  bool is_library() const { return !file.empty(); }
  /// Whether the torque of the drive is the controller's.
  bool sets_torque() const { return has_controller && (!laws || laws->torque); }
  /// Returns the table of a scenario that it stands in.
  std::string_view table() const {
    if (!has_controller || laws) return "control.turbine";
    return is_library() ? "control.library" : "control.program";
  }
};

/// Returns the factor of the gains at a pitch angle [rad].
SPOKE_EXPORT double calc_gain_factor(const PitchControl& control, double angle);

}  // namespace spoke
