#pragma once

// The tension in a planar body besides that of rotation: that of applied forces, and of a field
// that acts on all masses alike, as gravity does (docs/formulation.md, section 2).
//
// A section at x has come nearer to the body frame by r(x) = 1/2 int_0^x v'^2 dx along the axis of
// the undeformed subsystem, and so have the forces there and beyond. A force (N_x, N_y) along and
// across that axis does the work
//   -N_x int_0^x N_v'^T N_v' dx qf on the deformation, and -N_y r(x) on the hub's rotation.

#include "engine/bodies/table/step_data.h"

namespace spoke::plane {

/// Returns the field that the masses of a subsystem feel, hub frame [m/s^2]: on an axle gravity;
/// where the hub flies, which gravity accelerates like all masses, the opposite of the acceleration
/// by the applied forces.
Position calc_tension_field(const System<Plane>& system, double t,
                            const SubsystemData<Plane>& data) noexcept;

/// Collects the forces that are applied to a body and beyond it, and adds their tension.
/// Precondition: the body has geometric stiffening, and forces are applied to it or beyond it.
class AppliedTension {
 public:
  /// `turn`: from the body frame to the axes of the undeformed subsystem.
  AppliedTension(const Rotation& turn, BodyData<Plane>& body) noexcept;

  /// Adds the forces on the bodies that follow [N], along the axes of the undeformed subsystem.
  void add_beyond(const Position& force) noexcept { body_.element_forces.back() += force; }
  /// Adds a force [N] at a section, body frame.
  void add_at(const Section& section, const Position& force) noexcept;
  /// Adds, when all forces are known, the moment on the hub, which turns at `hub_speed` [rad/s],
  /// and the power of the tension.
  void finish(double hub_speed) noexcept;

 private:
  void add_stretch(int element, double s, const Position& force) noexcept;

  BodyData<Plane>& body_;
  Rotation turn_;
  double moment_ = 0.0;  ///< moment on the hub [N m]
  double power_ = 0.0;   ///< power on the deformation [W]
};

/// Adds the tension of a field, along and across the undeformed subsystem [m/s^2]. Returns its
/// power [W] at a speed of the hub [rad/s]. Precondition: the body's stiffening has an
/// outboard_mass.
double add_field_tension(const Position& field, double hub_speed, BodyData<Plane>& body) noexcept;

/// Returns the loss of first moment by foreshortening, of a body and all that it carries, along the
/// undeformed subsystem [kg m]: 1/2 int m(x) v'^2 dx, m the mass beyond x. Precondition: as above.
double calc_foreshortened_moment(const BodyData<Plane>& body) noexcept;

}  // namespace spoke::plane
