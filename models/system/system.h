#pragma once

// The constant data of a simulation: a hub and its subsystems (blades), each a chain of flexible
// bodies tied by bracket joints, the first tied to the hub.

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "models/control.h"
#include "models/plane/flexible_body.h"
#include "models/plane/plane.h"
#include "models/rotor.h"
#include "models/system/beam_modes.h"
#include "models/system/blade_air_model.h"
#include "models/system/blade_loads.h"
#include "models/system/drag_model.h"
#include "models/system/loop_model.h"
#include "models/wind.h"

namespace spoke {

/// A body in its tree.
template <class World>
struct TreeBody {
  /// Index of the body that carries it, less than its own; -1: the hub.
  int parent = -1;
  /// Handle of that body at which it hangs, from 1; 0 is the inboard one.
  int handle = 1;
  /// Indices of the bodies that it carries, by handle: one at each, from handle 1.
  std::vector<int> children;
  typename World::Joint joint;  ///< joint that carries it
  std::shared_ptr<const typename World::Body> body;
  /// Station on its beam less that on the body, whose stations may begin at 0 wherever it is; in
  /// space [m].
  double begin = 0.0;
  typename World::Stiffening stiffening;
  std::vector<BodyLoad<World>> loads;
  std::vector<BodyDrag<World>> drags;
  ModalShare modal;  ///< empty unless its beam is damped by modes
};

/// A rotor on a support or on another subsystem: its hub is a body of that tree, on the axle, and
/// carries subsystems of its own.
struct SupportedRotor {
  int subsystem = 0;  ///< index of the tree; its own rotor, if it has one, has a lower number
  int body = 0;       ///< index of the hub in it
  int driven = 0;     ///< index of the body whose joint the drive turns: the hub, or its generator
  double gear_ratio = 1.0;  ///< turns of the generator for one of the hub; 1 without one
  bool is_coupled = false;  ///< whether couplings act on its axle, as a drive train does
  /// Whether all that carries the axle moves as prescribed, so that the hub's acceleration is known
  /// in advance.
  bool is_moved = false;
  std::string prefix{};  ///< of its names, see prefix_of_rotor()
};

/// An angle that joints of a subsystem follow, as a controller demands it in samples.
struct DemandedAngle {
  std::optional<PitchControl> law{};  ///< the scenario's own; none: demands come between steps
  bool is_pitch = true;               ///< else the yaw of what carries the hub
  double initial = 0.0;               ///< at t = 0 [rad]
  double sign = 1.0;                  ///< joint angle by demanded angle
};

/// A subsystem: a tree of bodies on a hub, parents first; in the plane a chain, root to tip.
template <class World>
struct Subsystem {
  /// Index in System::rotors of the rotor whose hub carries it; -1: System::hub does.
  int rotor = -1;
  /// Pose of the root bracket in the hub frame; in space, pose of the first body's frame of the
  /// description (a beam's own axes), joint coordinates zero.
  PoseOf<World> root;
  double length = 0.0;  ///< undeformed length, root to tip [m]
  /// Place of the undeformed tip in space, hub frame [m].
  PositionOf<World> tip = PositionOf<World>::Zero();
  std::vector<TreeBody<World>> bodies;
  std::vector<LoopModel> loops;
  std::shared_ptr<const BladeAirModel> air;  ///< null: none acts on it; always in the plane
  std::shared_ptr<const DragModel> drag;     ///< likewise, of its bodies in the wind
  std::vector<DemandedAngle> controls;       ///< angles that controllers move joints of it by
  /// Factors f of the modes that damp its beams, beam by beam: D = b K + sum f w w^T [1/s].
  std::vector<double> modal_factors;

  /// Returns the number of rows of all loops.
  int loop_rows() const {
    int count = 0;
    for (const LoopModel& loop : loops) count += static_cast<int>(loop.rows.size());
    return count;
  }
};

template <class World>
struct System {
  /// The hub, or what carries the support of rotors: the ground, an axle that does not turn, or a
  /// fuselage.
  typename World::Hub hub;
  std::vector<SupportedRotor> rotors;  ///< rotors on supports
  std::vector<typename World::HubLoad> hub_loads;
  std::vector<Subsystem<World>> subsystems;
  std::vector<AnchorModel> anchors;
  std::vector<SharedLoop> shared_loops;  ///< between subsystems
  /// Gravitational acceleration, inertial frame, at full size [m/s^2].
  PositionOf<World> gravity = PositionOf<World>::Zero();
  double gravity_ramp = 0.0;  ///< [s]
  Damping damping;
  std::shared_ptr<const WindField> wind;  ///< null where no air acts on a subsystem

