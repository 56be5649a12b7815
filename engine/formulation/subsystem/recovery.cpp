// Recovery, docs/formulation.md, section 4.2: multipliers, (P 8), then accelerations, (P 7).

#include "engine/formulation/subsystem.h"
#include "engine/formulation/subsystem/root_jacobian.h"

namespace spoke::subsystem {

template <class World>
void recover_wrenches(const Subsystem<World>& subsystem, SubsystemWork<World>& work,
                      SubsystemData<World>& data) noexcept {
  constexpr int d = World::kTwist;
  // (P 8): lambda = D^-1 (Phi_Y Y'' + Phi M^-1 Q - gamma). F(child) = lambda, f(parent) = -R_PB
  // lambda.
  const TwistOf<World> root = data.joints[0].R.inverse() *
                              TwistOf<World>(root_jacobian(subsystem) * *data.hub_acceleration);
  const Eigen::MatrixXd& solution = work.solution;
  Eigen::VectorXd& multipliers = work.multipliers;
  multipliers.noalias() = solution.col(d) + solution.leftCols<d>().lazyProduct(root);
  const std::size_t count = work.bodies.size();
  for (std::size_t j = 0; j < count; ++j) {
    const auto k = static_cast<Eigen::Index>(j);
    data.wrenches[j].inboard = multipliers.segment<d>(d * k);
    data.wrenches[j].outboard.setZero();
    if (j + 1 < count)
      data.wrenches[j].outboard =
          -(data.joints[j + 1].R * TwistOf<World>(multipliers.segment<d>(d * (k + 1))));
  }
}

template <class World>
void recover_body(const typename BodyTypes<World>::HandleWrenches& wrenches,
                  const BodyWork<World>& work, BodyData<World>& data, double* a) noexcept {
  constexpr int d = World::kTwist;
  // (P 7): q'' = M^-1 (Q - Phi^T lambda) = M^-1 Q + M^-1 J_i^T F + M^-1 J_o^T f.
  const Eigen::MatrixXd& columns = work.inverse_columns;
  data.X = columns.col(2 * d).head<d>() + columns.topLeftCorner<d, d>() * wrenches.inboard +
           columns.block<d, d>(0, d) * wrenches.outboard;
  Eigen::Index row = d;
  data.layout.for_parts([&](int first, int size) {
    Eigen::Map<Eigen::VectorXd>(a + first, size).noalias() =
        columns.col(2 * d).segment(row, size) +
        columns.block(row, 0, size, d).lazyProduct(wrenches.inboard) +
        columns.block(row, d, size, d).lazyProduct(wrenches.outboard);
    row += size;
  });
}

template void recover_wrenches(const Subsystem<Plane>&, SubsystemWork<Plane>&,
                               SubsystemData<Plane>&) noexcept;
template void recover_body(const PlanarWrenches&, const BodyWork<Plane>&, BodyData<Plane>&,
                           double*) noexcept;

}  // namespace spoke::subsystem
