#pragma once

// Forces in a blade by the balance of what is outboard, and its momentum: integrals over the field
// of displacements, velocities and accelerations.

#include <span>
#include <vector>

#include "engine/kernels/relative_motion.h"
#include "engine/table/step_data.h"

namespace spoke {

/// What blade `i` hands to the hub, and what each joint does to the body outboard of it, in the
/// evaluation that the table holds: to data.root_load and data.joint_loads.
///   root_load = -(F, M) of the first joint + (0, qf^T KG qf alpha0 + 2 w0 qf^T KG qf' + M_T),
/// in the blade's axes; the last term is that of geometric stiffening on the hub's rotation, M_T
/// that of the tension by applied forces and fields, summed over the bodies.
void keep_joint_loads(const Subsystem<Plane>& subsystem, SubsystemData<Plane>& data) noexcept;

/// The mass of a body outboard of `from` [m], for the sums below: in each element, or part of one,
/// Gauss's rule of four points, then the point masses, also those at `from`.
std::vector<MassPoint> make_mass_points(const FlexibleBody& body, const FlexLayout& layout,
                                        double from);

/// What the blade outboard of a section does to the blade inboard: force [N] and moment about the
/// section [N m], in the frame of the section's body. Of the body's own part outboard, s from the
/// section on,
///   N = f + (applied forces) - int rhoA a ds,     a less gravity,
/// f what the next joint does to the body; moments likewise, about the deformed section. Loads at
/// the section count as outboard. Poses and twists of the table must be those of the state,
/// joint_loads those of its step; t: its time [s]; outboard: the body's mass from the section on.
Twist calc_section_load(const System<Plane>& system, std::size_t i, const StepData<Plane>& data,
                        double t, int body, const Section& section,
                        std::span<const MassPoint> outboard) noexcept;

/// Linear momentum [kg m/s] and angular momentum about the inertial origin [kg m^2/s] of a blade,
/// with the term -w0 qf^T KG qf of geometric stiffening; inertial frame. Poses and twists of the
/// table must be those of the state; masses: of each body.
Twist calc_momentum(const SubsystemData<Plane>& data, std::span<const MassPoints> masses) noexcept;

/// The hub's acceleration that blade `i` follows at the state at time `t` [s]: hub frame, less
/// gravity.
Twist calc_hub_acceleration(const System<Plane>& system, std::size_t i, const StepData<Plane>& data,
                            double t) noexcept;

}  // namespace spoke
