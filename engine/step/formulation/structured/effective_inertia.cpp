// Effective mass and force of a subsystem, (P 10): the block-tridiagonal Phi M^-1 Phi^T of its
// joints is eliminated from the tips; only the pivots of its roots reach the hub.
// The derivation stands in docs/formulation.md, section 4.1, "condensing a blade".

#include <cassert>

#include "engine/bodies/kernels/hub_motion.h"
#include "engine/bodies/kernels/hub_solve.h"
#include "engine/step/formulation/structured/tree_elimination.h"
#include "engine/step/formulation/tree_joints.h"
#include "models/support/wide_kernels.h"

namespace spoke::structured {
namespace {

/// Condenses body j with all that hangs at its outboard joint (' of the child), R = R_PB of the
/// child:
///   Pi = (P_oo + R Lam' R^T)^-1,   rhs = R be' - a_o
///   Lam = P_ii - P_io Pi P_io^T,   be = a_i + P_io Pi rhs
/// At the tip Lam = P_ii, be = a_i.
void join_children(const Subsystem<Plane>& subsystem, std::size_t j,
                   const SubsystemData<Plane>& data, SubsystemWork<Plane>& work) {
  const plane::TwoPort& port = work.bodies[j].port;
  tree::Branch<Plane>& branch = work.bodies[j].branch;
  if (subsystem.bodies[j].children.empty()) {
    branch = {port.P_ii, port.free_i};
    return;
  }
  BodyWork<Plane>& child = work.bodies[j + 1];
  const Twist f =  // the joint's wrench if F = 0
      tree::eliminate_joint(port.P_oo, port.free_o, data.joints[j + 1], child.branch, child.joint);
  branch = tree::join<Plane>(port.P_ii, port.P_io, port.free_i, child.joint.Pi, f);
}

/// Sums the effective inertias at the hub: in the plane of a chain, in space of all trees. R of a
/// root leads from its body's frame to the hub's.
tree::HubShare<Plane> sum_shares(const Subsystem<Plane>& subsystem,
                                 const SubsystemData<Plane>& data,
                                 SubsystemWork<Plane>& work) noexcept {
  return tree::eliminate_root(make_root_joint(subsystem, data), work.bodies[0].branch,
                              work.roots[0]);
}
tree::HubShare<Space> sum_shares(const Subsystem<Space>& subsystem,
                                 const SubsystemData<Space>& data,
                                 SubsystemWork<Space>& work) noexcept {
  tree::HubShare<Space> sum;
  for (std::size_t k = 0; k < work.roots.size(); ++k) {
    const auto j = static_cast<std::size_t>(work.root_bodies[k]);
    const space::JointTerms joint = joint_of(subsystem, data, j);
    const tree::Branch<Space>& branch = work.bodies[j].branch;
    const tree::HubShare<Space> share = work.by_mass
                                            ? eliminate_root_by_mass(joint, branch, work.roots[k])
                                            : tree::eliminate_root(joint, branch, work.roots[k]);
    sum = k == 0 ? share : tree::HubShare<Space>{sum.mass + share.mass, sum.force + share.force};
  }
  return sum;
}

}  // namespace

template <class World>
void calc_effective_inertia(const Subsystem<World>& subsystem, SubsystemData<World>& data,
                            SubsystemWork<World>& work) noexcept {
  assert(work.bodies.size() == subsystem.bodies.size() && data.bodies.size() == work.bodies.size());
  // (1) Each body is condensed with all that it carries, from the tips.
  const tree::HubShare<World> share = run_kernel([&]() noexcept {
    for (std::size_t j = work.bodies.size(); j-- > 0;)
      work.by_mass ? join_children_by_mass(subsystem, j, data, work)
                   : join_children(subsystem, j, data, work);
    return sum_shares(subsystem, data, work);
  });
  EffectiveInertia<World>& effective = data.effective;
  effective.mass = share.mass.matrix();
  effective.force = share.force;
  // (3) The terms of geometric stiffening are summed for the hub's equation.
  effective.stiffening = sum_stiffening(data.bodies);
}

template void calc_effective_inertia(const Subsystem<Plane>&, SubsystemData<Plane>&,
                                     SubsystemWork<Plane>&) noexcept;
template void calc_effective_inertia(const Subsystem<Space>&, SubsystemData<Space>&,
                                     SubsystemWork<Space>&) noexcept;

}  // namespace spoke::structured
