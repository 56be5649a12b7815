#pragma once

// A joint of a tree in space, with what moves and loads it over time.

#include <vector>

#include "models/space/joint.h"
#include "models/spatial_model.h"

namespace spoke::space {

/// The course of a joint's driven components and of the forces on its coordinates.
struct JointCourse {
  std::vector<spatial::Motion> driven;  ///< by driven component
  std::vector<Curve> efforts;           ///< by coordinate: motors [N m, N]; none: no motors
  double azimuth = 0.0;                 ///< added to the hub's angle for AzimuthMotion [rad]
  std::vector<double> initial;          ///< coordinates at t = 0 [rad, m]
  std::vector<double> initial_speed;    ///< [rad/s, m/s]
};

/// A joint of a tree.
struct TreeJoint {
  Joint joint;
  JointCourse course;
};

}  // namespace spoke::space
