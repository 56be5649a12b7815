#pragma once

// Any rotor on a hub that moves, seen from outside: matrices that depend on the azimuth.

#include <vector>

#include "engine/small_motions/steady/linear_model.h"
#include "engine/small_motions/vibration/standing_axes.h"

namespace spoke::vibration {

/// A matrix that is a trigonometric polynomial in the azimuth psi of the hub.
struct Periodic {
  /// Factors of 1, cos psi, sin psi, cos 2 psi, sin 2 psi, ...
  std::vector<Eigen::MatrixXd> parts;

  Eigen::MatrixXd at(double psi) const;
};

/// Returns a square matrix of this degree that is zero.
Periodic make_zero_periodic(Eigen::Index size, Eigen::Index degree);

/// Small motions M(psi) x'' + C(psi) x' + K(psi) x = 0 with psi = speed t. Coordinates x are those
/// of the hub along standing axes, then those of each subsystem, which turns with the hub.
struct PeriodicSystem {
  Periodic M, C, K;
  double speed = 0.0;                ///< [rad/s]
  Eigen::Index hub = 0;              ///< number of the hub's coordinates
  std::vector<Eigen::Index> starts;  ///< first coordinate of each subsystem
  /// For each subsystem the first one that has its matrices where it passes the same place, and the
  /// azimuths of all; empty: not known.
  std::vector<std::size_t> alike = {};
  std::vector<double> azimuths = {};

  Eigen::Index size() const { return M.parts[0].rows(); }
};

/// Takes a rotor, linearised in the frame that turns with its hub, to standing axes at the hub.
/// This is exact: turning the hub's coordinates and its equations is of first degree each.
PeriodicSystem make_periodic(const steady::LinearModel& turning, const StandingAxes& axes);

/// Takes matrices that were found at 2 n + 1 equal parts of a turn, from azimuth zero on, to a
/// polynomial of degree n.
Periodic interpolate(const std::vector<Eigen::MatrixXd>& values);

/// Puts a rotor on something that moves the hub by x = J z and has matrices of its own, as
/// stand_on() of multi-blade coordinates does.
PeriodicSystem stand_on(const PeriodicSystem& rotor, const Eigen::MatrixXd& J,
                        const SecondOrder& support);

}  // namespace spoke::vibration
