// Sets coordinates, and the reference of a spherical joint.

#include "engine/bodies/kernels/space/put_joint.h"

#include <algorithm>

#include "models/space/quaternion.h"

namespace spoke::space {

void put_joint(const Joint& joint, const double* q, JointData& data) {
  std::copy_n(q, joint.coordinates, data.coordinates.q);
  if (joint.spherical_at < 0) return;
  double* theta = data.coordinates.q + joint.spherical_at;
  data.rotation->reference = make_quaternion(Angular(theta[0], theta[1], theta[2]));
  std::fill_n(theta, kAngular, 0.0);
}

}  // namespace spoke::space
