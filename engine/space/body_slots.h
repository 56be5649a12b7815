#pragma once

// The slots of a spatial body at a state and their momenta, of which all its inertia terms are sums
// (docs/formulation.md, section 10).

#include "engine/space/body_data.h"

namespace spoke::space {

/// Sums over all slots rho with mu = m rho and mu' = m rho'.
struct SlotSums {
  Position S = Position::Zero();       ///< first moment [kg m]
  Position S_rate = Position::Zero();  ///< [kg m/s]
  Matrix3 J = Matrix3::Zero();         ///< sum rho mu^T [kg m^2]
  Matrix3 G = Matrix3::Zero();         ///< sum rho mu'^T [kg m^2/s]

  /// tr(J) 1 - J: inertia about the origin.
  Matrix3 inertia() const { return J.trace() * Matrix3::Identity() - J; }
};

/// Sets the slots and momenta of `work` from coordinates and velocities by node.
SlotSums calc_slots(const FlexibleBody& body, const double* q, const double* v,
                    const BodyWork& work) noexcept;

/// Slots and momenta of an element's stretch stand behind those of the nodes.
inline std::size_t stretch_place(const FlexibleBody& body, int element) {
  return static_cast<std::size_t>(kNodeSlots * kSlot * body.node_count() + kSlot * element);
}

}  // namespace spoke::space
