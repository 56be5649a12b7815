// Recovery, docs/formulation.md, section 4.2: multipliers, (P 8), then accelerations, (P 7).

#include "engine/formulation/subsystem.h"
#include "engine/formulation/subsystem/root_jacobian.h"

namespace spoke::subsystem {
namespace {

constexpr int d = kTwist;

}  // namespace

void recover_wrenches(const Subsystem& subsystem, SubsystemWork& work,
                      SubsystemData& data) noexcept {
  // (P 8): lambda = D^-1 (Phi_Y Y'' + Phi M^-1 Q - gamma). F(child) = lambda, f(parent) = -R_PB
  // lambda.
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
  // (P 7): q'' = M^-1 (Q - Phi^T lambda) = M^-1 Q + M^-1 J_i^T F + M^-1 J_o^T f.
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
