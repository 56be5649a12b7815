// Effective mass and force of a subsystem, (P 10), with D = Phi M^-1 Phi^T formed and factorised
// whole: docs/formulation.md, section 4.2.

#include <Eigen/Cholesky>

#include "engine/formulation/subsystem.h"
#include "engine/formulation/subsystem/root_jacobian.h"

namespace spoke::subsystem {
namespace {

constexpr int d = kTwist;

/// Takes the place of the matrix.
using Cholesky = Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>>;

/// (1) Fills D and the last column of `solution` with Phi M^-1 Q - gamma. Row k of Phi, of the
/// joint inboard of body k, has -J_i of this body and R^T J_o of its parent: D is
/// block-tridiagonal.
void assemble(const Subsystem& subsystem, const HubState& hub, const SubsystemData& data,
              SubsystemWork& work) {
  const int count = static_cast<int>(work.bodies.size());
  work.D.setZero();
  auto right = work.solution.col(d);
  for (int k = 0; k < count; ++k) {
    const BodyWork& child = work.bodies[k];
    work.D.block<d, d>(d * k, d * k) = child.products.topLeftCorner<d, d>();
    right.segment<d>(d * k) = -child.products.col(2 * d).head<d>();
    if (k == 0) continue;
    const TwistMatrix R = data.rotations[k].matrix();
    const BodyWork& parent = work.bodies[k - 1];
    work.D.block<d, d>(d * k, d * k) += R.transpose() * parent.products.block<d, d>(d, d) * R;
    work.D.block<d, d>(d * k, d * (k - 1)) = -R.transpose() * parent.products.block<d, d>(d, 0);
    work.D.block<d, d>(d * (k - 1), d * k) = work.D.block<d, d>(d * k, d * (k - 1)).transpose();
    right.segment<d>(d * k) +=
        R.transpose() * (parent.products.col(2 * d).tail<d>() + parent.bias_out);
  }
  const double w = hub.twist[kRotation];
  Twist bias = Twist::Zero();
  bias.head<kPosition>() = -w * w * subsystem.root.p;
  right.head<d>() += data.rotations[0].inverse() * bias;
}

}  // namespace

void calc_effective_inertia(const Subsystem& subsystem, SubsystemData& data,
                            SubsystemWork& work) noexcept {
  // (1) D = Phi M^-1 Phi^T and Phi M^-1 Q - gamma, joint by joint.
  assemble(subsystem, *data.hub, data, work);
  // (2) D^-1 of the root joint's rows and of Phi M^-1 Q - gamma. Phi_Y has rows at the root only.
  const Cholesky factor(work.D);
  work.solution.leftCols<d>().setZero();
  work.solution.topLeftCorner<d, d>().setIdentity();
  factor.solveInPlace(work.solution);

  // (3) M^C = Phi_Y^T D^-1 Phi_Y and Q^C = Phi_Y^T D^-1 (gamma - Phi M^-1 Q), Phi_Y = R_PB^T T.
  EffectiveInertia& effective = data.effective;
  const TwistMatrix Phi_Y = data.rotations[0].inverse().matrix() * root_jacobian(subsystem);
  effective.mass = Phi_Y.transpose() * work.solution.topLeftCorner<d, d>() * Phi_Y;
  effective.force = -Phi_Y.transpose() * work.solution.col(d).head<d>();
  // (4) The terms of geometric stiffening, for the hub's equation: qf^T KG qf and qf^T KG qf'.
  effective.centrifugal_inertia = effective.centrifugal_rate = 0.0;
  for (const BodyData& body : data.bodies) {
    effective.centrifugal_inertia += body.terms.centrifugal_inertia;
    effective.centrifugal_rate += body.terms.centrifugal_rate;
  }
}

}  // namespace spoke::subsystem
