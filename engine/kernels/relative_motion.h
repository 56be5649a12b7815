#pragma once

// Motion of the bodies and sections of a blade as the hub sees it: a function of the blade's
// deformation alone, with all derivatives exact.

#include "engine/table/step_data.h"

namespace spoke {

/// Place, velocity and acceleration relative to the hub, in the hub frame.
struct RelativeMotion {
  Position p = Position::Zero();  ///< [m]
  Position v = Position::Zero();  ///< [m/s]
  Position a = Position::Zero();  ///< [m/s^2]
  Rotation R;                     ///< to the hub frame
  double angle = 0.0;             ///< from the undeformed blade [rad]
  double speed = 0.0;             ///< [rad/s]
  double acceleration = 0.0;      ///< [rad/s^2]
};

/// The frame of body `body`. Poses of the table must be those of the state.
RelativeMotion calc_frame_motion(const Subsystem<Plane>& subsystem,
                                 const SubsystemData<Plane>& data, int body) noexcept;

/// A section of a body whose frame moves by `frame`.
RelativeMotion calc_section_motion(const RelativeMotion& frame, const BodyData<Plane>& body,
                                   const Section& section) noexcept;

/// What the sensors show of a section: bodies with geometric stiffening are foreshortened.
RelativeMotion calc_shown_motion(const Subsystem<Plane>& subsystem,
                                 const SubsystemData<Plane>& data, int body, double station,
                                 const Section& section) noexcept;

/// 1/2 int v'^2 dx from a body's inboard end to a station, and its derivatives.
struct Foreshortening {
  double length = 0.0;        ///< [m]
  double rate = 0.0;          ///< [m/s]
  double acceleration = 0.0;  ///< [m/s^2]
};
/// Precondition: the body has geometric stiffening; that of others is none.
Foreshortening calc_foreshortening(const BodyData<Plane>& body, double station) noexcept;

}  // namespace spoke
