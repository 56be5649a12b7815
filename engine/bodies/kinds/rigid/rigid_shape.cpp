// A rigid body in sensors and pictures.

#include <algorithm>
#include <cmath>

#include "engine/bodies/kernels/space/body_shape.h"
#include "engine/bodies/kernels/space/table_access.h"
#include "engine/bodies/kinds/rigid/rigid_kind.h"

namespace spoke {

double RigidKind::reach(const space::Body& body) const noexcept {
  const space::RigidBody& rigid = *body.rigid();
  double reach = rigid.centre.norm();
  if (rigid.mass > 0.0) reach += std::sqrt(0.5 * rigid.inertia.trace() / rigid.mass);
  for (const space::Position& handle : rigid.outboard) reach = std::max(reach, handle.norm());
  return reach;
}

void RigidKind::place_reading(const std::optional<double>&, const TreeBody<Space>& member,
                              Reading<Space>& reading) const {
  reading.section = section_at(*member.body, 0.0);
}

void RigidKind::add_shape(const Data&, space::BodyShape& shape) const {
  const space::Position origin = space::Position::Zero();
  shape.nodes.push_back({{}, origin, space::make_fixed_handle(origin)});
}

std::vector<LumpedNode> RigidKind::lump(const Data& body, const space::Pose& pose) const {
  const space::RigidBody& rigid = *body.model->body->rigid();
  return {{pose.p, pose.R.axes, pose.p + pose.R * rigid.centre, rigid.mass, rigid.inertia(0, 0)}};
}

Eigen::MatrixXd RigidKind::calc_own_mass(const Data& body) const {
  return rigid_mass_of(body).matrix();
}

Eigen::VectorXd RigidKind::calc_frame_force(const Data& body) const {
  return body.terms.Q - rigid_mass_of(body) * body.X;
}

}  // namespace spoke
