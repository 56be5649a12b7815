// Recovers the multipliers, (P 8), then the accelerations, (P 7): docs/formulation.md, section 4.2.

#include <cassert>
#include <utility>

#include "engine/bodies/kernels/dense_body.h"
#include "engine/step/formulation/subsystem.h"
#include "engine/step/formulation/tree_joints.h"

namespace spoke::subsystem {

template <class World>
void recover_wrenches(const Subsystem<World>& subsystem, SubsystemWork<World>& work,
                      SubsystemData<World>& data) noexcept {
  assert(work.bodies.size() == subsystem.bodies.size() && data.hub_acceleration);
  constexpr int d = World::kTwist;
  // (P 8): lambda = D^-1 (Phi_Y Y'' + Phi M^-1 Q - gamma), with the share of the joints'
  // coordinates.
  TwistOf<World> root = TwistOf<World>::Zero();  // Phi_Y Y'' at the root of the body's tree
  int root_body = -1;
  Eigen::VectorXd& multipliers = work.multipliers;
  for (std::size_t j = 0; j < work.bodies.size(); ++j) {
    if (work.root_of[j] != root_body) {
      root_body = work.root_of[j];
      root = tree::carry_to_child<World>(
          joint_of(subsystem, data, static_cast<std::size_t>(root_body)), *data.hub_acceleration);
    }
    const auto rows = work.solution.template middleRows<d>(d * static_cast<Eigen::Index>(j));
    multipliers.template segment<d>(d * static_cast<Eigen::Index>(j)) =
        rows.col(d) + rows.template leftCols<d>().lazyProduct(root);
    double* a = joint_accelerations(data.bodies[j]);
    const int first = work.first_coordinate[j];
    for (int c = 0; c < joint_coordinates(subsystem.bodies[j]); ++c)
      a[c] =
          work.response(first + c, d) + work.response.row(first + c).template head<d>().dot(root);
  }
  set_wrenches(
      subsystem, [&](int j) { return multipliers.segment<d>(d * j); }, data);
}

template <class World>
void recover_body(const SubsystemData<World>& subsystem, std::size_t j, const BodyWork<World>& work,
                  BodyData<World>& data, double* a) noexcept {
  assert(j < subsystem.bodies.size() && a);
  assert(work.inverse_columns.rows() == dense_size(*data.model->body));
  constexpr int d = World::kTwist;
  // (P 7): q'' = M^-1 (Q - Phi^T lambda) = M^-1 Q + sum of M^-1 J_h^T f_h over the handles.
  const Eigen::MatrixXd& columns = work.inverse_columns;
  const int handles = static_cast<int>(work.biases.cols());
  const auto recover = [&](int row, auto&& part) {
    part = columns.col(d * handles).segment(row, part.size());
    for (int h = 0; h < handles; ++h)
      part.noalias() +=
          columns.block(row, d * h, part.size(), d).lazyProduct(wrench_on(subsystem, j, h));
  };
  recover(0, data.X);
  int row = d;
  data.layout.for_parts([&](int first, int size) {
    recover(std::exchange(row, row + size), Eigen::Map<Eigen::VectorXd>(a + first, size));
  });
}

template void recover_wrenches(const Subsystem<Plane>&, SubsystemWork<Plane>&,
                               SubsystemData<Plane>&) noexcept;
template void recover_body(const SubsystemData<Plane>&, std::size_t, const BodyWork<Plane>&,
                           BodyData<Plane>&, double*) noexcept;
template void recover_wrenches(const Subsystem<Space>&, SubsystemWork<Space>&,
                               SubsystemData<Space>&) noexcept;
template void recover_body(const SubsystemData<Space>&, std::size_t, const BodyWork<Space>&,
                           BodyData<Space>&, double*) noexcept;

}  // namespace spoke::subsystem
