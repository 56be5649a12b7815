// What sensors, loads and markers ask a rigid body, and its full matrices.

#include "engine/bodies/kernels/marker_rules.h"
#include "engine/bodies/kernels/space/table_access.h"
#include "engine/bodies/kinds/rigid/rigid_kind.h"
#include "engine/bodies/space/body_energies.h"
#include "engine/bodies/space/rigid_body_terms.h"
#include "models/error.h"

namespace spoke {

// Its handles do not move against its frame.
void RigidKind::place_handles(Data& body) const noexcept {
  space::HandleMotion* handles = body.work.handles;
  const space::RigidBody& rigid = *body.model->body->rigid();
  handles[0] = space::make_fixed_handle(space::Position::Zero());
  for (std::size_t h = 0; h < rigid.outboard.size(); ++h)
    handles[h + 1] = space::make_fixed_handle(rigid.outboard[h]);
}

Eigen::MatrixXd RigidKind::make_dense_block(const space::Body&, const space::BlockFactors&) const {
  return {};
}

void RigidKind::calc_dense_mass(const Data& body, const Eigen::MatrixXd&, bool,
                                Eigen::Ref<Eigen::MatrixXd> mass) const {
  mass = (body.carried ? body.carried->mass : rigid_mass_of(body)).matrix();
}

void RigidKind::calc_dense_force(const Data& body, Eigen::Ref<Eigen::VectorXd> force) const {
  force = body.terms.Q;
}

void RigidKind::calc_handle_jacobian(const Data& body, int handle,
                                     Eigen::Ref<Eigen::MatrixXd> J) const {
  J.setIdentity();
  J.topRightCorner<3, 3>() = -space::skew(body.work.handles[handle].s);
}

space::Section RigidKind::place_marker(const std::string& whose, const Marker& marker,
                                       const space::Body&) const {
  require_no_interface(whose, marker);
  if (marker.station != 0.0)
    throw InputError(whose + ": its station belongs to beams, expected a point on a rigid body");
  if (!marker.point.allFinite()) throw InputError(whose + ": its point is not finite");
  return space::make_rigid_section(marker.point);
}

space::Section RigidKind::section_at(const space::Body&, double) const {
  return space::make_rigid_section(space::Position::Zero());
}

space::HandleMotion RigidKind::motion_at(const Data&,
                                         const space::Section& section) const noexcept {
  return space::make_fixed_handle(section.s0);
}

space::Twist RigidKind::calc_section_acceleration(const Data&, const space::Section&,
                                                  const space::HandleMotion& motion,
                                                  const space::Twist& X, const space::Angular& w,
                                                  const double*) const noexcept {
  return motion.carry(X) + motion.bias(w);
}

space::Position RigidKind::find_tip(const Data& body) const noexcept {
  return body.model->body->rigid()->centre;
}

space::BodyEnergies RigidKind::calc_energies(const Data& body, const space::Twist& twist,
                                             const space::BodyMotion&) const noexcept {
  const space::RigidBody& rigid = *body.model->body->rigid();
  return {calc_kinetic_energy(rigid_mass_of(body), twist), 0.0, 0.0, rigid.mass * rigid.centre};
}

space::Twist RigidKind::calc_momentum(const Data& body, const space::Twist& twist) const noexcept {
  return rigid_mass_of(body) * twist;
}

}  // namespace spoke
