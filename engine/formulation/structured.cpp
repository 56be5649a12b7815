#include "engine/formulation/structured.h"

#include <utility>

#include "engine/hub.h"
#include "engine/kinematics.h"

namespace spoke::structured {
namespace {

/// Products of one part of S and c_theta with both solutions.
struct PartProducts {
  LaneSum S_W, S_z;  // S . W_theta, S . z
  LaneSum c_W, c_z;  // c_theta . W_theta, c_theta . z
};

PartProducts sum_part(const double* S, const double* c, const double* W, const double* z, int n) {
  PartProducts sums;
  for_each_lane(n, [&]<class Lane>(int i) {
    const Lane S_i = load<Lane>(S + i);
    const Lane c_i = load<Lane>(c + i);
    const Lane W_i = load<Lane>(W + i);
    const Lane z_i = load<Lane>(z + i);
    sums.S_W += S_i * W_i;
    sums.S_z += S_i * z_i;
    sums.c_W += c_i * W_i;
    sums.c_z += c_i * z_i;
  });
  return sums;
}

/// X_e = J_e - E_e W without deformation: [I, B s; 0, 1].
TwistMatrix rigid_handle(const Position& s) {
  TwistMatrix X = TwistMatrix::Identity();
  X.col(kRotation).head<kPosition>() = quarter_turn(s);
  return X;
}

/// Handle maps X_e and accelerations at X = 0 without wrenches.
void calc_handles(const FlexibleBody& body, const ElasticBlock& block, const BodyData& data,
                  double speed, const BodyWork& work, TwoPort& port, Twist& bias_i, Twist& bias_o) {
  const Position s = calc_handle_position(body.outboard, data.coordinates.q, data.layout);
  const Position s_rate = calc_handle_velocity(body.outboard, data.coordinates.v, data.layout);
  port.X_i = TwistMatrix::Identity();
  port.X_o = rigid_handle(s);
  bias_i.setZero();
  bias_o.setZero();
  bias_o.head<kPosition>() = -speed * speed * s + 2.0 * speed * quarter_turn(s_rate);

  const int u = data.layout.u() + block.axial_coordinate;
  port.X_o(0, 0) -= block.W_x[block.axial_coordinate];
  port.X_o(0, kRotation) -= work.W_theta[u];
  bias_o[0] += work.z[u];
  for (const ElasticBlock::BendingColumn& column : block.columns) {
    const int v = data.layout.v() + column.coordinate;
    TwistMatrix& X = column.outboard ? port.X_o : port.X_i;
    Twist& bias = column.outboard ? bias_o : bias_i;
    X(column.component, 1) -= block.W_y[column.coordinate];
    X(column.component, kRotation) -= work.W_theta[v];
    bias[column.component] += work.z[v];
  }
}

}  // namespace

void allocate(const SubsystemData& data, SubsystemWork& work) {
  work.bodies.resize(data.bodies.size());
  Eigen::Index flex_total = 0;
  std::size_t scratch_total = 0;
  for (const BodyData& body : data.bodies) {
    flex_total += 2 * body.layout.size();
    scratch_total += body.layout.bending;
  }
  work.storage = Eigen::VectorXd::Zero(flex_total);
  work.scratch.assign(scratch_total, Pair::Zero());
  double* next = work.storage.data();
  Pair* next_scratch = work.scratch.data();
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    const FlexLayout& layout = data.bodies[j].layout;
    work.bodies[j].W_theta = std::exchange(next, next + layout.size());
    work.bodies[j].z = std::exchange(next, next + layout.size());
    work.bodies[j].scratch = std::exchange(next_scratch, next_scratch + layout.bending);
  }
}

void condense_body(const BodyData& data, double speed, const PassControl& control,
                   BodyWork& work) noexcept {
  const FlexibleBody& body = *data.model->body;
  const ElasticBlock& block = *data.blocks[control.implicit];
  const int u = data.layout.u();
  const int v = data.layout.v();
  block.axial.solve(data.c_theta + u, data.Q_f + u, work.scratch, work.W_theta + u, work.z + u);
  block.bending.solve(data.c_theta + v, data.Q_f + v, work.scratch, work.W_theta + v, work.z + v);
  const PartProducts axial = sum_part(body.S_axial.data(), data.c_theta + u, work.W_theta + u,
                                      work.z + u, body.axial());
  const PartProducts bending = sum_part(body.S_bending.data(), data.c_theta + v, work.W_theta + v,
                                        work.z + v, body.bending());

  const BodyTerms& terms = data.terms;
  TwistMatrix S_R;  // its lower triangle
  S_R(0, 0) = body.mass - block.S_Wx;
  S_R(1, 0) = 0.0;
  S_R(1, 1) = body.mass - block.S_Wy;
  S_R(2, 0) = -terms.S.y() - axial.S_W.total();
  S_R(2, 1) = terms.S.x() - bending.S_W.total();
  S_R(2, 2) = terms.rotary_inertia - axial.c_W.total() - bending.c_W.total();
  TwoPort& port = work.port;
  port.S_inverse = invert_symmetric(S_R);
  port.p = terms.Q - Twist(axial.S_z.total(), bending.S_z.total(),
                            axial.c_z.total() + bending.c_z.total());

  Twist bias_i, bias_o;
  calc_handles(body, block, data, speed, work, port, bias_i, bias_o);
  const Twist X_free = port.S_inverse.lazyProduct(port.p);
  const TwistMatrix S_X_o = port.S_inverse.lazyProduct(port.X_o.transpose());
  port.P_oo = block.Z_oo + port.X_o.lazyProduct(S_X_o);
  port.free_o = port.X_o.lazyProduct(X_free) + bias_o;
  if (body.reference_frame == ReferenceFrame::clamped) {  // X_i = I, Z_ii = Z_io = 0
    port.P_ii = port.S_inverse;
    port.P_io = S_X_o;
    port.free_i = X_free;
    return;
  }
  const TwistMatrix S_X_i = port.S_inverse.lazyProduct(port.X_i.transpose());
  port.P_ii = block.Z_ii + port.X_i.lazyProduct(S_X_i);
  port.P_io = block.Z_io + port.X_i.lazyProduct(S_X_o);
  port.free_i = port.X_i.lazyProduct(X_free) + bias_i;
}

