#pragma once

// What is simulated, as constant data: a hub and its subsystems (blades), each a chain of flexible
// bodies tied by bracket joints, the first tied to the hub.

#include <memory>
#include <vector>

#include "models/rotor.h"
#include "models/system/flexible_body.h"
#include "models/system/space.h"

namespace spoke {

/// A point of a body at which a load acts, by the shape functions there.
struct LoadPoint {
  int element = 0;      ///< of the body
  double s = 0.0;       ///< within the element, 0 at its inboard end, 1 at the outboard end
  double x = 0.0;       ///< undeformed place in the body frame [m]
  double weight = 1.0;  ///< of a point load 1, else the length that the point stands for [m]
};

/// A load's factor over time.
struct LoadCourse {
  Curve factor;
  double ramp = 0.0;  ///< [s]

  double value(double t) const { return factor.value(t) * calc_rise(t, ramp); }
};

/// A force and a moment on one body, as they act at each of its points, times weight and course.
struct BodyLoad {
  std::vector<LoadPoint> points;
  LoadFrame frame = LoadFrame::hub;
  Position force = Position::Zero();  ///< [N], or [N/m]
  double moment = 0.0;                ///< [N m], or [N]
  std::shared_ptr<const LoadCourse> course;
};

/// Drag on one body, as it acts at each of its points, times weight and course.
struct BodyDrag {
  std::vector<LoadPoint> points;
  DragFrame relative_to = DragFrame::inertial;
  double linear = 0.0;     ///< [N s/m], or [N s/m^2]
  double quadratic = 0.0;  ///< [N s^2/m^2], or [N s^2/m^3]
  std::shared_ptr<const LoadCourse> course;
};

/// A body in its chain.
struct ChainBody {
  std::shared_ptr<const FlexibleBody> body;
  /// KG of make_centrifugal_stiffness; null if the blade has no geometric stiffening.
  std::shared_ptr<const SymmetricBand<3>> centrifugal_stiffness;
  /// make_slope_integral, for the tip's displacement; null likewise.
  std::shared_ptr<const SymmetricBand<3>> slope_integral;
  std::vector<BodyLoad> loads;
  std::vector<BodyDrag> drags;
};

/// A chain of bodies, root to tip.
struct Subsystem {
  Pose root;            ///< pose of the root bracket in the hub frame
  double length = 0.0;  ///< undeformed, root to tip [m]
  std::vector<ChainBody> bodies;
};

struct System {
  Hub hub;
  std::vector<HubLoad> hub_loads;
  std::vector<Subsystem> subsystems;
  Position gravity = Position::Zero();  ///< inertial frame, at full size [m/s^2]
  double gravity_ramp = 0.0;            ///< [s]
  Damping damping;

  /// In force at time t [s].
  Position gravity_at(double t) const { return gravity * calc_rise(t, gravity_ramp); }

  int body_count() const;
  /// Deformation coordinates of all bodies together.
  int deformation_count() const;
};

/// Whether component `c` of the hub's twist (x, y, rotation) is prescribed.
bool is_prescribed(const Hub& hub, int c);

/// Builds the constants of a rotor; equal bodies share them.
System make_system(const Rotor& rotor);

}  // namespace spoke
