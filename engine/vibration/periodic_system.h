#pragma once

// Any rotor on a hub that moves, seen from outside: matrices that depend on the azimuth.

#include <array>
#include <vector>

#include "engine/steady/linear_model.h"
#include "engine/vibration/standing_axes.h"

namespace spoke::vibration {

/// A matrix of second degree in the azimuth psi of the hub.
struct Periodic {
  /// Factors of 1, cos psi, sin psi, cos 2 psi, sin 2 psi.
  std::array<Eigen::MatrixXd, 5> parts;

  Eigen::MatrixXd at(double psi) const;
};

/// Small motions M(psi) x'' + C(psi) x' + K(psi) x = 0 with psi = speed t. Coordinates x are those
/// of the hub along standing axes, then those of each subsystem, which turns with the hub.
struct PeriodicSystem {
  Periodic M, C, K;
  double speed = 0.0;                ///< [rad/s]
  Eigen::Index hub = 0;              ///< number of the hub's coordinates
  std::vector<Eigen::Index> starts;  ///< first coordinate of each subsystem

  Eigen::Index size() const { return M.parts[0].rows(); }
};

/// Takes a rotor, linearised in the frame that turns with its hub, to standing axes at the hub.
/// This is exact: turning the hub's coordinates and its equations is of first degree each.
PeriodicSystem make_periodic(const steady::LinearModel& turning, const StandingAxes& axes);

/// Puts a rotor on something that moves the hub by x = J z and has matrices of its own, as
/// stand_on() of multi-blade coordinates does.
PeriodicSystem stand_on(const PeriodicSystem& rotor, const Eigen::MatrixXd& J,
                        const SecondOrder& support);

}  // namespace spoke::vibration
