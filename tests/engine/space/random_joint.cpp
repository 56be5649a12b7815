#include "tests/engine/space/random_joint.h"

#include <cctype>

#include "tests/models/space/random_space.h"

namespace spoke::space::testing {
namespace {

JointPrimitive make_random_primitive(char letter, std::mt19937& random) {
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
  primitive.axis = random_axis(random);
  primitive.stiffness = 2.0 + random_number(random);
  primitive.damping = 0.2 + 0.1 * random_number(random);
  if (primitive.kind == Kind::spherical) {
    primitive.frame = is_lower ? TurnFrame::parent : TurnFrame::child;
  } else {
    primitive.is_driven = is_lower;
    primitive.rest = random_number(random);
  }
  return primitive;
}

}  // namespace

Joint make_random_joint(const char* kind, std::mt19937& random) {
  std::vector<JointPrimitive> primitives;
  for (const char* letter = kind; *letter; ++letter)
    primitives.push_back(make_random_primitive(*letter, random));
  const Position p = random_vector(random);
  return make_joint({p, random_rotation(random)}, primitives);
}

}  // namespace spoke::space::testing
