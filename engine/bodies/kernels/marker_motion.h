#pragma once

// Motion and forces at a marker, a point anywhere on a subsystem.

#include <span>

#include "engine/bodies/table/step_data.h"
#include "engine/load.h"

namespace spoke {

/// Returns the pose of a body's frame in the hub frame, from the rotations and deformations of the
/// table.
plane::Pose calc_pose_in_hub(const Subsystem<Plane>& subsystem, const SubsystemData<Plane>& data,
                             int body) noexcept;

/// Returns the motion of a marker at the state in the table, whose rotations and twists must be
/// those of the state. On a body with geometric stiffening its place is that of the coordinates,
/// without foreshortening.
MarkerMotion calc_marker_motion(const Subsystem<Plane>& subsystem, const SubsystemData<Plane>& data,
                                const PlacedMarker<Plane>& marker) noexcept;

/// Returns the motion of the place at which a load does its work there: bodies with geometric
/// stiffening are drawn inward along the axes of the undeformed subsystem (docs/formulation.md,
/// section 2).
MarkerMotion calc_load_motion(const Subsystem<Plane>& subsystem, const SubsystemData<Plane>& data,
                              const PlacedMarker<Plane>& marker) noexcept;

/// Returns the accelerations of a marker's section in the inertial frame, from the accelerations of
/// the body that an evaluation at the state has left in the table, and the gravity in force there:
/// x, y [m/s^2], rotation [rad/s^2].
Twist calc_marker_acceleration(const Position& gravity, const SubsystemData<Plane>& data,
                               const PlacedMarker<Plane>& marker) noexcept;

/// Returns the foreshortening by which bending brings a marker closer to the root, summed over the
/// bodies with geometric stiffening, as the tip's sensors have it; hub frame [m].
Position calc_marker_foreshortening(const Subsystem<Plane>& subsystem,
                                    const SubsystemData<Plane>& data, int body, double station);

/// Returns the wrench of the part outboard of a section on the part inboard: axial force and shear
/// [N], bending moment [N m], in the section's frame, by the element's strains, damping included.
/// `modal`: see calc_modal_deformation(); null if there is none.
Twist calc_section_force(const Blade& blade, const Damping& damping, const double* modal,
                         const BodyData<Plane>& body, const plane::Section& section) noexcept;

// The same functions for spatial subsystems, where the hub's frame H has z along its axis.

space::Pose calc_pose_in_hub(const Subsystem<Space>& subsystem, const SubsystemData<Space>& data,
                             int body) noexcept;
MarkerMotion calc_marker_motion(const Subsystem<Space>& subsystem, const SubsystemData<Space>& data,
                                const PlacedMarker<Space>& marker) noexcept;
MarkerMotion calc_load_motion(const Subsystem<Space>& subsystem, const SubsystemData<Space>& data,
                              const PlacedMarker<Space>& marker) noexcept;
/// Those of several markers; what is inboard of a body is found once for those of it in a row.
/// sections: motion of each marker's section against the frame of its body, as motion_at() has it.
void calc_load_motions(const Subsystem<Space>& subsystem, const SubsystemData<Space>& data,
                       std::span<const PlacedMarker<Space>> markers,
                       std::span<MarkerMotion> motions,
                       std::span<space::HandleMotion> sections) noexcept;
/// Linear and angular acceleration [m/s^2, rad/s^2].
space::Twist calc_marker_acceleration(const space::Position& gravity,
                                      const Subsystem<Space>& subsystem,
                                      const SubsystemData<Space>& data,
                                      const PlacedMarker<Space>& marker) noexcept;
/// Returns the pose of a body's frame in H, undeformed and with all joint coordinates zero.
space::Pose calc_rest_pose(const Subsystem<Space>& subsystem, int body) noexcept;

space::Position calc_marker_foreshortening(const Subsystem<Space>& subsystem,
                                           const SubsystemData<Space>& data,
                                           const PlacedMarker<Space>& marker) noexcept;

/// Embed a planar vector and a planar rotation in space.
inline Eigen::Vector3d in_space(const Position& p) { return {p.x(), p.y(), 0.0}; }
Eigen::Matrix3d in_space(const plane::Rotation& R);

}  // namespace spoke
