#pragma once

// The tension in a planar body besides that of rotation: of applied forces, and of a field that
// acts on all masses alike, as gravity does (docs/formulation.md, section 2).
//
// A section at x has come nearer to the body frame by r(x) = 1/2 int_0^x v'^2 dx along the axis of
// the undeformed blade, and so have the forces there and beyond. A force (N_x, N_y) along and
// across that axis does the work
//   -N_x int_0^x N_v'^T N_v' dx qf on the deformation, and -N_y r(x) on the hub's rotation.

#include "engine/table/step_data.h"

namespace spoke {

/// The field that the masses of a subsystem feel, hub frame [m/s^2]: on an axle gravity; where the
/// hub flies, which gravity accelerates like all masses, what the applied forces leave them behind
/// by.
Position calc_tension_field(const System<Plane>& system, double t,
                            const SubsystemData<Plane>& data) noexcept;

/// Adds the tension of the forces that are applied at and beyond sections of body `j`, and its
/// power, at time `t` [s]. R_HB: of the undeformed blade's axes.
void add_applied_tension(double t, const Rotation& R_HB, int j,
                         SubsystemData<Plane>& data) noexcept;

/// Adds the tension of a field, along and across the undeformed blade [m/s^2]. Returns its power
/// [W] at a speed of the hub [rad/s]. Precondition: the body's stiffening has an outboard_mass.
double add_field_tension(const Position& field, double hub_speed, BodyData<Plane>& body) noexcept;

/// The first moment that foreshortening takes off a body and what it carries, along the undeformed
/// blade [kg m]: 1/2 int m(x) v'^2 dx, m the mass beyond x. Precondition: as above.
double calc_foreshortened_moment(const BodyData<Plane>& body) noexcept;

}  // namespace spoke
