#include "engine/formulation/structured.h"

#include <utility>

#include "engine/hub.h"
#include "engine/kinematics.h"

namespace spoke::structured {
namespace {

/// Products of one part of S and c_theta with both solutions.
struct PartProducts {
  double S_W, S_z;  // S . W_theta, S . z
  double c_W, c_z;  // c_theta . W_theta, c_theta . z
};

PartProducts sum_part(const double* S, const double* c, const double* W, const double* z, int n) {
  Pair S_W{}, S_z{}, c_W{}, c_z{};
  for (int i = 0; i < n; i += 2) {
    const Pair W_i = load_aligned(W + i), z_i = load_aligned(z + i);
    S_W += load_aligned(S + i) * W_i;
    S_z += load_aligned(S + i) * z_i;
    c_W += load_aligned(c + i) * W_i;
    c_z += load_aligned(c + i) * z_i;
  }
  return {total(S_W), total(S_z), total(c_W), total(c_z)};
}

/// Handle maps X_e = J_e - E_e W.
void calc_handle_maps(const ElasticBlock& block, const BodyData& data, const BodyWork& work,
                      HandleMap& X_o, Twist& x_i) {
  const Position s = calc_outboard_position(data);
  const int u = data.layout.u() + block.axial_coordinate;
  X_o.xx = 1.0 - block.W_x[block.axial_coordinate];
  X_o.xr = -s.y() - work.W_theta[u];
  X_o.yy = 1.0;
  X_o.yr = s.x();
  X_o.ry = 0.0;
  X_o.rr = 1.0;
  x_i = Twist::Unit(kRotation);
  for (const ElasticBlock::BendingColumn& column : block.columns) {
    const double W_y = block.W_y[column.coordinate];
    const double W_theta = work.W_theta[data.layout.v() + column.coordinate];
    if (!column.outboard) {
      x_i[1] -= W_y;
      x_i[kRotation] -= W_theta;
    } else if (column.component == kRotation) {
      X_o.ry -= W_y;
      X_o.rr -= W_theta;
    } else {
      X_o.yy -= W_y;
      X_o.yr -= W_theta;
    }
  }
}

/// Acceleration of the outboard handle at X = 0, without wrenches.
Twist calc_outboard_bias(const BodyData& data, double speed, const BodyWork& work) {
  const Position s = calc_outboard_position(data);
  const Position s_rate = calc_outboard_velocity(data);
  // z is zero at the places of coordinates that the frame fixes.
  return {-speed * speed * s.x() - 2.0 * speed * s_rate.y() + work.z[data.outboard_at[0]],
          -speed * speed * s.y() + 2.0 * speed * s_rate.x() + work.z[data.outboard_at[1]],
          work.z[data.outboard_at[kRotation]]};
}

Twist multiply(const HandleMap& X, const Twist& v) {
  return {X.xx * v[0] + X.xr * v[2], X.yy * v[1] + X.yr * v[2], X.ry * v[1] + X.rr * v[2]};
}
Twist multiply_transposed(const HandleMap& X, const Twist& f) {
  return {X.xx * f[0], X.yy * f[1] + X.ry * f[2], X.xr * f[0] + X.yr * f[1] + X.rr * f[2]};
}

/// P_io = S_R^-1 X_o^T and P_oo = Z_oo + X_o S_R^-1 X_o^T.
void calc_compliances(const SymmetricTwistMatrix& S, const HandleMap& X,
                      const SymmetricTwistMatrix& Z_oo, TwoPort& port) {
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

/// The two-port of a chord frame: its inboard handle may turn against it.
void turn_inboard(const ElasticBlock& block, double bias, const Twist& X_free, TwoPort& port) {
  const Twist& x = port.x_i;
  const Twist S_x = port.S_inverse * x;
  port.P_ii.rx = S_x[0];
  port.P_ii.ry = S_x[1];
  port.P_ii.rr = x.dot(S_x) + block.Z_ii;
  for (int c = 0; c < kTwist; ++c)
    port.P_io(kRotation, c) =
        x[0] * port.P_io(0, c) + x[1] * port.P_io(1, c) + x[2] * port.P_io(2, c) + block.Z_io[c];
  port.free_i[kRotation] = x.dot(X_free) + bias;
}

}  // namespace

void allocate(const SubsystemData& data, SubsystemWork& work) {
  Arena& arena = *data.arena;
  work.bodies = ArenaVector<BodyWork>(data.bodies.size(), arena);
  std::size_t flex_total = 0;
  std::size_t scratch_total = 0;
  for (const BodyData& body : data.bodies) {
    flex_total += static_cast<std::size_t>(2 * body.layout.size());
    scratch_total += body.layout.axial + body.layout.bending;
  }
  work.storage = ArenaVector<double>(flex_total, 0.0, arena);
  work.scratch = ArenaVector<Pair>(scratch_total, Pair{}, arena);
  double* next = work.storage.data();
  Pair* next_scratch = work.scratch.data();
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    const FlexLayout& layout = data.bodies[j].layout;
    work.bodies[j].W_theta = std::exchange(next, next + layout.size());
    work.bodies[j].z = std::exchange(next, next + layout.size());
    work.bodies[j].scratch =
        std::exchange(next_scratch, next_scratch + layout.axial + layout.bending);
  }
}

void condense_body(const BodyData& data, double speed, bool implicit, BodyWork& work) noexcept {
  const FlexibleBody& body = *data.model->body;
  const ElasticBlock& block = *data.blocks[implicit];
  const int u = data.layout.u();
  const int v = data.layout.v();
  solve_together({&block.axial, data.c_theta + u, data.Q_f + u, work.W_theta + u, work.z + u},
                 {&block.bending, data.c_theta + v, data.Q_f + v, work.W_theta + v, work.z + v},
                 work.scratch);
  const PartProducts axial =
      sum_part(body.S_axial.data(), data.c_theta + u, work.W_theta + u, work.z + u, body.axial());
  const PartProducts bending = sum_part(body.S_bending.data(), data.c_theta + v, work.W_theta + v,
                                        work.z + v, body.bending());

  const BodyTerms& terms = data.terms;
  const SymmetricTwistMatrix S_R{
      body.mass - block.S_Wx,    0.0,
      body.mass - block.S_Wy,    -terms.S.y() - axial.S_W,
      terms.S.x() - bending.S_W, terms.rotary_inertia - axial.c_W - bending.c_W};
  const SymmetricTwistMatrix S_inverse = invert(S_R);
  const Twist p = terms.Q - Twist(axial.S_z, bending.S_z, axial.c_z + bending.c_z);
  const Twist X_free = S_inverse * p;
  TwoPort& port = work.port;
  port.S_inverse = port.P_ii = S_inverse;
  port.p = p;
  port.free_i = X_free;
  calc_handle_maps(block, data, work, port.X_o, port.x_i);
  calc_compliances(S_inverse, port.X_o, block.Z_oo, port);
  port.free_o = multiply(port.X_o, X_free) + calc_outboard_bias(data, speed, work);
  if (body.reference_frame == ReferenceFrame::chord)
    turn_inboard(block, work.z[data.inboard_at[kRotation]], X_free, port);
}

void condense_subsystem(const Subsystem& subsystem, SubsystemData& data,
                        SubsystemWork& work) noexcept {
  const std::size_t count = work.bodies.size();
  SymmetricTwistMatrix Lambda =
      work.bodies[count - 1].port.P_ii;             // compliance of what hangs at a joint
  Twist free = work.bodies[count - 1].port.free_i;  // its acceleration without wrench
  for (std::size_t j = count - 1; j-- > 0;) {
    const TwoPort& port = work.bodies[j].port;
    JointElimination& joint = work.bodies[j].joint;
    const Rotation& R = data.rotations[j + 1];
    const SymmetricTwistMatrix Pi = invert(port.P_oo + turn(R, Lambda));
    const Twist rhs = R * free - port.free_o;
    const Twist f = Pi * rhs;  // the joint's wrench if F = 0
    Lambda = eliminate(port.P_ii, port.P_io, Pi);
    free = port.free_i + port.P_io.lazyProduct(f);
    joint.Pi = Pi;
    joint.rhs = rhs;
  }

  EffectiveInertia& effective = data.effective;
  work.root = {invert(Lambda), free};
  // The bracket's acceleration is T Y'' - w^2 p in the hub frame; R leads there from the first
  // body's.
  const Rotation& R = data.rotations[0];
  const Position& p = subsystem.root.p;
  const SymmetricTwistMatrix mass = turn(R, work.root.mass);
  const double ww = data.hub->twist[kRotation] * data.hub->twist[kRotation];
  const Twist bias(-ww * p.x(), -ww * p.y(), 0.0);
  effective.mass = shift(p, mass).matrix();
  effective.force = shift(p, mass * Twist(R * free - bias));
  effective.centrifugal_inertia = effective.centrifugal_rate = 0.0;
  for (const BodyData& body : data.bodies) {
    effective.centrifugal_inertia += body.terms.centrifugal_inertia;
    effective.centrifugal_rate += body.terms.centrifugal_rate;
  }
}

void recover_wrenches(const Subsystem& subsystem, const SubsystemWork& work,
                      SubsystemData& data) noexcept {
  const Twist root =
      calc_root_acceleration(subsystem, *data.hub, *data.hub_acceleration, data.rotations[0]);
  Twist F = work.root.mass * (root - work.root.free);
  const std::size_t count = work.bodies.size();
  for (std::size_t j = 0; j < count; ++j) {
    HandleWrenches& wrenches = data.wrenches[j];
    wrenches.inboard = F;
    wrenches.outboard.setZero();
    if (j + 1 == count) break;
    const BodyWork& body = work.bodies[j];
    wrenches.outboard =
        body.joint.Pi * Twist(body.joint.rhs - body.port.P_io.transpose().lazyProduct(F));
    F = -(data.rotations[j + 1].inverse() * wrenches.outboard);
  }
}

void recover_body(const HandleWrenches& wrenches, const BodyWork& work, bool implicit,
                  BodyData& data, double* a) noexcept {
  const FlexibleBody& body = *data.model->body;
  const ElasticBlock& block = *data.blocks[implicit];
  const TwoPort& port = work.port;
  const Twist& F = wrenches.inboard;
  const Twist X_i_F(F[0] + port.x_i[0] * F[2], F[1] + port.x_i[1] * F[2], port.x_i[2] * F[2]);
  const Twist X =
      port.S_inverse * Twist(port.p + X_i_F + multiply_transposed(port.X_o, wrenches.outboard));
  data.X = X;
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
    store(load_aligned(z + i) - alpha * load_aligned(W + i) - X_x * load_aligned(W_x + i) +
              f_x * load_aligned(Z + i),
          a_u + i);
  const int v = data.layout.v();
  W = work.W_theta + v;
  z = work.z + v;
  const double* W_y = block.W_y.data();
  const double *Z_0 = block.columns[0].Z.data(), *Z_1 = block.columns[1].Z.data();
  double* a_v = a + v;
  for (int i = 0, n = body.bending(); i < n; i += 2)
    store(load_aligned(z + i) - alpha * load_aligned(W + i) - X_y * load_aligned(W_y + i) +
              f_0 * load_aligned(Z_0 + i) + f_1 * load_aligned(Z_1 + i),
          a_v + i);
}

}  // namespace spoke::structured
