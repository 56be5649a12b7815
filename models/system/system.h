#pragma once

// What is simulated, as constant data: a hub and its subsystems (blades), each a chain of flexible
// bodies tied by bracket joints, the first tied to the hub.

#include <memory>
#include <vector>

#include "models/rotor.h"
#include "models/system/blade_loads.h"
#include "models/system/flexible_body.h"
#include "models/system/plane.h"

namespace spoke {

/// What rotation adds to the stiffness of a planar body; nothing unless the blade has geometric
/// stiffening.
struct PlanarStiffening {
  std::shared_ptr<const SymmetricBand<3>> centrifugal;  ///< KG of make_centrifugal_stiffness
  /// make_slope_integral, for the tip's displacement.
  std::shared_ptr<const SymmetricBand<3>> slope_integral;
  /// make_outboard_mass_stiffness: of a field that acts on all masses alike; none without.
  std::shared_ptr<const SymmetricBand<3>> outboard_mass;

  explicit operator bool() const { return centrifugal != nullptr; }
};

/// A body in its tree.
template <class World>
struct TreeBody {
  /// Index of the body that carries it, less than its own; -1: the hub.
  int parent = -1;
  /// At which handle of that body it hangs, from 1: 0 is the inboard one.
  int handle = 1;
  /// Indices of the bodies that it carries, by handle: one at each, from handle 1.
  std::vector<int> children;
  typename World::Joint joint;  ///< that carries it
  std::shared_ptr<const typename World::Body> body;
  typename World::Stiffening stiffening;
  std::vector<BodyLoad<World>> loads;
  std::vector<BodyDrag<World>> drags;
};

/// Trees of bodies on the hub, which parents lead; in the plane a chain, root to tip.
template <class World>
struct Subsystem {
  /// Pose of the root bracket in the hub frame; in space that of the first body's frame in the
  /// description (a beam's own axes), joint coordinates zero.
  PoseOf<World> root;
  double length = 0.0;  ///< undeformed, root to tip [m]
  /// In space the place of the undeformed tip, hub frame [m].
  PositionOf<World> tip = PositionOf<World>::Zero();
  std::vector<TreeBody<World>> bodies;
};

template <class World>
struct System {
  typename World::Hub hub;
  std::vector<typename World::HubLoad> hub_loads;
  std::vector<Subsystem<World>> subsystems;
  PositionOf<World> gravity = PositionOf<World>::Zero();  ///< inertial frame, at full size [m/s^2]
  double gravity_ramp = 0.0;                              ///< [s]
  Damping damping;

  /// In force at time t [s].
  PositionOf<World> gravity_at(double t) const { return gravity * calc_rise(t, gravity_ramp); }

  int body_count() const {
    int count = 0;
    for (const Subsystem<World>& s : subsystems) count += static_cast<int>(s.bodies.size());
    return count;
  }
  /// Deformation coordinates of all bodies together.
  int deformation_count() const {
    int count = 0;
    for (const Subsystem<World>& s : subsystems)
      for (const TreeBody<World>& member : s.bodies) count += member.body->coordinates();
    return count;
  }
};

/// Whether component `c` of the hub's twist (x, y, rotation) is prescribed.
bool is_prescribed(const Hub& hub, int c);

/// Hub frame to inertial frame, at an angle of the drive [rad].
inline Rotation rotation_of(const Hub&, double angle) { return Rotation::from_angle(angle); }
/// M_0 of the hub alone, hub frame.
inline TwistMatrix calc_hub_mass(const Hub& hub) {
  return Twist(hub.mass, hub.mass, hub.inertia).asDiagonal();
}
/// The forces of the hub's own inertia at zero acceleration; in the plane its mass centre is on its
/// axis, and there are none.
inline void add_gyroscopic_force(const Hub&, const Twist&, Twist&) {}
/// Of the hub alone, about its axis [kg m^2].
inline double axial_inertia(const Hub& hub) { return hub.inertia; }
/// The moment of a load besides that of its force [N m].
inline double moment_of(const HubLoad& load) { return load.torque; }

/// Builds the constants of a rotor; equal bodies share them.
System<Plane> make_system(const Rotor& rotor);

}  // namespace spoke
