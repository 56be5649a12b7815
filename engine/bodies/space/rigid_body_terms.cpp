// Calculates terms, condensation and recovery of a rigid body.

#include "engine/bodies/space/rigid_body_terms.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "engine/bodies/space/body_data.h"

namespace spoke::space {
namespace {

/// Returns J_a A J_b^T with J_a = [1, -a~; 0, 1].
TwistMatrix calc_between(const Position& a, const SymmetricTwistMatrix& A, const Position& b) {
  TwistMatrix m = A.matrix();
  for (int c = 0; c < kTwist; ++c) m.col(c) = refer(-a, m.col(c));
  for (int r = 0; r < kTwist; ++r) m.row(r) = refer(-b, m.row(r).transpose()).transpose();
  return m;
}

}  // namespace

RigidPort::RigidPort(const RigidBody& body) : mass(calc_mass(body)), handles{Position::Zero()} {
  assert(body.is_hub || (body.mass > 0.0 && body.inertia.diagonal().minCoeff() > 0.0));
  handles.insert(handles.end(), body.outboard.begin(), body.outboard.end());
  if (body.is_hub) return;  // the rest with what it carries, see CarriedInertia
  inverse = invert(mass);
  for (std::size_t b = 0; b < handles.size(); ++b) {
    diagonal.push_back(refer(-handles[b], inverse));
    for (std::size_t a = 0; a < b; ++a)
      pairs.push_back(calc_between(handles[a], inverse, handles[b]));
  }
}

Twist calc_gyroscopic_force(const SymmetricTwistMatrix& mass, const Twist& twist) noexcept {
  // The momentum M (0, w) is (w x S, Theta w).
  const Angular w = angular(twist);
  const Twist momentum = mass * make_twist(Position::Zero(), w);
  return -make_twist(cross(w, linear(momentum)), cross(w, angular(momentum)));
}

void condense(const CarriedInertia& hub, const Twist& Q,
              const tree::MultiPort<Space>& port) noexcept {
  const Twist free = hub.inverse * Q;
  for (int h = 0; h < port.handles; ++h) {
    port.diagonal[h] = hub.inverse;
    port.free[h] = free;
    for (int a = 0; a < h; ++a) port.between(a, h) = hub.inverse.matrix();
  }
}

void condense(const RigidPort& body, const Twist& twist, const Twist& Q,
              const tree::MultiPort<Space>& port) noexcept {
  assert(std::cmp_equal(body.handles.size(), port.handles));
  std::copy(body.diagonal.begin(), body.diagonal.end(), port.diagonal);
  std::copy(body.pairs.begin(), body.pairs.end(), port.pairs);
  const Twist X = body.inverse * Q;
  const Angular w = angular(twist);
  for (std::size_t h = 0; h < body.handles.size(); ++h) {
    const Position& s = body.handles[h];
    port.free[h] = refer(-s, X);
    linear(port.free[h]) += cross(w, cross(w, s));
  }
}

void place_mass(const RigidPort& body, const Twist& twist, const Twist& Q,
                const tree::MultiPort<Space>& port) noexcept {
  assert(std::cmp_equal(body.handles.size(), port.handles));
  port.diagonal[0] = body.mass;
  port.free[0] = Q;
  for (int h = 1; h < port.handles; ++h)
    port.free[h] = make_twist(
        centripetal(angular(twist), body.handles[static_cast<std::size_t>(h)]), Angular::Zero());
}

Twist recover_frame(const RigidPort& body, const Twist& Q,
                    std::span<const Twist> wrenches) noexcept {
  assert(wrenches.size() <= body.handles.size());
  Twist sum = Q;
  for (std::size_t h = 0; h < wrenches.size(); ++h) sum += translate(body.handles[h], wrenches[h]);
  return body.inverse * sum;
}

double calc_kinetic_energy(const SymmetricTwistMatrix& mass, const Twist& twist) noexcept {
  return 0.5 * twist.dot(mass * twist);
}

}  // namespace spoke::space
