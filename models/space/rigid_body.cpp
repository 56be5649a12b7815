// The mass matrix of a rigid body.

#include "models/space/rigid_body.h"

namespace spoke::space {

SymmetricTwistMatrix calc_mass(const RigidBody& body) {
  SymmetricTwistMatrix at_centre;
  at_centre.tt = body.mass * Matrix3::Identity();
  at_centre.rr = body.inertia;
  return translate(body.centre, at_centre);
}

}  // namespace spoke::space
