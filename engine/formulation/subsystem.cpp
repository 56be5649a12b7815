#include "engine/formulation/subsystem.h"

#include <Eigen/Cholesky>

#include "engine/formulation/dense_body.h"
#include "engine/hub.h"

namespace spoke::subsystem {
namespace {

constexpr int d = kTwist;

/// Takes the place of the matrix.
using Cholesky = Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>>;

/// T of the root bracket: its twist per hub twist, hub frame.
TwistMatrix root_jacobian(const Subsystem& subsystem) {
  TwistMatrix T = TwistMatrix::Identity();
  T.col(kRotation).head<kPosition>() = quarter_turn(subsystem.root.p);
  return T;
}

/// Fills D = Phi M^-1 Phi^T and the last column of `solution` with Phi M^-1 Q - gamma.
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

void allocate(const SubsystemData& data, const std::vector<DenseBlocks>& elastic,
              SubsystemWork& work) {
  work.bodies = ArenaVector<BodyWork>(data.bodies.size(), *data.arena);
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    BodyWork& body = work.bodies[j];
    const int n = dense_size(*data.bodies[j].model->body);
    body.elastic = elastic[j];
    body.mass.setZero(n, n);
    body.jacobians.setZero(2 * d, n);
    body.inverse_columns.setZero(n, 2 * d + 1);
    body.products.setZero(2 * d, 2 * d + 1);
  }
  const int C1 = d * static_cast<int>(data.bodies.size());
  work.D.setZero(C1, C1);
  work.solution.setZero(C1, d + 1);
  work.multipliers.setZero(C1);
}

void invert_body(const BodyData& data, double speed, bool implicit, BodyWork& work) noexcept {
  calc_dense_mass(data, *work.elastic[implicit], work.mass);
  const Cholesky factor(work.mass);
  calc_inboard_jacobian(data, work.jacobians.topRows<d>());
  calc_outboard_jacobian(data, work.jacobians.bottomRows<d>());
  work.bias_out = calc_outboard_bias(data, speed);
  work.inverse_columns.leftCols<2 * d>() = work.jacobians.transpose();
  calc_dense_force(data, work.inverse_columns.col(2 * d));
  factor.solveInPlace(work.inverse_columns);
  work.products.noalias() = work.jacobians.lazyProduct(work.inverse_columns);
}

void condense_subsystem(const Subsystem& subsystem, SubsystemData& data,
                        SubsystemWork& work) noexcept {
  assemble(subsystem, *data.hub, data, work);
  const Cholesky factor(work.D);
  work.solution.leftCols<d>().setZero();
  work.solution.topLeftCorner<d, d>().setIdentity();
  factor.solveInPlace(work.solution);

  EffectiveInertia& effective = data.effective;
  const TwistMatrix Phi_Y = data.rotations[0].inverse().matrix() * root_jacobian(subsystem);
  effective.mass = Phi_Y.transpose() * work.solution.topLeftCorner<d, d>() * Phi_Y;
  effective.force = -Phi_Y.transpose() * work.solution.col(d).head<d>();
  effective.centrifugal_inertia = effective.centrifugal_rate = 0.0;
  for (const BodyData& body : data.bodies) {
    effective.centrifugal_inertia += body.terms.centrifugal_inertia;
    effective.centrifugal_rate += body.terms.centrifugal_rate;
  }
}

void recover_wrenches(const Subsystem& subsystem, SubsystemWork& work,
                      SubsystemData& data) noexcept {
  const Twist root =
      data.rotations[0].inverse() * Twist(root_jacobian(subsystem) * *data.hub_acceleration);
  work.multipliers.noalias() = work.solution.col(d) + work.solution.leftCols<d>().lazyProduct(root);
  const std::size_t count = work.bodies.size();
  for (std::size_t j = 0; j < count; ++j) {
    data.wrenches[j].inboard = work.multipliers.segment<d>(d * j);
    data.wrenches[j].outboard.setZero();
    if (j + 1 < count)
      data.wrenches[j].outboard =
          -(data.rotations[j + 1] * Twist(work.multipliers.segment<d>(d * (j + 1))));
  }
}

void recover_body(const HandleWrenches& wrenches, const BodyWork& work, BodyData& data,
                  double* a) noexcept {
  const auto& columns = work.inverse_columns;
  data.X = columns.topRows<d>().col(2 * d) + columns.topLeftCorner<d, d>() * wrenches.inboard +
           columns.topRows<d>().middleCols<d>(d) * wrenches.outboard;
  const auto part = [&](Eigen::Index first, Eigen::Index size, double* into) {
    Eigen::Map<Eigen::VectorXd>(into, size).noalias() =
        columns.col(2 * d).segment(first, size) +
        columns.block(first, 0, size, d).lazyProduct(wrenches.inboard) +
        columns.block(first, d, size, d).lazyProduct(wrenches.outboard);
  };
  part(d, data.layout.axial, a + data.layout.u());
  part(d + data.layout.axial, data.layout.bending, a + data.layout.v());
}

}  // namespace spoke::subsystem
