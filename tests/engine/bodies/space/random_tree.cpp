#include "tests/engine/bodies/space/random_tree.h"

#include "tests/engine/bodies/space/random_joint.h"
#include "tests/models/space/random_space.h"

namespace spoke::space::testing {
namespace {

int random_index(int count, std::mt19937& random) {
  return std::uniform_int_distribution<int>(0, count - 1)(random);
}

RigidBody make_random_body(std::mt19937& random) {
  RigidBody body;
  body.mass = 1.0 + 0.5 * random_number(random);
  body.centre = random_vector(random);
  const SymmetricTwistMatrix inertia = random_inertia(random);
  body.inertia = 0.1 * inertia.tt() + 0.05 * Matrix3::Identity();
  return body;
}

TreeBody make_random_tree_body(const char* joint, bool is_conservative, std::mt19937& random) {
  TreeBody body;
  body.body = make_random_body(random);
  body.joint = make_random_joint(joint, random);
  if (is_conservative) {
    for (JointPrimitive& primitive : body.joint.primitives)
      primitive.damping = primitive.stop.stiffness = primitive.stop.damping = 0.0;
    return body;
  }
  body.load = random_twist(random);
  for (double& motor : body.motor) motor = random_number(random);
  for (Course& course : body.driven)
    course = {random_number(random), random_number(random), random_number(random)};
  return body;
}

void randomize(Coordinates& coordinates, std::mt19937& random) {
  for (auto* values : {&coordinates.q, &coordinates.v, &coordinates.a})
    for (double& value : *values) value = random_number(random);
  coordinates.orientation.reference = make_quaternion(random_vector(random));
}

}  // namespace

RigidTree make_random_tree(const RandomTree& kind, std::mt19937& random) {
  const std::vector<const char*> conservative{"", "R", "P", "S", "s", "RR", "PR", "RP"};
  const std::vector<const char*>& joints = kind.is_conservative ? conservative : kJointKinds;
  TreeHub hub;
  hub.body = make_random_body(random);
  hub.support = kind.hub == HubKind::free ? HubSupport::free : HubSupport::axle;
  hub.is_driven = kind.hub == HubKind::fixed || kind.hub == HubKind::driven;
  if (kind.hub == HubKind::driven) hub.drive = {0.3, 2.0, 0.7};
  if (kind.hub == HubKind::torque) hub.torque = 1.5;
  std::vector<TreeBody> bodies;
  for (int j = 0; j < kind.bodies; ++j) {
    bodies.push_back(make_random_tree_body(joints[static_cast<std::size_t>(j) % joints.size()],
                                           kind.is_conservative, random));
    bodies.back().parent = random_index(j + 1, random) - 1;
    if (bodies.back().parent < 0) continue;
    RigidBody& parent = bodies[static_cast<std::size_t>(bodies.back().parent)].body;
    parent.outboard.push_back(random_vector(random));
    bodies.back().handle = static_cast<int>(parent.outboard.size());
  }
  RigidTree tree(hub, bodies, random_vector(random));
  for (BodyState& body : tree.bodies) randomize(body.coordinates, random);
  Coordinates& place = tree.hub_coordinates;
  place.orientation.reference = make_quaternion(random_vector(random));
  for (std::size_t c = 0; c < kTwist; ++c) {
    if (c == Space::kAxial ? hub.is_driven : hub.support == HubSupport::axle) continue;
    place.q[c] = random_number(random);
    place.v[c] = random_number(random);
  }
  return tree;
}

}  // namespace spoke::space::testing
