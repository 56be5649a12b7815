#pragma once

// Mass, first moment and inertia of bodies, and their sums.

#include "models/space/beam.h"
#include "models/spatial_model.h"

namespace spoke::spatial {

/// A position and orientation in another frame.
struct Placement {
  Vector position = Vector::Zero();      ///< position of the origin [m]
  Tensor rotation = Tensor::Identity();  ///< takes components from this frame to the other one

  /// Returns the placement of an inner frame in the other frame.
  Placement operator*(const Placement& inner) const {
    return {position + rotation * inner.position, rotation * inner.rotation};
  }
};

/// Returns the placement of the other frame in the one that is placed.
inline Placement inverse(const Placement& placement) {
  const Tensor back = placement.rotation.transpose();
  return {-(back * placement.position), back};
}

/// The mass properties of a body in rigid motion, about the origin of its frame.
struct MassProperties {
  double mass = 0.0;                     ///< [kg]
  Vector first_moment = Vector::Zero();  ///< [kg m]
  Tensor inertia = Tensor::Zero();       ///< about the origin [kg m^2]

  MassProperties& operator+=(const MassProperties& other);
  /// Returns the properties seen from the frame in which the body is placed.
  MassProperties seen_from_outside(const Placement& placement) const;
};

/// Returns the properties of a body that has this inertia about its centre of mass.
MassProperties make_mass_properties(double mass, const Vector& center, const Tensor& inertia);

/// Returns the properties of a beam between two stations, in the beam's frame, with the point
/// masses between them, at the outer one, and at the root.
MassProperties calc_mass_properties(const space::Beam& beam, double from, double to);

}  // namespace spoke::spatial
