// Effective mass and force of a subsystem, (P 10), with D = Phi M^-1 Phi^T formed and factorised
// whole: docs/formulation.md, section 4.2.

#include <cassert>

#include "engine/bodies/kernels/hub_solve.h"
#include "engine/step/formulation/subsystem.h"
#include "engine/step/formulation/subsystem/joint_coordinates.h"
#include "engine/step/formulation/tree_joints.h"
#include "engine/support/dense.h"

namespace spoke::subsystem {
namespace {

/// Fills the rows of the joint that carries body k in D, and in `right`, Phi M^-1 Q - gamma. They
/// hold -J_0 of this body and C J_h of the parent's handle, C = R^T T. So D couples a joint with
/// that of its parent's, and with those at other handles of its parent; joints at the hub have no
/// others. Only its lower triangle is filled.
template <class World>
void add_joint(const Subsystem<World>& subsystem, const SubsystemData<World>& data, int k,
               SubsystemWork<World>& work) {
  constexpr int d = World::kTwist;
  const auto joint = joint_of(subsystem, data, static_cast<std::size_t>(k));
  const TreeBody<World>& child = subsystem.bodies[k];
  auto rows = work.D.template middleRows<d>(d * k);
  auto right = work.solution.col(d).template segment<d>(d * k);
  rows.template middleCols<d>(d * k) = work.bodies[k].compliance(0, 0);
  right = -work.bodies[k].free_acceleration(0);
  right += joint.R.inverse() * TwistOf<World>(joint.bias);
  place_columns<World>(joint, k, work);
  if (child.parent < 0) return;
  const BodyWork<World>& parent = work.bodies[child.parent];
  const TwistMatrixOf<World> C = tree::carrying_matrix<World>(joint);
  const int h = child.handle;
  rows.template middleCols<d>(d * k) += C * parent.compliance(h, h) * C.transpose();
  rows.template middleCols<d>(d * child.parent) = -C * parent.compliance(h, 0);
  right += C * parent.free_acceleration(h);
  for (const int other : subsystem.bodies[child.parent].children) {
    if (other >= k) continue;
    const TwistMatrixOf<World> C_other =
        tree::carrying_matrix<World>(joint_of(subsystem, data, static_cast<std::size_t>(other)));
    rows.template middleCols<d>(d * other) =
        C * parent.compliance(h, subsystem.bodies[other].handle) * C_other.transpose();
  }
}

/// (3) Adds the share of the tree of root j, whose Phi_Y is R^T T.
template <class World>
void add_root(const Subsystem<World>& subsystem, const SubsystemData<World>& data, std::size_t j,
              const SubsystemWork<World>& work, EffectiveInertia<World>& effective) {
  constexpr int d = World::kTwist;
  const TwistMatrixOf<World> Phi_Y = tree::carrying_matrix<World>(joint_of(subsystem, data, j));
  const auto rows = work.solution.template middleRows<d>(d * static_cast<Eigen::Index>(j));
  effective.mass += Phi_Y.transpose() * rows.template leftCols<d>() * Phi_Y;
  effective.force -= Phi_Y.transpose() * rows.col(d);
}

/// (1) Fills D, the last column of `solution`, and the columns of the joints' coordinates.
template <class World>
void assemble(const Subsystem<World>& subsystem, const SubsystemData<World>& data,
              SubsystemWork<World>& work) {
  work.D.setZero();
  work.columns.setZero();
  for (std::size_t j = 0; j < work.bodies.size(); ++j)
    add_joint(subsystem, data, static_cast<int>(j), work);
}

}  // namespace

template <class World>
void calc_effective_inertia(const Subsystem<World>& subsystem, SubsystemData<World>& data,
                            SubsystemWork<World>& work) noexcept {
  assert(work.bodies.size() == subsystem.bodies.size() && data.bodies.size() == work.bodies.size());
  constexpr int d = World::kTwist;
  // (1) D = Phi M^-1 Phi^T and Phi M^-1 Q - gamma are assembled joint by joint.
  assemble(subsystem, data, work);
  // (2) D^-1 is applied to the root joints' rows and to Phi M^-1 Q - gamma. Phi_Y has rows at roots
  // only.
  factorise_cholesky(work.D);
  Eigen::MatrixXd& solution = work.solution;
  solution.leftCols<d>().setZero();
  for (std::size_t j = 0; j < work.bodies.size(); ++j)
    if (subsystem.bodies[j].parent < 0)
      solution.block<d, d>(d * static_cast<Eigen::Index>(j), 0).setIdentity();
  solve_cholesky(work.D, solution);
  if (work.columns.cols() > 0) {
    work.inverse_columns = work.columns;
    solve_cholesky(work.D, work.inverse_columns);
    eliminate_coordinates(subsystem, data, work);
  }

  // (3) M^C = Phi_Y^T D^-1 Phi_Y and Q^C = Phi_Y^T D^-1 (gamma - Phi M^-1 Q), summed over the
  // roots.
  EffectiveInertia<World>& effective = data.effective;
  effective.mass.setZero();
  effective.force.setZero();
  for (std::size_t j = 0; j < work.bodies.size(); ++j)
    if (subsystem.bodies[j].parent < 0) add_root(subsystem, data, j, work, effective);
  // (4) The terms of geometric stiffening are summed for the hub's equation.
  effective.stiffening = sum_stiffening(data.bodies);
}

template void calc_effective_inertia(const Subsystem<Plane>&, SubsystemData<Plane>&,
                                     SubsystemWork<Plane>&) noexcept;
template void calc_effective_inertia(const Subsystem<Space>&, SubsystemData<Space>&,
                                     SubsystemWork<Space>&) noexcept;

}  // namespace spoke::subsystem
