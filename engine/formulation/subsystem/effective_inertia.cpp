// Effective mass and force of a subsystem, (P 10), with D = Phi M^-1 Phi^T formed and factorised
// whole: docs/formulation.md, section 4.2.

#include <Eigen/Cholesky>

#include "engine/formulation/subsystem.h"
#include "engine/formulation/subsystem/root_jacobian.h"
#include "engine/kernels/hub_motion.h"
#include "engine/kernels/hub_solve.h"

namespace spoke::subsystem {
namespace {

/// Takes the place of the matrix.
using Cholesky = Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>>;

/// (1) Fills D and the last column of `solution` with Phi M^-1 Q - gamma. Row k of Phi, of the
/// joint inboard of body k, has -J_i of this body and R^T J_o of its parent: D is
/// block-tridiagonal.
template <class World>
void assemble(const Subsystem<World>& subsystem, const SubsystemData<World>& data,
              SubsystemWork<World>& work) {
  constexpr int d = World::kTwist;
  Eigen::MatrixXd& D = work.D;
  D.setZero();
  auto right = Eigen::MatrixXd::ColXpr(work.solution.col(d));
  for (std::size_t j = 0; j < work.bodies.size(); ++j) {
    const int k = static_cast<int>(j);
    const Eigen::MatrixXd& child = work.bodies[j].products;
    D.block<d, d>(d * k, d * k) = child.topLeftCorner<d, d>();
    right.segment<d>(d * k) = -child.col(2 * d).head<d>();
    if (j == 0) continue;
    const TwistMatrixOf<World> R = data.joints[j].R.matrix();
    const Eigen::MatrixXd& parent = work.bodies[j - 1].products;
    D.block<d, d>(d * k, d * k) += R.transpose() * parent.block<d, d>(d, d) * R;
    D.block<d, d>(d * k, d * (k - 1)) = -R.transpose() * parent.block<d, d>(d, 0);
    D.block<d, d>(d * (k - 1), d * k) = D.block<d, d>(d * k, d * (k - 1)).transpose();
    right.segment<d>(d * k) +=
        R.transpose() * (parent.col(2 * d).tail<d>() + work.bodies[j - 1].bias_out);
  }
  right.head<d>() += data.joints[0].R.inverse() * make_root_joint(subsystem, data).bias;
}

}  // namespace

template <class World>
void calc_effective_inertia(const Subsystem<World>& subsystem, SubsystemData<World>& data,
                            SubsystemWork<World>& work) noexcept {
  constexpr int d = World::kTwist;
  // (1) D = Phi M^-1 Phi^T and Phi M^-1 Q - gamma, joint by joint.
  assemble(subsystem, data, work);
  // (2) D^-1 of the root joint's rows and of Phi M^-1 Q - gamma. Phi_Y has rows at the root only.
  const Cholesky factor(work.D);
  Eigen::MatrixXd& solution = work.solution;
  solution.leftCols<d>().setZero();
  solution.topLeftCorner<d, d>().setIdentity();
  factor.solveInPlace(solution);

  // (3) M^C = Phi_Y^T D^-1 Phi_Y and Q^C = Phi_Y^T D^-1 (gamma - Phi M^-1 Q), Phi_Y = R_PB^T T.
  EffectiveInertia<World>& effective = data.effective;
  const TwistMatrixOf<World> Phi_Y = data.joints[0].R.inverse().matrix() * root_jacobian(subsystem);
  effective.mass = Phi_Y.transpose() * solution.topLeftCorner<d, d>() * Phi_Y;
  effective.force = -Phi_Y.transpose() * solution.col(d).head<d>();
  // (4) The terms of geometric stiffening, for the hub's equation: qf^T KG qf and qf^T KG qf'.
  effective.stiffening = sum_stiffening(data.bodies);
}

template void calc_effective_inertia(const Subsystem<Plane>&, SubsystemData<Plane>&,
                                     SubsystemWork<Plane>&) noexcept;

}  // namespace spoke::subsystem
