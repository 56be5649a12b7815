// Effective mass and force of a subsystem, (P 10): the block-tridiagonal Phi M^-1 Phi^T of its
// joints is eliminated from the tip; only its first pivot reaches the hub. docs/formulation.md,
// section 4.1, "condensing a blade".

#include "engine/formulation/structured.h"
#include "engine/kernels/hub_motion.h"
#include "engine/kernels/hub_solve.h"

namespace spoke::structured {

template <class World>
void calc_effective_inertia(const Subsystem<World>& subsystem, SubsystemData<World>& data,
                            SubsystemWork<World>& work) noexcept {
  const std::size_t count = work.bodies.size();
  // (1) Tip: Lam = P_ii, be = a_i.
  typename World::SymmetricTwistMatrix Lambda =
      work.bodies[count - 1].port.P_ii;                      // compliance of what hangs at a joint
  TwistOf<World> free = work.bodies[count - 1].port.free_i;  // its acceleration without wrench
  // (2) Body j carries what hangs at its outboard joint (' of the child), R = R_PB of the child:
  //   Pi = (P_oo + R Lam' R^T)^-1,   rhs = R be' - a_o
  //   Lam = P_ii - P_io Pi P_io^T,   be = a_i + P_io Pi rhs
  for (std::size_t j = count - 1; j-- > 0;) {
    const typename BodyTypes<World>::Port& port = work.bodies[j].port;
    JointElimination<World>& joint = work.bodies[j].joint;
    const auto& R = data.rotations[j + 1];
    const typename World::SymmetricTwistMatrix Pi = invert(port.P_oo + rotate(R, Lambda));
    const TwistOf<World> rhs = R * free - port.free_o;
    const TwistOf<World> f = Pi * rhs;  // the joint's wrench if F = 0
    Lambda = eliminate(port.P_ii, port.P_io, Pi);
    free = port.free_i + port.P_io.lazyProduct(f);
    joint.Pi = Pi;
    joint.rhs = rhs;
  }

  // (3) Root: M^C = T^T R Lam^-1 R^T T and Q^C = T^T R Lam^-1 R^T (R be - [-w0^2 p; 0]), with the
  // bracket's acceleration T Y'' + [-w0^2 p; 0] in the hub frame. R leads there from the first
  // body's.
  EffectiveInertia<World>& effective = data.effective;
  work.root = {invert(Lambda), free};
  const auto& R = data.rotations[0];
  const auto& p = subsystem.root.p;
  const typename World::SymmetricTwistMatrix mass = rotate(R, work.root.mass);
  effective.mass = translate(p, mass).matrix();
  effective.force =
      translate(p, mass * TwistOf<World>(R * free - calc_bracket_bias(subsystem, *data.hub)));
  // (4) The terms of geometric stiffening, for the hub's equation: qf^T KG qf and qf^T KG qf'.
  sum_centrifugal(data.bodies, effective);
}

template void calc_effective_inertia(const Subsystem<Plane>&, SubsystemData<Plane>&,
                                     SubsystemWork<Plane>&) noexcept;

}  // namespace spoke::structured
