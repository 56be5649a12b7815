#pragma once

// A joint as the elimination of a tree sees it (engine/bodies/tree/joint_elimination.h).

#include "engine/bodies/space/joint_forces.h"

namespace spoke::space {

/// References to the quantities of one joint, by the names that the elimination uses.
struct JointTerms {
  JointTerms(const Joint& joint, const JointMotion& motion, const JointForces& forces)
      : coordinates(joint.coordinates),
        R(motion.R),
        p(motion.p),
        bias(motion.bias),
        columns(motion.columns),
        tau(forces.tau),
        share(forces.share) {}

  int coordinates;
  const Rotation& R;
  const Position& p;
  const Twist& bias;
  const JointColumns& columns;
  const std::array<double, Joint::kMost>& tau;
  const std::array<double, Joint::kMost>& share;
};

}  // namespace spoke::space
