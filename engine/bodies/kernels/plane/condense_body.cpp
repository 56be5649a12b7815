// Condenses a body, (P 11) without an inverse: docs/formulation.md, section 4.1. The numbers (1) to
// (3) mark the steps of the derivation in structured.h and there.

#include <cassert>

#include "engine/bodies/kernels/plane/handle_motion.h"
#include "engine/bodies/kernels/structured_body.h"
#include "models/support/wide_kernels.h"

namespace spoke::structured {
namespace {

/// (2) Products of one part, axial or bending, of S and c_theta with both solutions: its share of C
/// W and C z.
struct PartProducts {
  double S_W, S_z;  // S . W_theta, S . z
  double c_W, c_z;  // c_theta . W_theta, c_theta . z
};

PartProducts sum_part(const double* S, const double* c, const double* W, const double* z, int n) {
  Double2 S_W{}, S_z{}, c_W{}, c_z{};
  for (int i = 0; i < n; i += 2) {
    const Double2 W_i = load_aligned(W + i), z_i = load_aligned(z + i);
    S_W += load_aligned(S + i) * W_i;
    S_z += load_aligned(S + i) * z_i;
    c_W += load_aligned(c + i) * W_i;
    c_z += load_aligned(c + i) * z_i;
  }
  return {total(S_W), total(S_z), total(c_W), total(c_z)};
}

/// (3) Calculates the handle maps X_h = J_R,h - E_h W. Only the last row of the inboard one differs
/// from the identity's.
void calc_handle_maps(const plane::ElasticBlock& block, const BodyData<Plane>& data,
                      const BodyWork<Plane>& work, plane::HandleMap& X_o, Twist& x_i) {
  const Position s = calc_outboard_position(data);
  const double* W_theta = work.W_theta;
  const int u = data.layout.u() + block.axial_coordinate;
  X_o.xx = 1.0 - block.W_x[block.axial_coordinate];
  X_o.xr = -s.y() - W_theta[u];
  X_o.yy = 1.0;
  X_o.yr = s.x();
  X_o.ry = 0.0;
  X_o.rr = 1.0;
  X_o.xy = X_o.yx = X_o.rx = 0.0;
  x_i = Twist::Unit(kRotation);
  for (const plane::ElasticBlock::BendingColumn& column : block.columns) {
    const double W_y = block.W_y[column.coordinate];
    const double W_w = W_theta[data.layout.v() + column.coordinate];
    if (!column.outboard) {
      x_i[1] -= W_y;
      x_i[kRotation] -= W_w;
    } else if (column.component == kRotation) {
      X_o.ry -= W_y;
      X_o.rr -= W_w;
    } else {
      X_o.yy -= W_y;
      X_o.yr -= W_w;
    }
  }
}

/// (3) Returns b_o + E_o z = -w^2 s + 2 w B s' + E_o z: acceleration of the outboard handle at X =
/// 0, without wrenches.
Twist calc_outboard_bias(const BodyData<Plane>& data, double speed, const BodyWork<Plane>& work) {
  const Position s = calc_outboard_position(data);
  const Position s_rate = calc_outboard_velocity(data);
  // z is zero at the places of coordinates that the frame fixes.
  return {-speed * speed * s.x() - 2.0 * speed * s_rate.y() + work.z[data.outboard_at[0]],
          -speed * speed * s.y() + 2.0 * speed * s_rate.x() + work.z[data.outboard_at[1]],
          work.z[data.outboard_at[kRotation]]};
}

Twist multiply(const plane::HandleMap& X, const Twist& v) {
  return {X.xx * v[0] + X.xr * v[2], X.yy * v[1] + X.yr * v[2], X.ry * v[1] + X.rr * v[2]};
}

/// (3) Calculates P_io = S_R^-1 X_o^T and P_oo = Z_oo + X_o S_R^-1 X_o^T.
void calc_compliances(const plane::SymmetricTwistMatrix& S, const plane::HandleMap& X,
                      const plane::SymmetricTwistMatrix& Z_oo, plane::TwoPort& port) {
  const double p00 = X.xx * S.xx + X.xr * S.rx;
  const double p10 = X.xx * S.yx + X.xr * S.ry;
  const double p20 = X.xx * S.rx + X.xr * S.rr;
  const double p01 = X.yy * S.yx + X.yr * S.rx;
  const double p11 = X.yy * S.yy + X.yr * S.ry;
  const double p21 = X.yy * S.ry + X.yr * S.rr;
  const double p02 = X.ry * S.yx + X.rr * S.rx;
  const double p12 = X.ry * S.yy + X.rr * S.ry;
  const double p22 = X.ry * S.ry + X.rr * S.rr;
  port.P_io << p00, p01, p02, p10, p11, p12, p20, p21, p22;
  port.P_oo = {Z_oo.xx + X.xx * p00 + X.xr * p20, Z_oo.yx + X.yy * p10 + X.yr * p20,
               Z_oo.yy + X.yy * p11 + X.yr * p21, Z_oo.rx + X.ry * p10 + X.rr * p20,
               Z_oo.ry + X.ry * p11 + X.rr * p21, Z_oo.rr + X.ry * p12 + X.rr * p22};
}

/// (3) Adds the rotation of a chord frame's inboard handle against it: the last row of X_i and its
/// consequences.
void add_inboard_rotation(double Z_ii, const Twist& Z_io, double bias, const Twist& X_free,
                          plane::TwoPort& port) {
  const Twist& x = port.x_i;
  const Twist S_x = port.S_inverse * x;
  port.P_ii.rx = S_x[0];
  port.P_ii.ry = S_x[1];
  port.P_ii.rr = x.dot(S_x) + Z_ii;
  for (int c = 0; c < kTwist; ++c)
    port.P_io(kRotation, c) =
        x[0] * port.P_io(0, c) + x[1] * port.P_io(1, c) + x[2] * port.P_io(2, c) + Z_io[c];
  port.free_i[kRotation] = x.dot(X_free) + bias;
}

void condense(const BodyData<Plane>& data, const Twist& twist, bool implicit,
              BodyWork<Plane>& work) {
  assert(data.blocks[implicit]);
  assert(data.blocks[implicit]->axial.size() == data.layout.axial);
  assert(data.blocks[implicit]->bending.size() == data.layout.bending);
  const plane::FlexibleBody& body = *data.model->body;
  const plane::ElasticBlock& block = *data.blocks[implicit];
  const int u = data.layout.u();
  const int v = data.layout.v();
  const double* c = data.c_theta;
  double* W = work.W_theta;
  // (1) W_w = Mhat^-1 c and z = Mhat^-1 Q_f follow in one sweep over the factors of each part. W_x
  // and W_y are constants of the block.
  plane::solve_together({&block.axial, c + u, data.Q_f + u, W + u, work.z + u},
                        {&block.bending, c + v, data.Q_f + v, W + v, work.z + v}, work.scratch);
  // (2) S_R = M_RR - C W and p = Q_R - C z follow. C has the rows S_x, S_y and c^T.
  const PartProducts axial = sum_part(body.S_axial.data(), c + u, W + u, work.z + u, body.axial());
  const PartProducts bending =
      sum_part(body.S_bending.data(), c + v, W + v, work.z + v, body.bending());

  const plane::Terms& terms = data.terms;
  const plane::SymmetricTwistMatrix S_R{
      body.mass - block.S_Wx,    0.0,
      body.mass - block.S_Wy,    -terms.S.y() - axial.S_W,
      terms.S.x() - bending.S_W, terms.rotary_inertia - axial.c_W - bending.c_W};
  const plane::SymmetricTwistMatrix S_inverse = invert(S_R);
  const Twist p = terms.Q - Twist(axial.S_z, bending.S_z, axial.c_z + bending.c_z);
  const Twist X_free = S_inverse * p;
  // (3) The two-port follows: X_h = J_R,h - E_h W, P_ab = Z_ab + X_a S_R^-1 X_b^T and a_h = b_h +
  // E_h z + X_h S_R^-1 p. A clamped frame has X_i = I and Z_i = 0.
  plane::TwoPort& port = work.port;
  port.S_inverse = port.P_ii = S_inverse;
  port.p = p;
  port.free_i = X_free;
  calc_handle_maps(block, data, work, port.X_o, port.x_i);
  calc_compliances(S_inverse, port.X_o, block.Z_oo, port);
  port.free_o = multiply(port.X_o, X_free) + calc_outboard_bias(data, twist[kRotation], work);
  if (body.reference_frame == ReferenceFrame::chord)
    add_inboard_rotation(block.Z_ii, block.Z_io, work.z[data.inboard_at[kRotation]], X_free, port);
}

/// Products of both solutions of a pass with c_theta and the first moments S.
struct CoupledProducts {
  Double2 S_W{}, S_z{};
  double c_W = 0.0, c_z = 0.0;
};

/// (1), (2) of a body whose axial and bending responses are coupled.
CoupledProducts solve_coupled(const BodyData<Plane>& data, BodyWork<Plane>& work) {
  const plane::ImplicitStrain& strain = *data.strain;
  const int n = strain.factor.size();
  Double2* const x = work.scratch;
  for (int i = 0, at = 0; i < n; ++i) {
    at = strain.factor.at(i);
    x[i] = Double2{data.c_theta[at], data.Q_f[at]};
  }
  strain.factor.solve(x);
  CoupledProducts sums;
  for (int i = 0; i < n; ++i) {
    const int at = strain.factor.at(i);
    const Double2 S = strain.S[static_cast<std::size_t>(i)];
    sums.S_W += S * x[i][0];
    sums.S_z += S * x[i][1];
    sums.c_W += data.c_theta[at] * x[i][0];
    sums.c_z += data.c_theta[at] * x[i][1];
    work.W_theta[at] = x[i][0];
    work.z[at] = x[i][1];
  }
  return sums;
}

/// The rows of W and Z at a handle's coordinate; zero if the frame fixes it. Z: of the outboard
/// wrench, and of the moment on the inboard handle.
struct CoupledRow {
  Twist W = Twist::Zero(), Z = Twist::Zero();
  double Z_inboard = 0.0;
};

CoupledRow row_at(const BodyData<Plane>& data, const plane::Handle& handle, int component,
                  const BodyWork<Plane>& work) {
  const plane::FlexibleBody& body = *data.model->body;
  const int place = place_by_node(body, handle.node, component);
  if (place < 0) return {};
  const auto& [W, Z_linear, Z_angular] = data.strain->columns;
  const auto i = static_cast<std::size_t>(place);
  return {{W[i][0], W[i][1], work.W_theta[data.strain->factor.at(place)]},
          {Z_linear[i][0], Z_linear[i][1], Z_angular[i][0]},
          Z_angular[i][1]};
}

/// Condenses a body whose axial and bending responses are coupled, by full matrices.
void condense_coupled(const BodyData<Plane>& data, const Twist& twist, BodyWork<Plane>& work) {
  const plane::FlexibleBody& body = *data.model->body;
  const plane::Terms& terms = data.terms;
  const CoupledProducts sums = solve_coupled(data, work);
  const plane::SymmetricTwistMatrix& S_W = data.strain->S_W;
  plane::TwoPort& port = work.port;
  port.S_inverse = port.P_ii = invert(plane::SymmetricTwistMatrix{
      body.mass - S_W.xx, -S_W.yx, body.mass - S_W.yy, -terms.S.y() - sums.S_W[0],
      terms.S.x() - sums.S_W[1], terms.rotary_inertia - sums.c_W});
  port.p = terms.Q - Twist(sums.S_z[0], sums.S_z[1], sums.c_z);
  const Twist X_free = port.S_inverse * port.p;
  port.free_i = X_free;
  const Position s = calc_outboard_position(data);
  TwistMatrix X_o, Z_oo;
  X_o << 1.0, 0.0, -s.y(), 0.0, 1.0, s.x(), 0.0, 0.0, 1.0;
  for (int c = 0; c < kTwist; ++c) {
    const CoupledRow row = row_at(data, body.outboard, c, work);
    X_o.row(c) -= row.W.transpose();
    Z_oo.row(c) = row.Z.transpose();
  }
  port.X_o = {X_o(0, 0), X_o(0, 2), X_o(1, 1), X_o(1, 2), X_o(2, 1),
              X_o(2, 2), X_o(0, 1), X_o(1, 0), X_o(2, 0)};
  port.P_io = port.S_inverse.matrix().lazyProduct(X_o.transpose());
  const TwistMatrix P_oo = Z_oo + X_o.lazyProduct(port.P_io);
  port.P_oo = {P_oo(0, 0), P_oo(1, 0), P_oo(1, 1), P_oo(2, 0), P_oo(2, 1), P_oo(2, 2)};
  port.free_o = X_o.lazyProduct(X_free) + calc_outboard_bias(data, twist[kRotation], work);
  const CoupledRow inboard = row_at(data, body.inboard, kRotation, work);
  port.x_i = Twist::Unit(kRotation) - inboard.W;
  if (body.reference_frame == ReferenceFrame::chord)
    add_inboard_rotation(inboard.Z_inboard, inboard.Z, work.z[data.inboard_at[kRotation]], X_free,
                         port);
}

}  // namespace

void condense_body(const BodyData<Plane>& data, const Twist& twist, bool implicit,
                   BodyWork<Plane>& work) noexcept {
  if (implicit && data.strain) return condense_coupled(data, twist, work);
  run_kernel([&]() noexcept { condense(data, twist, implicit, work); });
}

}  // namespace spoke::structured
