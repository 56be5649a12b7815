// The mass matrix of a rigid body.

#include "models/space/rigid_body.h"

namespace spoke::space {

SymmetricTwistMatrix calc_mass(const RigidBody& body) {
  return translate(body.centre, SymmetricTwistMatrix::from_blocks(body.mass * Matrix3::Identity(),
                                                                  Matrix3::Zero(), body.inertia));
}

}  // namespace spoke::space
