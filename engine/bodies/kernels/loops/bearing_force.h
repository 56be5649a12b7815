#pragma once

// The force of a bearing with full matrices (docs/formulation.md, section 12).

#include <Eigen/Core>

#include "engine/bodies/kernels/loops/loop_rows.h"
#include "models/system/bearing_model.h"

namespace spoke {

/// Returns the speed of `from` against `to` about the axis [rad/s].
double calc_bearing_speed(const BearingModel& bearing, const PlaceMotion& from,
                          const PlaceMotion& to) noexcept;

/// What a bearing does by its matrices, over its two rows.
struct BearingForce {
  Eigen::Vector2d force;  ///< -K phi - C phi' [N]
  /// The compliance of the rows in an implicit pass, symmetric and positive definite; zero in an
  /// explicit one [m/(N s^2)].
  Eigen::Matrix2d compliance;
  Eigen::Vector2d loss;  ///< by row, the power that no spring stores; its sum may be negative [W]
};

/// Calculates it from the openings phi [m], their rates phi' [m/s] and the speed of `from` against
/// `to` about the axis [rad/s]. The gains are those of ClosureGains: h^2 beta' [s^2], h gamma' [s].
BearingForce calc_bearing_force(const BearingModel& bearing, const Eigen::Vector2d& opening,
                                const Eigen::Vector2d& rate, double speed, double position_gain,
                                double velocity_gain) noexcept;

/// Returns the inverse of the symmetric part of G, made positive definite: its eigenvalues are
/// 1e-6 of the norm of G at least.
Eigen::Matrix2d calc_definite_inverse(const Eigen::Matrix2d& G) noexcept;

}  // namespace spoke
