// One block of (P 11): the mass matrix of a body, inverted and multiplied with the rows of its
// joints. docs/formulation.md, section 4.2.

#include <Eigen/Cholesky>

#include "engine/formulation/dense_body.h"
#include "engine/formulation/subsystem.h"

namespace spoke::subsystem {
namespace {

/// Takes the place of the matrix.
using Cholesky = Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>>;

}  // namespace

template <class World>
void allocate(const SubsystemData<World>& data, const std::vector<DenseBlocks>& elastic,
              SubsystemWork<World>& work) {
  constexpr int d = World::kTwist;
  work.bodies = ArenaVector<BodyWork<World>>(data.bodies.size(), *data.arena);
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    BodyWork<World>& body = work.bodies[j];
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

template <class World>
void invert_body(const BodyData<World>& data, const AngularOf<World>& speed, bool implicit,
                 BodyWork<World>& work) noexcept {
  constexpr int d = World::kTwist;
  // (1) M of (P 3), then its Cholesky factor in place.
  calc_dense_mass(data, *work.elastic[implicit], work.mass);
  const Cholesky factor(work.mass);
  // (2) The right-hand sides J_i^T, J_o^T and Q.
  Eigen::MatrixXd &J = work.jacobians, &columns = work.inverse_columns;
  calc_inboard_jacobian(data, J.topRows<d>());
  calc_outboard_jacobian(data, J.bottomRows<d>());
  work.bias_out = calc_outboard_bias(data, speed);
  columns.leftCols<2 * d>() = J.transpose();
  calc_dense_force(data, columns.col(2 * d));
  // (3) M^-1 [J_i^T, J_o^T, Q], and [J_i; J_o] times that: the body's share of Phi M^-1 Phi^T and
  // of Phi M^-1 Q.
  factor.solveInPlace(columns);
  work.products.noalias() = J.lazyProduct(columns);
}

template void allocate(const SubsystemData<Plane>&, const std::vector<DenseBlocks>&,
                       SubsystemWork<Plane>&);
template void invert_body(const BodyData<Plane>&, const double&, bool, BodyWork<Plane>&) noexcept;

}  // namespace spoke::subsystem
