// One block of (P 11): the mass matrix of a body, inverted and multiplied with the rows of its
// joints. docs/formulation.md, section 4.2.

#include <Eigen/Cholesky>

#include "engine/formulation/dense_body.h"
#include "engine/formulation/subsystem.h"

namespace spoke::subsystem {
namespace {

constexpr int d = kTwist;

/// Takes the place of the matrix.
using Cholesky = Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>>;

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
  // (1) M of (P 3), then its Cholesky factor in place.
  calc_dense_mass(data, *work.elastic[implicit], work.mass);
  const Cholesky factor(work.mass);
  // (2) The right-hand sides J_i^T, J_o^T and Q.
  calc_inboard_jacobian(data, work.jacobians.topRows<d>());
  calc_outboard_jacobian(data, work.jacobians.bottomRows<d>());
  work.bias_out = calc_outboard_bias(data, speed);
  work.inverse_columns.leftCols<2 * d>() = work.jacobians.transpose();
  calc_dense_force(data, work.inverse_columns.col(2 * d));
  // (3) M^-1 [J_i^T, J_o^T, Q], and [J_i; J_o] times that: the body's share of Phi M^-1 Phi^T and
  // of Phi M^-1 Q.
  factor.solveInPlace(work.inverse_columns);
  work.products.noalias() = work.jacobians.lazyProduct(work.inverse_columns);
}

}  // namespace spoke::subsystem
