#pragma once

// What is between the hub of a rotor on a support and its drive.

namespace spoke::spatial {

/// A shaft with torsion from the hub to a gearbox, and behind that a generator, which the drive
/// turns in place of the hub: its speeds and torques are what they are on the hub's side of the
/// gearbox. The carrier of the axle carries the housings of both.
struct DriveTrain {
  double stiffness = 0.0;          ///< of the shaft, on the hub's side [N m/rad], > 0
  double damping = 0.0;            ///< of the shaft, likewise [N m s/rad]
  double gear_ratio = 1.0;         ///< turns of the generator for one of the hub; not 0
  double generator_inertia = 0.0;  ///< about the axle [kg m^2], > 0; none of the carrier's
};

}  // namespace spoke::spatial
