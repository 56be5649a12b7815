#pragma once

// Drives: prescribed motions of the hub and torques on it.

#include <string_view>
#include <variant>

#include "models/curve.h"
#include "spoke/export.h"

namespace spoke {

/// Smooth start to a constant speed (Wu & Haug 1988; (P 12), whose factor is Ts/(2 pi)):
/// phidot = speed/ramp (t - ramp/(2 pi) sin(2 pi t/ramp)) up to the end of the ramp, then speed.
struct SpinUp {
  double speed = 0.0;  ///< speed at the end of the ramp [rad/s]
  double ramp = 1.0;   ///< [s]
};

/// SpinUp, then constant speed, then the mirrored ramp down to rest.
struct SpinUpHoldSpinDown {
  double speed = 0.0;      ///< [rad/s]
  double ramp = 1.0;       ///< [s]
  double hold = 0.0;       ///< [s]
  double ramp_down = 1.0;  ///< [s]
};

/// The hub's speed is a given curve [rad/s].
struct SpeedTable {
  Curve speed;  ///< hub speed over time [rad/s]
};

/// The hub stands still.
struct FixedDrive {};

/// The hub turns at a constant speed from t = 0 on.
struct ConstantSpeed {
  double speed = 0.0;  ///< [rad/s]
};

/// A brake on what a drive turns, which an event has put on.
struct Brake {
  double torque = 0.0;  ///< [N m]
  double speed = 0.01;  ///< from which on it has that torque; less below [rad/s]
};

/// A torque acts on the hub [N m]; its rotation is an unknown of (P 9).
struct TorqueDrive {
  Curve torque;                ///< torque over time [N m]
  double initial_speed = 0.0;  ///< [rad/s]
  Brake brake{};               ///< besides
};

/// A torque that depends on the hub's speed acts on the hub: a motor or a generator. Its rotation
/// is an unknown of (P 9).
struct TorqueBySpeed {
  Curve torque;                ///< torque over the hub's speed [N m], rad/s in place of s
  double initial_speed = 0.0;  ///< [rad/s]
  /// Duration of the torque's smooth rise, calc_rise() [s]; 0: at once.
  double ramp = 0.0;
  Brake brake{};  ///< besides
};

/// Nothing acts on the hub's rotation.
struct FreeDrive {
  double initial_speed = 0.0;  ///< [rad/s]
};

/// The drive of a hub: one of the kinds above.
using Drive = std::variant<SpinUp, SpinUpHoldSpinDown, SpeedTable, TorqueDrive, FreeDrive,
                           FixedDrive, ConstantSpeed, TorqueBySpeed>;

/// A prescribed rotation of the hub at one time.
struct DriveMotion {
  double angle = 0.0;         ///< [rad]
  double speed = 0.0;         ///< [rad/s]
  double acceleration = 0.0;  ///< [rad/s^2]
};

/// Returns whether a drive turns the hub; a free one does that was turning at the start.
SPOKE_EXPORT bool turns_hub(const Drive& drive);

/// Returns whether the drive prescribes the hub's rotation (else the rotation is solved for).
SPOKE_EXPORT bool prescribes_motion(const Drive& drive);

/// Returns the prescribed rotation at time t [s]. Precondition: prescribes_motion(drive).
SPOKE_EXPORT DriveMotion calc_motion(const Drive& drive, double t);

/// Returns the torque [N m] of a brake at this speed [rad/s]: it goes smoothly through 0 at rest.
SPOKE_EXPORT double calc_torque(const Brake& brake, double speed);

/// Returns the torque [N m] that the drive applies at time t [s] to a hub of this speed [rad/s]; 0
/// for drives that prescribe the motion.
SPOKE_EXPORT double calc_torque(const Drive& drive, double t, double speed);

/// Returns the hub's speed at t = 0 [rad/s].
SPOKE_EXPORT double calc_initial_speed(const Drive& drive);

/// Returns the drive's kind as in scenario files: spin_up, spin_up_hold_spin_down, table, torque,
/// free, fixed, constant or torque_by_speed.
SPOKE_EXPORT std::string_view name_of(const Drive& drive);

}  // namespace spoke
