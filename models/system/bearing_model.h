#pragma once

// Bearings with full matrices: their coefficients at a speed.

#include <Eigen/Core>
#include <vector>

#include "models/loop.h"
#include "models/space/space.h"

namespace spoke {

/// Matrices of a bearing over its two rows: the force of these is -(stiffness) phi - (damping)
/// phi'.
struct BearingCoefficients {
  Eigen::Matrix2d stiffness = Eigen::Matrix2d::Zero();  ///< [N/m]
  Eigen::Matrix2d damping = Eigen::Matrix2d::Zero();    ///< [N s/m]
};

/// A bearing with matrices, which may depend on the speed of `from` against `to` about its axis.
struct BearingModel {
  space::Position axis = space::Position::Zero();  ///< unit vector in the frame of `to`
  std::vector<double> speeds;                      ///< ascending; empty: constant [rad/s]
  std::vector<BearingCoefficients> table;          ///< by speed, or one

  /// Returns the coefficients at a speed [rad/s]: linear in between, those of the ends beyond them.
  BearingCoefficients at(double speed) const;
  /// Returns the stiffness whose energy phi^T K phi/2 the bearing stores [N/m]: the symmetric part
  /// of a constant one. What depends on the speed has no energy of its own.
  Eigen::Matrix2d storing() const;
};

/// Makes a bearing of the matrices of a loop, whose rows are along `first` and `second`.
/// Precondition: check_model() accepts them.
BearingModel make_bearing(const BearingMatrices& matrices, const space::Position& first,
                          const space::Position& second);

}  // namespace spoke
