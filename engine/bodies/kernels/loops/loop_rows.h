#pragma once

// The opening of a closure, row by row, from the motion of its two places: the constraints phi of a
// loop, their rates and their unit forces (docs/formulation.md, section 12). For plane and space
// alike, in vectors of space.

#include "models/system/loop_model.h"

namespace spoke {

/// Motion of the frame of a place. All is resolved in H.
struct PlaceMotion {
  space::Position p = space::Position::Zero();  ///< from the hub's origin [m]
  space::Rotation R;                            ///< from the place's frame to H
  space::Twist twist = space::Twist::Zero();    ///< against the inertial frame [m/s, rad/s]
};

/// One row.
struct RowMotion {
  /// Wrench of a unit force of the row on `from`, about its place; the opposite one acts on `to` at
  /// the same place.
  space::Twist unit;
  double opening;  ///< phi [m, rad]
  double rate;     ///< phi' [m/s, rad/s]
  /// phi'' where unit . (acceleration of `from`, less that which `to` has there) is zero
  /// [m/s^2, rad/s^2].
  double convective;
};

/// Calculates a row of a closure from the motion of its places.
RowMotion calc_loop_row(const LoopRow& row, const PlaceMotion& from,
                        const PlaceMotion& to) noexcept;

}  // namespace spoke
