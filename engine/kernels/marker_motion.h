#pragma once

// Motion and forces at a marker, a point anywhere on a blade.

#include "engine/table/step_data.h"

namespace spoke {

/// Pose of a body's frame in the hub frame, from the rotations and deformations of the table.
Pose calc_pose_in_hub(const Subsystem<Plane>& subsystem, const SubsystemData<Plane>& data,
                      int body) noexcept;

/// The motion of a marker at the state in the table, whose rotations and twists must be those of
/// the state. Of a body with geometric stiffening the place is that of its coordinates, without
/// foreshortening.
MarkerMotion calc_marker_motion(const Subsystem<Plane>& subsystem, const SubsystemData<Plane>& data,
                                const PlacedMarker<Plane>& marker) noexcept;

/// The motion of the place at which a load does its work there: bodies with geometric stiffening
/// are drawn inward along the axes of the undeformed tree (docs/formulation.md, section 2).
MarkerMotion calc_load_motion(const Subsystem<Plane>& subsystem, const SubsystemData<Plane>& data,
                              const PlacedMarker<Plane>& marker) noexcept;

/// Accelerations of a marker's section in the inertial frame, from the accelerations of the body
/// that an evaluation at the state has left in the table, and the gravity in force there: x, y
/// [m/s^2], rotation [rad/s^2].
Twist calc_marker_acceleration(const Position& gravity, const SubsystemData<Plane>& data,
                               const PlacedMarker<Plane>& marker) noexcept;

/// What bending takes off a marker's distance from the root, along each body with geometric
/// stiffening, as the tip's sensors have it; hub frame [m].
Position calc_marker_foreshortening(const Subsystem<Plane>& subsystem,
                                    const SubsystemData<Plane>& data, int body, double station);

/// What the part outboard of a section does to the part inboard: axial force and shear [N], bending
/// moment [N m], in the section's frame, by the element's strains. With the damping's share.
Twist calc_section_force(const Blade& blade, const Damping& damping, const BodyData<Plane>& body,
                         const Section& section) noexcept;

// The same in space, where the hub's frame H has z along its axis.

space::Pose calc_pose_in_hub(const Subsystem<Space>& subsystem, const SubsystemData<Space>& data,
                             int body) noexcept;
MarkerMotion calc_marker_motion(const Subsystem<Space>& subsystem, const SubsystemData<Space>& data,
                                const PlacedMarker<Space>& marker) noexcept;
MarkerMotion calc_load_motion(const Subsystem<Space>& subsystem, const SubsystemData<Space>& data,
                              const PlacedMarker<Space>& marker) noexcept;
/// Linear and angular [m/s^2, rad/s^2].
space::Twist calc_marker_acceleration(const space::Position& gravity,
                                      const Subsystem<Space>& subsystem,
                                      const SubsystemData<Space>& data,
                                      const PlacedMarker<Space>& marker) noexcept;
/// Pose of a body's frame in H, undeformed and with all joint coordinates zero.
space::Pose calc_rest_pose(const Subsystem<Space>& subsystem, int body) noexcept;

space::Position calc_marker_foreshortening(const Subsystem<Space>& subsystem,
                                           const SubsystemData<Space>& data,
                                           const PlacedMarker<Space>& marker) noexcept;

/// A planar vector and rotation in space.
inline Eigen::Vector3d in_space(const Position& p) { return {p.x(), p.y(), 0.0}; }
Eigen::Matrix3d in_space(const Rotation& R);

}  // namespace spoke
