// Recovers the accelerations of a body on its own, (P 7): docs/formulation.md, section 4.1. The
// numbers (3) and (4) mark the steps of the derivation in structured.h and there.

#include <cassert>

#include "engine/bodies/kernels/structured_body.h"
#include "models/support/wide_kernels.h"

namespace spoke::structured {
namespace {

Twist multiply_transposed(const plane::HandleMap& X, const Twist& f) {
  return {X.xx * f[0], X.yy * f[1] + X.ry * f[2], X.xr * f[0] + X.yr * f[1] + X.rr * f[2]};
}

void recover(const SubsystemData<Plane>& subsystem, std::size_t j, const BodyWork<Plane>& work,
             bool implicit, BodyData<Plane>& data, double* a) {
  assert(j < subsystem.wrenches.size() && a && data.blocks[implicit]);
  const plane::Wrenches& wrenches = subsystem.wrenches[j];
  // (3) X = S_R^-1 (p + X_i^T F + X_o^T f).
  const plane::FlexibleBody& body = *data.model->body;
  const plane::ElasticBlock& block = *data.blocks[implicit];
  const plane::TwoPort& port = work.port;
  const Twist& F = wrenches.inboard;
  const Twist X_i_F(F[0] + port.x_i[0] * F[2], F[1] + port.x_i[1] * F[2], port.x_i[2] * F[2]);
  const Twist X =
      port.S_inverse * Twist(port.p + X_i_F + multiply_transposed(port.X_o, wrenches.outboard));
  data.X = X;
  // (4) qf'' = z - W X + Z_i F + Z_o f, axial part, then bending part. The axial part has one of
  // the columns of Z_i and Z_o, the bending part two.
  const auto wrench_of = [&](const plane::ElasticBlock::BendingColumn& column) {
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

/// Recovers a body whose axial and bending responses are coupled.
void recover_coupled(const plane::Wrenches& wrenches, const BodyWork<Plane>& work,
                     BodyData<Plane>& data, double* a) {
  const plane::TwoPort& port = work.port;
  const Twist &F = wrenches.inboard, &f = wrenches.outboard;
  const Twist X_i_F = Twist(F[0], F[1], 0.0) + port.x_i * F[kRotation];
  const Twist X =
      port.S_inverse * Twist(port.p + X_i_F + port.X_o.matrix().transpose().lazyProduct(f));
  data.X = X;
  const auto& [W, Z_linear, Z_angular] = data.strain->columns;
  for (std::size_t i = 0; i < W.size(); ++i) {
    const int at = data.strain->factor.at(static_cast<int>(i));
    a[at] = work.z[at] - X[kRotation] * work.W_theta[at] +
            total(Z_linear[i] * Double2{f[0], f[1]} + Z_angular[i] * Double2{f[2], F[2]} -
                  W[i] * Double2{X[0], X[1]});
  }
}

}  // namespace

void recover_body(const SubsystemData<Plane>& subsystem, std::size_t j, const BodyWork<Plane>& work,
                  bool implicit, BodyData<Plane>& data, double* a) noexcept {
  if (implicit && data.strain) return recover_coupled(subsystem.wrenches[j], work, data, a);
  run_kernel([&]() noexcept { recover(subsystem, j, work, implicit, data, a); });
}

}  // namespace spoke::structured
