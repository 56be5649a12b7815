#pragma once

// Weights of the tension matrices of a body: the tension by the hub's rotation and gravity.

#include "engine/bodies/space/body_data.h"

namespace spoke::space {

/// Weight of each matrix at a speed of the hub.
struct TensionWeights {
  std::array<double, ElementStiffening::kWeights> tension{};
  Position w = Position::Zero();  ///< the hub's angular velocity, in B [rad/s]
  double gravity = 0.0;           ///< along the body [m/s^2]
};

/// Returns the x component of W0 c, with W0 = |w|^2 1 - w w^T.
inline double along_x(const Position& w, const Position& c) {
  return w.squaredNorm() * c.x() - w.x() * w.dot(c);
}

/// Returns the weights of an element's own body; those of the masses that elements carry are to be
/// added.
inline TensionWeights calc_tension_weights(const TensionPlace& place, const BodyMotion& motion) {
  const Position w = place.R_HB.inverse() * motion.hub_w;
  const double gravity = (place.R_HB.inverse() * motion.gravity).x();
  return {{0.0, along_x(w, place.origin) + gravity, along_x(w, Position::UnitX())}, w, gravity};
}

/// Returns the tension of the masses that an element carries, at a speed of the hub.
inline double carried_tension(const CarriedMass& carried, const TensionWeights& weights) {
  return along_x(weights.w, carried.moment) + weights.gravity * carried.mass;
}

}  // namespace spoke::space
