#pragma once

// Joints of a model in space by number, and the motions that the embedding program prescribes.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "engine/space/joint_motion.h"
#include "engine/step/step_context.h"
#include "models/space/tree_joint.h"
#include "models/tree/tree.h"

namespace spoke {

/// A coordinate of the joint that carries a body; all three from 0.
struct JointPlace {
  int tree = 0;
  int joint = 0;  ///< number of the body
  int coordinate = 0;
};

/// What a simulation asks of joints, see Simulation::set_joint_motion(). Throws InputError where
/// there is no such tree, joint or coordinate.
class SpatialJoints {
 public:
  /// Both must outlive this.
  SpatialJoints(const std::vector<spatial::Tree>& trees, SystemContext<Space>& context)
      : trees_(trees), context_(context) {}

  /// "coordinate 0 of joint 2 ("pitch") of blade 1".
  std::string describe(const JointPlace& place) const;
  /// Of the coordinate: "rad", "m".
  std::string unit(const JointPlace& place) const;
  /// The joint of that name.
  int find(int tree, std::string_view name) const;
  /// Of a coordinate whose motion is prescribed, at time t [s].
  space::PrescribedMotion motion(const JointPlace& place, double t);
  /// The course of a coordinate whose motion the program prescribes.
  space::DrivenMotion& said_motion(const JointPlace& place);
  /// Throws InputError unless a motion that begins like this goes on from where the coordinate is
  /// at time t [s], and is finite.
  void check_continuation(const JointPlace& place, const space::PrescribedMotion& begin, double t);

 private:
  const spatial::Tree& tree(int number) const;
  const spatial::JointCoordinate& coordinate(const JointPlace& place) const;
  /// Its number among the driven components of its joint.
  std::size_t find_driven(const JointPlace& place) const;

  const std::vector<spatial::Tree>& trees_;
  SystemContext<Space>& context_;
};

}  // namespace spoke
