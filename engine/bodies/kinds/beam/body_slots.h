#pragma once

// The slots of a spatial body at a state and their momenta, of which all its inertia terms are sums
// (docs/formulation.md, section 10).

#include <cassert>

#include "engine/bodies/space/body_scratch.h"

namespace spoke::space {

/// Sums over all slots rho with mu = m rho and mu' = m rho'.
struct SlotSums {
  Position S = Position::Zero();       ///< first moment [kg m]
  Position S_rate = Position::Zero();  ///< [kg m/s]
  Matrix3 J = Matrix3::Zero();         ///< sum rho mu^T [kg m^2]
  Matrix3 G = Matrix3::Zero();         ///< sum rho mu'^T [kg m^2/s]

  /// Returns tr(J) 1 - J, the inertia about the origin.
  Matrix3 inertia() const { return J.trace() * Matrix3::Identity() - J; }
};

/// Sets the slots rho and momenta mu = m rho, with their rates, from coordinates and velocities by
/// node. Returns their sums.
SlotSums calc_slots(const FlexibleBody& body, const double* q, const double* v,
                    const BodyScratch& scratch) noexcept;

/// Returns the place of an element's stretch: its slots and momenta stand behind those of the
/// nodes.
inline std::size_t stretch_place(const FlexibleBody& body, int element) {
  assert(element >= 0 && element < body.elements);
  return static_cast<std::size_t>(kNodeSlots * kSlot * body.node_count() + kSlot * element);
}

}  // namespace spoke::space
