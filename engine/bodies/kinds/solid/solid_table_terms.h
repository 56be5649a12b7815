#pragma once

// The table's data for the kernels of solids.

#include "engine/bodies/kinds/solid/solid_terms.h"
#include "engine/bodies/table/step_data.h"

namespace spoke {

/// Return the constants of a solid, and those that its kernels read. Precondition: the body is one.
const space::Solid& solid_of(const BodyData<Space>& body) noexcept;
space::SolidModel solid_model_of(const BodyData<Space>& body);

/// Adds all that is applied to solid `j`, loads of the user's, then those of the scenario, and the
/// tension of these and of the forces beyond the body. R_HB: only if a load is resolved in other
/// frames.
void add_applied_to_solid(double t, const space::Rotation& R_HB, std::size_t j,
                          SubsystemData<Space>& data) noexcept;

/// Returns by how much the stiffening moves the place of a section or of a handle, along the axes
/// of B, and its derivatives; zero where that is not known. `a` may be null.
space::PlaceDrawn calc_solid_drawn(const BodyData<Space>& body, int place_number, const double* q,
                                   const double* v, const double* a) noexcept;

/// Returns Lambda w0 of the stiffening, in H: the loss of angular momentum about the hub's origin.
/// Precondition: the solid is stiffened in its tree, or not at all.
space::Angular calc_solid_stiffening_momentum(const BodyData<Space>& body,
                                              const space::Angular& hub_w) noexcept;

/// Returns the momentum of a solid and its moment about B's origin, in B.
space::Twist calc_solid_momentum(const BodyData<Space>& body, const space::Twist& twist) noexcept;

}  // namespace spoke
