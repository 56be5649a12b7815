#pragma once

// A joint of a tree in space, with its prescribed motions and efforts over time.

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "models/drive.h"
#include "models/space/joint.h"
#include "models/spatial_model.h"

namespace spoke::space {

/// The motion that the embedding program has set for a driven component, from a time on: value +
/// rate s + acceleration s^2/2, s = t - since.
struct SaidMotion {
  double since = 0.0;         ///< [s]
  double value = 0.0;         ///< [rad, m]
  double rate = 0.0;          ///< [rad/s, m/s]
  double acceleration = 0.0;  ///< [rad/s^2, m/s^2]
};

/// The motion of a driven component.
using DrivenMotion = std::variant<spatial::MotionTable, spatial::AzimuthMotion, SaidMotion>;

/// A spring in series with a damper on a coordinate: spatial::Relaxation.
struct RelaxingSpring {
  int coordinate = 0;
  double stiffness = 0.0;  ///< k [N m/rad, N/m]
  double time = 0.0;       ///< T [s]
};

/// The course of a joint's driven components and of the forces on its coordinates.
struct JointCourse {
  /// Drive of a rotor on a support, which turns the joint, an axle or that of a generator: its only
  /// component.
  std::optional<Drive> drive = std::nullopt;
  double drive_ratio = 1.0;          ///< turns of the joint for one of the drive
  std::vector<DrivenMotion> driven;  ///< motion by driven component
  std::vector<Curve> efforts;        ///< motor by coordinate [N m, N]; none: no motors
  /// What the embedding program adds to them, by coordinate [N m, N].
  std::array<double, Joint::kMost> added{};
  std::vector<RelaxingSpring> relaxing;  ///< at most one on a coordinate
  double azimuth = 0.0;                  ///< added to the hub's angle for AzimuthMotion [rad]
  /// Index in Subsystem::controls of the controller whose angle is added to the first driven
  /// component's motion; -1: none.
  int control = -1;
  std::vector<double> initial;        ///< coordinates at t = 0 [rad, m]
  std::vector<double> initial_speed;  ///< [rad/s, m/s]
  /// Its name, for messages, if closing loops at the start leaves its coordinates and their rates
  /// as they are; else empty.
  std::string held;
};

/// A coordinate that slides along bodies which carry the joint. The child does not follow where
/// bending draws them inward, but slides: along them they feel the force on the coordinate alone.
struct JointSlide {
  int coordinate = 0;
  /// Direction of sliding in H, undeformed and with joint coordinates zero.
  Position axis = Position::UnitX();
};

/// A joint of a tree.
struct TreeJoint {
  Joint joint;
  JointCourse course;
  std::optional<JointSlide> slide;  ///< the slide, if the joint has such a coordinate
};

}  // namespace spoke::space
