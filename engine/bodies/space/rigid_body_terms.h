#pragma once

// A rigid body as a body of a tree: M_RR X = Q + sum of J_h^T f_h over its handles, with
// J_h = [1, -s~; 0, 1] of a handle at s. X is the acceleration of the frame, the origin's less
// gravity, in the frame.

#include <span>

#include "engine/bodies/tree/multi_port.h"
#include "models/space/rigid_body.h"

namespace spoke::space {

struct CarriedInertia;

/// Constants of a rigid body's multi-port: P_ab = J_a M_RR^-1 J_b^T.
struct RigidPort {
  explicit RigidPort(const RigidBody& body);

  SymmetricTwistMatrix mass;                   ///< M_RR
  SymmetricTwistMatrix inverse;                ///< M_RR^-1
  std::vector<Position> handles;               ///< places in the frame, the first at its origin [m]
  std::vector<SymmetricTwistMatrix> diagonal;  ///< as in MultiPort
  std::vector<TwistMatrix> pairs;              ///< as in MultiPort
};

/// Returns the right-hand side at the twist of the frame, in the frame, without loads: Q = [-w x (w
/// x S); -w x (Theta w)].
Twist calc_gyroscopic_force(const SymmetricTwistMatrix& mass, const Twist& twist) noexcept;

/// Sets the multi-port for the right-hand side Q with all loads: a_h = J_h M_RR^-1 Q + [w x (w x
/// s_h); 0].
void condense(const RigidPort& body, const Twist& twist, const Twist& Q,
              const tree::MultiPort<Space>& port) noexcept;

/// Sets what the elimination by masses reads, in the memory of the multi-port: M_RR in the place of
/// P_00, Q in that of a_0, and of the other handles the accelerations [w x (w x s_h); 0] at X = 0.
void place_mass(const RigidPort& body, const Twist& twist, const Twist& Q,
                const tree::MultiPort<Space>& port) noexcept;

/// Sets the multi-port of a hub on a support, whose handles are all at its origin.
void condense(const CarriedInertia& hub, const Twist& Q,
              const tree::MultiPort<Space>& port) noexcept;

/// Returns the acceleration X = M_RR^-1 (Q + sum of J_h^T f_h) of the frame, from the wrenches f_h
/// on the handles.
Twist recover_frame(const RigidPort& body, const Twist& Q,
                    std::span<const Twist> wrenches) noexcept;

/// Returns the kinetic energy 1/2 V^T M_RR V of the twist V [J].
double calc_kinetic_energy(const SymmetricTwistMatrix& mass, const Twist& twist) noexcept;

}  // namespace spoke::space
