// What is made of a rigid body once, and what a pass asks it.

#include "engine/bodies/kinds/rigid/rigid_kind.h"

#include <cassert>
#include <limits>

#include "engine/bodies/kernels/space/table_access.h"
#include "engine/bodies/kernels/structured_body.h"
#include "engine/bodies/space/rigid_body_terms.h"

namespace spoke {
namespace {

const space::RigidPort& port_of(const BodyData<Space>& body) { return *body.blocks[0]->rigid; }

/// Adds a wrench in B, and its power.
void add_rigid_wrench(const space::HandleMotion& motion, const space::Twist& wrench,
                      const space::Twist& twist, BodyData<Space>& body) {
  body.terms.Q += translate(motion.s, wrench);
  body.terms.load_power += calc_wrench_power(wrench, motion, twist);
}

/// Sets what the elimination by masses reads.
void place_mass(const BodyData<Space>& body, const space::Twist& twist) {
  const tree::MultiPort<Space>& port = body.work.port;
  if (!body.carried) return space::place_mass(port_of(body), twist, body.terms.Q, port);
  port.diagonal[0] = body.carried->mass;
  port.free[0] = body.terms.Q;
  for (int h = 1; h < port.handles; ++h) port.free[h].setZero();  // all at its origin
}

}  // namespace

const space::SymmetricTwistMatrix& rigid_mass_of(const BodyData<Space>& body) {
  assert(body.model->body->rigid() && body.blocks[0] && body.blocks[0]->rigid);
  return body.blocks[0]->rigid->mass;
}

std::size_t RigidKind::count_work(const space::Body& body) const {
  return space::count_work(*body.rigid());
}

space::BodyWork RigidKind::place_work(const space::Body& body, double* memory) const {
  return space::place_work(*body.rigid(), memory);
}

double RigidKind::calc_surely_linear(const space::Body&, double) const {
  return std::numeric_limits<double>::infinity();
}

space::Block RigidKind::make_block(const space::Body& body, const space::BlockFactors&) const {
  space::Block block;
  block.rigid.emplace(*body.rigid());
  return block;
}

PlacedLoad<Space, BodyLoad<Space>> RigidKind::place_load(const BodyLoad<Space>& load,
                                                         const space::Body&) const {
  return {&load, {}, {}};
}

double RigidKind::estimate_constants(const space::Body&) const { return sizeof(space::Body); }

void RigidKind::calc_terms(const System<Space>&, double, const space::ImplicitShares&,
                           std::size_t j, SubsystemData<Space>& data) const noexcept {
  Data& body = data.bodies[j];
  const space::RigidBody& rigid = *body.model->body->rigid();
  const space::SymmetricTwistMatrix& mass = rigid_mass_of(body);
  space::BodyTerms terms;
  terms.S = rigid.mass * rigid.centre;
  terms.Theta = mass.rr();
  terms.Q = calc_gyroscopic_force(mass, data.twists[j]);
  if (body.carried) terms.Q += body.carried->force;
  body.terms = terms;
}

void RigidKind::add_applied(double t, const space::Rotation& R_HB, std::size_t j,
                            SubsystemData<Space>& data) const noexcept {
  Data& body = data.bodies[j];
  const space::Twist& twist = data.twists[j];
  for (const auto& [section, wrench, motion] : body.applied)
    add_rigid_wrench(motion ? *motion : motion_at(body, *section),
                     make_wrench(wrench->force, wrench->moment), twist, body);
  for (const auto& placed : body.loads) {
    const BodyLoad<Space>& load = *placed.load;
    for (std::size_t k = 0; k < load.points.size(); ++k)
      add_rigid_wrench(space::make_fixed_handle(load.points[k].place),
                       calc_load_wrench(load, k, t, R_HB, data.hub->R, {}), twist, body);
  }
}

space::Position RigidKind::sum_loads(double t, const space::Rotation& R_HB,
                                     const space::Rotation& R_0, const Data& body) const noexcept {
  space::Position sum = space::Position::Zero();
  for (const auto& placed : body.loads)
    for (std::size_t k = 0; k < placed.load->points.size(); ++k)
      sum += linear(calc_load_wrench(*placed.load, k, t, R_HB, R_0, {}));
  return sum;
}

space::Position RigidKind::calc_linear_momentum(const Data& body,
                                                const space::Twist& twist) const noexcept {
  return linear(rigid_mass_of(body) * twist);
}

void RigidKind::condense(const space::Twist& twist, bool, const structured::BodyWork<Space>& work,
                         Data& body) const noexcept {
  if (work.by_mass)
    place_mass(body, twist);
  else if (body.carried)
    space::condense(*body.carried, body.terms.Q, body.work.port);
  else
    space::condense(port_of(body), twist, body.terms.Q, body.work.port);
}

void RigidKind::recover(const structured::BodyWork<Space>& work, bool, Data& body,
                        double*) const noexcept {
  const space::Twist* wrenches = body.work.wrenches;
  if (work.by_mass) {
    body.X = work.X;
  } else if (body.carried) {
    space::Twist sum = body.terms.Q;
    for (int h = 0; h < body.work.port.handles; ++h) sum += wrenches[h];
    body.X = body.carried->inverse * sum;
  } else {
    const auto count = static_cast<std::size_t>(body.work.port.handles);
    body.X = space::recover_frame(port_of(body), body.terms.Q, {wrenches, count});
  }
}

}  // namespace spoke
