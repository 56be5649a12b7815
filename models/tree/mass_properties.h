#pragma once

// Mass, first moment and inertia of bodies, and their sums.

#include "models/space/beam.h"
#include "models/spatial_model.h"

namespace spoke::spatial {

/// A position and orientation in another frame.
struct Placement {
  Vector position = Vector::Zero();      ///< of the origin [m]
  Tensor rotation = Tensor::Identity();  ///< takes components here to those of the other frame

  /// Of what is placed in this one.
  Placement operator*(const Placement& inner) const {
    return {position + rotation * inner.position, rotation * inner.rotation};
  }
};

/// What a body's mass does in rigid motion, about the origin of the frame it is given in.
struct MassProperties {
  double mass = 0.0;                     ///< [kg]
  Vector first_moment = Vector::Zero();  ///< [kg m]
  Tensor inertia = Tensor::Zero();       ///< about the origin [kg m^2]

  MassProperties& operator+=(const MassProperties& other);
  /// The same body seen from the frame in which it is placed.
  MassProperties seen_from_outside(const Placement& placement) const;
};

/// Of a body with this inertia about its centre of mass.
MassProperties make_mass_properties(double mass, const Vector& center, const Tensor& inertia);

/// Of the part of a beam between two stations, in the beam's frame; point masses at the outer one
/// belong to it, and at the root.
MassProperties calc_mass_properties(const space::Beam& beam, double from, double to);

}  // namespace spoke::spatial
