#pragma once

// A box of wind: velocities on a grid across the wind, over time, which the mean wind carries past
// (Taylor's hypothesis of frozen turbulence).

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace spoke::air {

/// Velocities on a grid of n_y by n_z points at n_t times. Across the wind the grid is centred; its
/// axes are along the wind, across it to the left for who looks along the wind, and up.
struct WindBox {
  std::size_t n_y = 0, n_z = 0, n_t = 0;
  double dy = 0.0, dz = 0.0;  ///< spacing of the grid [m]
  double dt = 0.0;            ///< [s]
  double speed = 0.0;         ///< with which it passes [m/s]
  double bottom = 0.0;        ///< height of its lowest points [m]
  bool is_periodic = true;    ///< whether it repeats after n_t dt
  /// Time of the box that is at the origin at t = 0 [s]; not 0 where places ahead of the origin
  /// must find wind.
  double start = 0.0;
  /// Velocities along the wind, across it, up [m/s], by time, height, place across and component.
  std::vector<float> values;

  std::size_t index(std::size_t t, std::size_t z, std::size_t y) const {
    return 3 * ((t * n_z + z) * n_y + y);
  }
  /// Returns the half of its width [m].
  double half_width() const { return 0.5 * dy * static_cast<double>(n_y - 1); }
  /// Returns the time up to which it is known for places up to half its width ahead of the origin
  /// or behind [s]; none if it repeats.
  double end() const;
  /// Returns the box of one time that holds the means over time.
  WindBox average() const;
  /// Returns the velocity at a place along the wind, across it and at a height [m] at time t [s],
  /// linear between points and times. Outside of the grid, it is that of the border.
  Eigen::Vector3d velocity(double along, double across, double height, double t) const;
};

}  // namespace spoke::air
