#pragma once

// The handles of a spatial body at a state: the ends of its deformation to which joints are fixed.

#include "models/space/flexible_body.h"
#include "models/space/rotation_vector.h"

namespace spoke::space {

/// The section at a handle's node: its orientation in B is exp(th~). Its acceleration is
/// J (X; q'') + b with J = [1, -s~, E_u; 0, 1, H E_th].
struct HandleMotion {
  Position s = Position::Zero();         ///< place in B [m]
  Position velocity = Position::Zero();  ///< relative to B [m/s]
  RotationVectorMotion turn;             ///< rotation of the section against B

  /// Returns the section's twist relative to B, in B: [u'; H th'].
  Twist twist() const { return make_twist(velocity, turn.velocity); }
  /// Returns the section's acceleration, in B, where that of B is X and all else at rest: [1, -s~;
  /// 0, 1] X.
  Twist carry(const Twist& X) const { return refer(-s, X); }
  /// Returns b, the acceleration at X = 0 and q'' = 0, at the angular velocity w of B: [w x (w x s)
  /// + 2 w x u'; w x (H th') + H' th'].
  Twist bias(const Angular& w) const;
};

/// Makes a handle at a place that is fixed in B.
HandleMotion make_fixed_handle(const Position& s) noexcept;

/// Calculates the handles of a body at the flex vectors q and v.
void calc_handles(const FlexibleBody& body, const double* q, const double* v,
                  HandleMotion* handles) noexcept;

}  // namespace spoke::space
