#pragma once

// Motion of the bodies and sections of a subsystem as the hub sees it: a function of the
// subsystem's deformation alone, with all derivatives exact.

#include "engine/bodies/kernels/plane/handle_motion.h"
#include "engine/bodies/table/step_data.h"

namespace spoke::plane {

/// Place, velocity and acceleration relative to the hub, in the hub frame.
struct RelativeMotion {
  Position p = Position::Zero();  ///< [m]
  Position v = Position::Zero();  ///< [m/s]
  Position a = Position::Zero();  ///< [m/s^2]
  Rotation R;                     ///< from the frame or section to the hub frame
  double angle = 0.0;             ///< from the undeformed subsystem [rad]
  double speed = 0.0;             ///< [rad/s]
  double acceleration = 0.0;      ///< [rad/s^2]
};

/// Returns the motion of the frame of body `body`. Poses of the table must be those of the state.
RelativeMotion calc_frame_motion(const Subsystem<Plane>& subsystem,
                                 const SubsystemData<Plane>& data, int body) noexcept;

/// Returns the motion of a section of a body whose frame moves by `frame`.
RelativeMotion calc_section_motion(const RelativeMotion& frame, const BodyData<Plane>& body,
                                   const Section& section) noexcept;

/// Returns the motion of a section as sensors show it: bodies with geometric stiffening are
/// foreshortened.
RelativeMotion calc_shown_motion(const Subsystem<Plane>& subsystem,
                                 const SubsystemData<Plane>& data, int body, double station,
                                 const Section& section) noexcept;

/// 1/2 int v'^2 dx from a body's inboard end to a station, and its derivatives.
struct Foreshortening {
  double length = 0.0;        ///< [m]
  double rate = 0.0;          ///< [m/s]
  double acceleration = 0.0;  ///< [m/s^2]
};
/// Calculates it. Precondition: the body has geometric stiffening; other bodies have no
/// foreshortening.
Foreshortening calc_foreshortening(const BodyData<Plane>& body, double station) noexcept;

}  // namespace spoke::plane
