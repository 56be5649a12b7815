// Recovery, docs/formulation.md, section 4.1: the wrenches of the joints, the multipliers of (P 8),
// from the roots to the tips, then the accelerations of every body on its own, (P 7).

#include "engine/formulation/structured/spatial_tree.h"
#include "engine/kernels/hub_motion.h"
#include "engine/support/wide_kernels.h"

namespace spoke::structured {
namespace {

Twist multiply_transposed(const HandleMap& X, const Twist& f) {
  return {X.xx * f[0], X.yy * f[1] + X.ry * f[2], X.xr * f[0] + X.yr * f[1] + X.rr * f[2]};
}

/// f = Pi (rhs - P_io^T F) on the outboard handle of body j and F(child) = -R_PB^T f; at the tip
/// f = 0.
void recover_children(const Subsystem<Plane>& subsystem, std::size_t j,
                      const SubsystemWork<Plane>& work, SubsystemData<Plane>& data) {
  PlanarWrenches& wrenches = data.wrenches[j];
  wrenches.outboard.setZero();
  if (subsystem.bodies[j].children.empty()) return;
  const TwoPort& port = work.bodies[j].port;
  const tree::JointElimination<Plane>& elimination = work.bodies[j + 1].joint;
  const PlanarJointMotion& joint = data.joints[j + 1];
  wrenches.outboard = tree::recover_joint(
      joint, elimination,
      Twist(elimination.rhs - port.P_io.transpose().lazyProduct(wrenches.inboard)));
  data.wrenches[j + 1].inboard = tree::pass_to_child<Plane>(joint, wrenches.outboard);
}

}  // namespace

template <class World>
void recover_wrenches(const Subsystem<World>& subsystem, const SubsystemWork<World>& work,
                      SubsystemData<World>& data) noexcept {
  // (1) At the roots F = Lam^-1 (R_PB^T (T Y'' + b) - be).
  for (std::size_t k = 0; k < work.roots.size(); ++k) {
    const auto j = static_cast<std::size_t>(work.root_bodies[k]);
    const auto root = joint_of(subsystem, data, j);
    data.wrenches[j].inboard = tree::recover_root(
        root, work.roots[k], calc_root_acceleration<World>(root, *data.hub_acceleration),
        joint_accelerations(data.bodies[j]));
  }
  // (2) From body to body.
  for (std::size_t j = 0; j < work.bodies.size(); ++j) recover_children(subsystem, j, work, data);
}

template void recover_wrenches(const Subsystem<Plane>&, const SubsystemWork<Plane>&,
                               SubsystemData<Plane>&) noexcept;
template void recover_wrenches(const Subsystem<Space>&, const SubsystemWork<Space>&,
                               SubsystemData<Space>&) noexcept;

namespace {

void recover(const SubsystemData<Plane>& subsystem, std::size_t j, const BodyWork<Plane>& work,
             bool implicit, BodyData<Plane>& data, double* a) {
  const PlanarWrenches& wrenches = subsystem.wrenches[j];
  // (3) X = S_R^-1 (p + X_i^T F + X_o^T f).
  const FlexibleBody& body = *data.model->body;
  const ElasticBlock& block = *data.blocks[implicit];
  const TwoPort& port = work.port;
  const Twist& F = wrenches.inboard;
  const Twist X_i_F(F[0] + port.x_i[0] * F[2], F[1] + port.x_i[1] * F[2], port.x_i[2] * F[2]);
  const Twist X =
      port.S_inverse * Twist(port.p + X_i_F + multiply_transposed(port.X_o, wrenches.outboard));
  data.X = X;
  // (4) qf'' = z - W X + Z_i F + Z_o f, axial part, then bending part. Of the columns of Z_i and
  // Z_o the axial part has one, the bending part two.
  const auto wrench_of = [&](const ElasticBlock::BendingColumn& column) {
    return (column.outboard ? wrenches.outboard : wrenches.inboard)[column.component];
  };
  const double alpha = X[kRotation];
  const double f_x = wrenches.outboard[0];
  const double f_0 = wrench_of(block.columns[0]);
  const double f_1 = wrench_of(block.columns[1]);
  const int u = data.layout.u();
  const double *W = work.W_theta + u, *z = work.z + u;
  const double *W_x = block.W_x.data(), *Z = block.Z_axial.data();
  double* a_u = a + u;
  const double X_x = X[0], X_y = X[1];
  for (int i = 0, n = body.axial(); i < n; i += 2)
    store_aligned(load_aligned(z + i) - alpha * load_aligned(W + i) - X_x * load_aligned(W_x + i) +
                      f_x * load_aligned(Z + i),
                  a_u + i);
  const int v = data.layout.v();
  W = work.W_theta + v;
  z = work.z + v;
  const double* W_y = block.W_y.data();
  const double *Z_0 = block.columns[0].Z.data(), *Z_1 = block.columns[1].Z.data();
  double* a_v = a + v;
  for (int i = 0, n = body.bending(); i < n; i += 2)
    store_aligned(load_aligned(z + i) - alpha * load_aligned(W + i) - X_y * load_aligned(W_y + i) +
                      f_0 * load_aligned(Z_0 + i) + f_1 * load_aligned(Z_1 + i),
                  a_v + i);
}

}  // namespace

void recover_body(const SubsystemData<Plane>& subsystem, std::size_t j, const BodyWork<Plane>& work,
                  bool implicit, BodyData<Plane>& data, double* a) noexcept {
  run_kernel([&]() noexcept { recover(subsystem, j, work, implicit, data, a); });
}

}  // namespace spoke::structured
