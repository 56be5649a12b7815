#pragma once

// A tree of rigid bodies on a hub, and its accelerations: by elimination of the joints, and by one
// dense system of all unknowns.

#include <array>
#include <vector>

#include "engine/bodies/kernels/hub_solve.h"
#include "engine/bodies/space/hub_motion.h"
#include "engine/bodies/space/joint_terms.h"
#include "engine/bodies/space/rigid_body_terms.h"
#include "engine/step/integrator/rotation.h"
#include "tests/engine/bodies/space/hub_table.h"

namespace spoke::space::testing {

/// Coordinates that are integrated together, an orientation possibly among them.
class Coordinates {
 public:
  /// `rotation_at`: first place of an orientation; -1: there is none.
  Coordinates(int size, int rotation_at, TurnFrame frame = TurnFrame::child);

  CoordinateBlock block();
  /// Returns the orientation in `block`, a block() of these coordinates.
  RotationBlock rotation(CoordinateBlock& block);
  bool has_rotation() const { return rotation_at_ >= 0; }

  std::vector<double> q, v, a;
  RotationState orientation;

 private:
  std::vector<double> history_;
  int rotation_at_;
  TurnFrame frame_;
};

/// A quadratic function of time.
struct Course {
  double value = 0.0, rate = 0.0, acceleration = 0.0;  ///< at t = 0
  PrescribedMotion at(double t) const {
    return {value + t * (rate + 0.5 * t * acceleration), rate + t * acceleration, acceleration};
  }
};

/// A body with the joint at its inboard handle.
struct TreeBody {
  RigidBody body;
  Joint joint;
  int parent = -1;                            ///< index of a body before; -1: the hub
  int handle = 0;                             ///< of the parent, from 1; no other body's
  Twist load = Twist::Zero();                 ///< about the body's origin, in its frame
  std::array<double, Joint::kMost> motor{};   ///< of the joint's coordinates
  std::array<Course, Joint::kMost> driven{};  ///< of the joint's driven components
};

struct TreeHub {
  RigidBody body;
  HubSupport support = HubSupport::free;
  bool is_driven = false;  ///< the rotation about z is prescribed
  double torque = 0.0;     ///< about z, of a hub that is not driven
  Course drive;            ///< of a driven hub
};

/// Results of one evaluation.
struct TreeAccelerations {
  HubSolution<Space> hub;
  std::vector<Twist> bodies;                             ///< X
  std::vector<Twist> wrenches;                           ///< F on inboard handles, bodies' frames
  std::vector<std::array<double, Joint::kMost>> joints;  ///< q''
};

/// A body in its present state.
struct BodyState {
  explicit BodyState(const TreeBody& model);

  RigidPort port;
  Coordinates coordinates;
  std::array<PrescribedMotion, Joint::kMost> driven{};
  JointMotion motion;
  JointForces forces;
  Pose pose;    ///< in space
  Twist twist;  ///< in the body's frame
  Twist Q;      ///< right-hand side, with the load
};

class RigidTree {
 public:
  RigidTree(const TreeHub& hub, const std::vector<TreeBody>& bodies, const Position& gravity);

  /// Sets prescribed motions at time t, and the motion and forces of all bodies.
  void update(double t, const ImplicitShares& shares = {});
  TreeAccelerations eliminate() const;
  TreeAccelerations solve_dense() const;
  /// Takes the accelerations as those of the coordinates: calls `take(coordinates, accelerations)`
  /// for all that are integrated.
  template <class Take>
  void hand_out(const TreeAccelerations& found, Take&& take);
  /// Calls `visit(coordinates)` for all that are integrated.
  template <class Visit>
  void for_coordinates(Visit&& visit);

  double calc_energy() const;
  /// Returns the linear momentum, and the angular momentum about the origin of space.
  Twist calc_momentum() const;
  /// Returns the power of support, drives, motors and loads less that of dampers: the rate of the
  /// energy.
  double calc_power(const TreeAccelerations& found) const;

  TreeHub hub;
  std::vector<TreeBody> models;
  Position gravity;
  Coordinates hub_coordinates;  ///< place in space and orientation
  std::vector<BodyState> bodies;

 private:
  bool is_hub_integrated() const;
  void impose(double t);
  JointState joint_state(std::size_t j) const;
  JointTerms joint_terms(std::size_t j) const;
  /// Returns the index of the body at handle `o` of body j.
  std::size_t child_of(std::size_t j, int o) const;
  HubState hub_state() const;
  /// Sets up the hub's equation in a table of its own.
  void place_hub(HubTable& table) const;

  SymmetricTwistMatrix hub_mass_;
  double drive_acceleration_ = 0.0;
};

template <class Take>
void RigidTree::hand_out(const TreeAccelerations& found, Take&& take) {
  if (is_hub_integrated()) {
    HubTable table;
    place_hub(table);
    const Twist a = calc_inertial_acceleration(table.system, 0.0, table.data.hub, found.hub);
    take(hub_coordinates, a.data());
  }
  for (std::size_t j = 0; j < bodies.size(); ++j)
    if (models[j].joint.coordinates > 0) take(bodies[j].coordinates, found.joints[j].data());
}

template <class Visit>
void RigidTree::for_coordinates(Visit&& visit) {
  if (is_hub_integrated()) visit(hub_coordinates);
  for (std::size_t j = 0; j < bodies.size(); ++j)
    if (models[j].joint.coordinates > 0) visit(bodies[j].coordinates);
}

}  // namespace spoke::space::testing