void condense_subsystem(const Subsystem& subsystem, const HubState& hub, SubsystemData& data,
                        SubsystemWork& work) noexcept {
  const std::size_t count = work.bodies.size();
  TwistMatrix Lambda = work.bodies[count - 1].port.P_ii;  // compliance of what hangs at a joint
  Twist free = work.bodies[count - 1].port.free_i;        // its acceleration without wrench
  for (std::size_t j = count - 1; j-- > 0;) {
    const TwoPort& port = work.bodies[j].port;
    JointElimination& joint = work.bodies[j].joint;
    const Rotation& R = data.poses[j + 1].R_PB;
    joint.Pi = invert_symmetric(port.P_oo + R.turn(Lambda));
    joint.rhs = R * free - port.free_o;
    const TwistMatrix P_io_Pi = port.P_io.lazyProduct(joint.Pi);
    Lambda = port.P_ii - P_io_Pi.lazyProduct(port.P_io.transpose());
    free = port.free_i + P_io_Pi.lazyProduct(joint.rhs);
  }

  EffectiveInertia& effective = data.effective;
  effective.root_mass = invert_symmetric(Lambda);
  effective.root_free = free;
  // T Y'' + b is the bracket's acceleration in the hub frame, R that of the first body's frame.
  const Rotation& R = data.poses[0].R_PB;
  const TwistMatrix T = rigid_handle(subsystem.root.p);
  const TwistMatrix mass = R.turn(effective.root_mass);
  const double w = hub.twist[kRotation];
  Twist bias = Twist::Zero();
  bias.head<kPosition>() = -w * w * subsystem.root.p;
  effective.mass = T.transpose() * mass * T;
  effective.force = T.transpose() * (mass * (R * free - bias));
  effective.centrifugal_inertia = effective.centrifugal_rate = 0.0;
  for (const BodyData& body : data.bodies) {
    effective.centrifugal_inertia += body.terms.centrifugal_inertia;
    effective.centrifugal_rate += body.terms.centrifugal_rate;
  }
}

void recover_wrenches(const Subsystem& subsystem, const HubState& hub, const HubSolution& solution,
                      const SubsystemWork& work, SubsystemData& data) noexcept {
  const Twist root =
      calc_root_acceleration(subsystem, hub, solution.acceleration, data.poses[0]);
  Twist F = data.effective.root_mass * (root - data.effective.root_free);
  const std::size_t count = work.bodies.size();
  for (std::size_t j = 0; j < count; ++j) {
    HandleWrenches& wrenches = data.wrenches[j];
    wrenches.inboard = F;
    wrenches.outboard.setZero();
    if (j + 1 == count) break;
    const BodyWork& body = work.bodies[j];
    wrenches.outboard = body.joint.Pi * (body.joint.rhs - body.port.P_io.transpose() * F);
    F = -(data.poses[j + 1].R_PB.inverse() * wrenches.outboard);
  }
}

void recover_body(const HandleWrenches& wrenches, const BodyWork& work, const PassControl& control,
                  BodyData& data, double* a) noexcept {
  const FlexibleBody& body = *data.model->body;
  const ElasticBlock& block = *data.blocks[control.implicit];
  const TwoPort& port = work.port;
  const Twist X = port.S_inverse * (port.p + port.X_i.transpose() * wrenches.inboard +
                                    port.X_o.transpose() * wrenches.outboard);
  data.X = X;
  const auto wrench_of = [&](const ElasticBlock::BendingColumn& column) {
    return (column.outboard ? wrenches.outboard : wrenches.inboard)[column.component];
  };
  const double alpha = X[kRotation];
  const double f_x = wrenches.outboard[0];
  const double f_0 = wrench_of(block.columns[0]);
  const double f_1 = wrench_of(block.columns[1]);
  const int u = data.layout.u();
  for_each_lane(body.axial(), [&]<class Lane>(int i) {
    store(Lane(load<Lane>(work.z + u + i) - alpha * load<Lane>(work.W_theta + u + i) -
               X[0] * load<Lane>(block.W_x.data() + i) +
               f_x * load<Lane>(block.Z_axial.data() + i)),
          a + u + i);
  });
  const int v = data.layout.v();
  for_each_lane(body.bending(), [&]<class Lane>(int i) {
    store(Lane(load<Lane>(work.z + v + i) - alpha * load<Lane>(work.W_theta + v + i) -
               X[1] * load<Lane>(block.W_y.data() + i) +
               f_0 * load<Lane>(block.columns[0].Z.data() + i) +
               f_1 * load<Lane>(block.columns[1].Z.data() + i)),
          a + v + i);
  });
}

}  // namespace spoke::structured