  /// Returns the gravitational acceleration in force at time t [s].
  PositionOf<World> gravity_at(double t) const { return gravity * calc_rise(t, gravity_ramp); }

  int body_count() const {
    int count = 0;
    for (const Subsystem<World>& s : subsystems) count += static_cast<int>(s.bodies.size());
    return count;
  }
  /// Returns the number of deformation coordinates of all bodies together.
  int deformation_count() const {
    int count = 0;
    for (const Subsystem<World>& s : subsystems)
      for (const TreeBody<World>& member : s.bodies) count += member.body->coordinates();
    return count;
  }
};

/// Whether an anchor beside the axle of a rotor on a support carries a place.
template <class World>
bool stands_beside_axle(const System<World>& system, const LoopPlaceModel& place) {
  return place.carrier == LoopPlace::Carrier::anchor &&
         system.anchors[static_cast<std::size_t>(place.anchor)].frame == Anchor::Frame::axle;
}

/// Returns the rotors whose hubs are bodies of subsystem `i`, ascending.
template <class World>
std::vector<int> find_rotors_on(const System<World>& system, int i) {
  std::vector<int> rotors;
  for (int r = 0; std::cmp_less(r, system.rotors.size()); ++r)
    if (system.rotors[static_cast<std::size_t>(r)].subsystem == i) rotors.push_back(r);
  return rotors;
}
/// Returns whether there are any.
template <class World>
bool carries_rotor(const System<World>& system, int i) {
  return std::any_of(system.rotors.begin(), system.rotors.end(),
                     [i](const SupportedRotor& rotor) { return rotor.subsystem == i; });
}

/// Returns the level of subsystem `i`: 0 on System::hub, else one more than that of the subsystem
/// whose body is the hub that carries it.
template <class World>
int calc_level(const System<World>& system, int i) {
  int level = 0;
  for (int r = system.subsystems[static_cast<std::size_t>(i)].rotor; r >= 0; ++level)
    r = system
            .subsystems[static_cast<std::size_t>(
                system.rotors[static_cast<std::size_t>(r)].subsystem)]
            .rotor;
  return level;
}
/// Returns the subsystems that carry rotors, each behind the one that carries it.
template <class World>
std::vector<int> find_supports(const System<World>& system) {
  std::vector<int> supports;
  for (int i = 0; std::cmp_less(i, system.subsystems.size()); ++i)
    if (carries_rotor(system, i)) supports.push_back(i);
  std::stable_sort(supports.begin(), supports.end(), [&system](int a, int b) {
    return calc_level(system, a) < calc_level(system, b);
  });
  return supports;
}

/// Returns whether component `c` of the hub's twist (x, y, rotation) is prescribed.
bool is_prescribed(const Hub& hub, int c);

/// Returns the rotation from the hub frame to the inertial frame at an angle of the drive [rad].
inline plane::Rotation rotation_of(const Hub&, double angle) {
  return plane::Rotation::from_angle(angle);
}
/// Returns M_0 of the hub alone, hub frame.
inline TwistMatrix calc_hub_mass(const Hub& hub) {
  return Twist(hub.mass, hub.mass, hub.inertia).asDiagonal();
}
/// Adds the forces of the hub's own inertia at zero acceleration: none in the plane, where its mass
/// centre is on its axis.
inline void add_gyroscopic_force(const Hub&, const Twist&, Twist&) {}
/// Returns the moment of inertia of the hub alone about its axis [kg m^2].
inline double axial_inertia(const Hub& hub) { return hub.inertia; }
/// Returns the moment of a load besides that of its force [N m].
inline double moment_of(const HubLoad& load) { return load.torque; }

/// Builds the constants of a rotor; equal bodies share them.
System<Plane> make_system(const Rotor& rotor);

}  // namespace spoke
