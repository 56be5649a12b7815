// Numbers the coordinates of a joint.

#include "models/space/joint.h"

#include <algorithm>
#include <cassert>

namespace spoke::space {

Joint make_joint(const Pose& offset, std::span<const JointPrimitive> primitives) {
  assert(primitives.size() <= Joint::kMost);
  Joint joint;
  joint.offset = offset;
  joint.primitive_count = static_cast<int>(primitives.size());
  std::copy(primitives.begin(), primitives.end(), joint.primitives.begin());
  for (const JointPrimitive& primitive : primitives) {
    if (primitive.kind == JointPrimitive::Kind::spherical) {
      assert(joint.spherical_at < 0 && !primitive.is_driven);
      joint.spherical_at = joint.coordinates;
      joint.spherical_frame = primitive.frame;
    }
    (primitive.is_driven ? joint.driven : joint.coordinates) += primitive.components();
  }
  assert(joint.coordinates + joint.driven <= Joint::kMost);
  return joint;
}

}  // namespace spoke::space
