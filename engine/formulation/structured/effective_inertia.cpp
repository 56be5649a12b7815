// Effective mass and force of a subsystem, (P 10): the block-tridiagonal Phi M^-1 Phi^T of its
// joints is eliminated from the tip; only its first pivot reaches the hub. docs/formulation.md,
// section 4.1, "condensing a blade".

#include "engine/formulation/structured.h"

namespace spoke::structured {

void calc_effective_inertia(const Subsystem& subsystem, SubsystemData& data,
                            SubsystemWork& work) noexcept {
  const std::size_t count = work.bodies.size();
  // (1) Tip: Lam = P_ii, be = a_i.
  SymmetricTwistMatrix Lambda =
      work.bodies[count - 1].port.P_ii;             // compliance of what hangs at a joint
  Twist free = work.bodies[count - 1].port.free_i;  // its acceleration without wrench
  // (2) Body j carries what hangs at its outboard joint (' of the child), R = R_PB of the child:
  //   Pi = (P_oo + R Lam' R^T)^-1,   rhs = R be' - a_o
  //   Lam = P_ii - P_io Pi P_io^T,   be = a_i + P_io Pi rhs
  for (std::size_t j = count - 1; j-- > 0;) {
    const TwoPort& port = work.bodies[j].port;
    JointElimination& joint = work.bodies[j].joint;
    const Rotation& R = data.rotations[j + 1];
    const SymmetricTwistMatrix Pi = invert(port.P_oo + rotate(R, Lambda));
    const Twist rhs = R * free - port.free_o;
    const Twist f = Pi * rhs;  // the joint's wrench if F = 0
    Lambda = eliminate(port.P_ii, port.P_io, Pi);
    free = port.free_i + port.P_io.lazyProduct(f);
    joint.Pi = Pi;
    joint.rhs = rhs;
  }

  // (3) Root: M^C = T^T R Lam^-1 R^T T and Q^C = T^T R Lam^-1 R^T (R be - [-w0^2 p; 0]), with the
  // bracket's acceleration T Y'' + [-w0^2 p; 0] in the hub frame. R leads there from the first
  // body's.
  EffectiveInertia& effective = data.effective;
  work.root = {invert(Lambda), free};
  const Rotation& R = data.rotations[0];
  const Position& p = subsystem.root.p;
  const SymmetricTwistMatrix mass = rotate(R, work.root.mass);
  const double ww = data.hub->twist[kRotation] * data.hub->twist[kRotation];
  const Twist bias(-ww * p.x(), -ww * p.y(), 0.0);
  effective.mass = translate(p, mass).matrix();
  effective.force = translate(p, mass * Twist(R * free - bias));
  // (4) The terms of geometric stiffening, for the hub's equation: qf^T KG qf and qf^T KG qf'.
  effective.centrifugal_inertia = effective.centrifugal_rate = 0.0;
  for (const BodyData& body : data.bodies) {
    effective.centrifugal_inertia += body.terms.centrifugal_inertia;
    effective.centrifugal_rate += body.terms.centrifugal_rate;
  }
}

}  // namespace spoke::structured
