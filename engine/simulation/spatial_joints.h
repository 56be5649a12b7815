#pragma once

// Joints of a model in space by number, and the motions that the embedding program prescribes.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "engine/bodies/space/joint_motion.h"
#include "engine/step/step_context.h"
#include "models/space/tree_joint.h"
#include "models/tree/tree.h"

namespace spoke {

/// A coordinate of the joint that carries a body; all three numbers count from 0.
struct JointPlace {
  int subsystem = 0;
  int joint = 0;  ///< number of the body that it carries
  int coordinate = 0;
};

/// Access of a simulation to joints, see Simulation::set_joint_motion() and set_joint_torque().
/// Throws InputError where there is no such subsystem, joint or coordinate.
class SpatialJoints {
 public:
  /// Keeps references to both, which must outlive this.
  SpatialJoints(const std::vector<spatial::Tree>& trees, SystemContext<Space>& context)
      : trees_(trees), context_(context) {}

  /// Returns a name like "coordinate 0 of joint 2 ("pitch") of blade 1".
  std::string describe(const JointPlace& place) const;
  /// Returns the unit of the coordinate: "rad" or "m".
  std::string unit(const JointPlace& place) const;
  /// Returns the number of the joint of that name.
  int find(int subsystem, std::string_view name) const;
  /// Returns the motion of a coordinate at time t [s], at which the state is: as it is prescribed,
  /// or as it is found of one that is free.
  space::PrescribedMotion motion(const JointPlace& place, double t);
  /// Returns the course of a coordinate whose motion the program prescribes.
  space::DrivenMotion& said_motion(const JointPlace& place);
  /// Returns the torque or force that the program adds to those on a free coordinate [N m, N].
  double& added_torque(const JointPlace& place);
  /// Returns all coordinates whose motion the program prescribes.
  std::vector<JointPlace> said() const;
  /// Throws InputError unless a motion that begins with `begin` is finite and goes on from where
  /// the coordinate is at time t [s].
  void check_continuation(const JointPlace& place, const space::PrescribedMotion& begin, double t);

 private:
  const spatial::Tree& tree(int subsystem) const;
  const spatial::JointCoordinate& coordinate(const JointPlace& place) const;
  space::PrescribedMotion free_motion(const JointPlace& place) const;
  /// Returns the number of free coordinates of its joint before it.
  std::size_t count_free_before(const JointPlace& place) const;
  /// Returns its number among the driven components of its joint.
  std::size_t find_driven(const JointPlace& place) const;

  const std::vector<spatial::Tree>& trees_;
  SystemContext<Space>& context_;
};

}  // namespace spoke
