#include "tests/engine/bodies/space/random_joint.h"

#include <cctype>

#include "tests/models/space/random_space.h"

namespace spoke::space::testing {
namespace {

/// The axis of the `at`th primitive leans away from that of the one before, so that no angle within
/// a radian locks three rotations.
JointPrimitive make_random_primitive(char letter, int at, std::mt19937& random) {
  using Kind = JointPrimitive::Kind;
  JointPrimitive primitive;
  switch (letter) {
    case 'R':
    case 'r':
      primitive.kind = Kind::revolute;
      break;
    case 'P':
    case 'p':
      primitive.kind = Kind::prismatic;
      break;
    default:
      primitive.kind = Kind::spherical;
  }
  const bool is_lower = std::islower(static_cast<unsigned char>(letter)) != 0;
  primitive.axis =
      (Position(Position::Unit(at % kPosition)) + 0.3 * random_vector(random)).normalized();
  primitive.stiffness = 2.0 + random_number(random);
  primitive.damping = 0.2 + 0.1 * random_number(random);
  if (primitive.kind == Kind::spherical) {
    primitive.frame = is_lower ? TurnFrame::parent : TurnFrame::child;
  } else {
    primitive.is_driven = is_lower;
    primitive.rest = random_number(random);
    primitive.stop = {-0.3 + 0.2 * random_number(random), 0.3 + 0.2 * random_number(random),
                      4.0 + random_number(random), 0.3 + 0.1 * random_number(random),
                      0.3 + 0.2 * random_number(random)};
  }
  return primitive;
}

}  // namespace

Joint make_random_joint(const char* kind, std::mt19937& random) {
  std::vector<JointPrimitive> primitives;
  for (const char* letter = kind; *letter; ++letter)
    primitives.push_back(make_random_primitive(*letter, static_cast<int>(letter - kind), random));
  const Position p = random_vector(random);
  return make_joint({p, random_rotation(random)}, primitives);
}

}  // namespace spoke::space::testing
