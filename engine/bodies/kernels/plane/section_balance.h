#pragma once

// Forces in a subsystem by the balance of its outboard part, and its momentum: integrals over the
// field of displacements, velocities and accelerations.

#include <span>
#include <vector>

#include "engine/bodies/kernels/plane/relative_motion.h"
#include "engine/bodies/table/step_data.h"

namespace spoke::plane {

/// Returns the mass of a body outboard of `from` [m], for the sums below: in each element, or part
/// of one, Gauss's rule of four points, then the point masses, also those at `from`.
std::vector<MassPoint> make_mass_points(const FlexibleBody& body, const FlexLayout& layout,
                                        double from);

/// Returns the load of the part outboard of a section on the part inboard: force [N] and moment
/// about the section [N m], in the frame of the section's body. The balance of the body's own part
/// outboard, s from the section on, is
///   N = f + (applied forces) - int rhoA a ds,     a less gravity,
/// with f the force of the next joint on the body; moments likewise, about the deformed section.
/// Loads at the section count as outboard. Poses and twists of the table must be those of the
/// state, joint_loads those of its step; t: its time [s]; outboard: the body's mass from the
/// section on.
Twist calc_section_load(const System<Plane>& system, std::size_t i, const StepData<Plane>& data,
                        double t, int body, const Section& section,
                        std::span<const MassPoint> outboard) noexcept;

/// Returns linear momentum [kg m/s] and angular momentum about the inertial origin [kg m^2/s] of a
/// subsystem, with the term -w0 qf^T KG qf of geometric stiffening; inertial frame. Poses and
/// twists of the table must be those of the state; masses: of each body.
Twist calc_momentum(const SubsystemData<Plane>& data, std::span<const MassPoints> masses) noexcept;

/// Returns the hub's acceleration that subsystem `i` follows at the state at time `t` [s]: hub
/// frame, less gravity.
Twist calc_hub_acceleration(const System<Plane>& system, std::size_t i, const StepData<Plane>& data,
                            double t) noexcept;

}  // namespace spoke::plane
