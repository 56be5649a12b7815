// Puts joints and deformations of each body.

#include "engine/step/put_bodies.h"

#include <cassert>

#include "engine/bodies/kernels/space/put_joint.h"

namespace spoke {
namespace {

/// Puts the joint of a body at q; returns what comes behind its coordinates.
const double* put_joint_of(const double* q, BodyData<Plane>&) { return q; }
const double* put_joint_of(const double* q, BodyData<Space>& body) {
  const space::Joint& joint = body.model->joint.joint;
  put_joint(joint, q, body.joint);
  return q + joint.coordinates;
}

}  // namespace

template <class World>
void put_bodies(const std::vector<Eigen::VectorXd>& q, SystemContext<World>& context) {
  assert(q.size() == context.data.subsystems.size());
  for (std::size_t i = 0; i < q.size(); ++i) {
    const double* next = q[i].data();
    for (BodyData<World>& body : context.data.subsystems[i].bodies) {
      next = put_joint_of(next, body);
      const int count = body.model->body->coordinates();
      for (int k = 0; k < count; ++k) body.coordinates.q[body.layout.offset(k)] = *next++;
    }
    assert(next == q[i].data() + q[i].size());
  }
}

template void put_bodies(const std::vector<Eigen::VectorXd>&, SystemContext<Plane>&);
template void put_bodies(const std::vector<Eigen::VectorXd>&, SystemContext<Space>&);

}  // namespace spoke
