// Eliminates the coordinates of a subsystem's joints behind its bodies.

#include "engine/step/formulation/subsystem/joint_coordinates.h"

#include <cassert>

#include "engine/support/dense.h"

namespace spoke::subsystem {
namespace {

/// Adds tau and k^ of one joint, whose first coordinate is `first`.
template <class World, class Joint>
void add_forces(const Joint& joint, int first, SubsystemWork<World>& work) {
  if constexpr (tree::kHasJointCoordinates<World>)
    for (int c = 0; c < joint.coordinates; ++c) {
      const auto k = static_cast<std::size_t>(c);
      work.inertia(first + c, first + c) += joint.share[k];
      work.response(first + c, World::kTwist) += joint.tau[k];
    }
}

}  // namespace

template <class World>
void eliminate_coordinates(const Subsystem<World>& subsystem, const SubsystemData<World>& data,
                           SubsystemWork<World>& work) noexcept {
  assert(work.columns.cols() == work.inertia.rows() && work.columns.rows() == work.D.rows());
  work.inertia.noalias() = work.columns.transpose().lazyProduct(work.inverse_columns);
  work.response.noalias() = -work.columns.transpose().lazyProduct(work.solution);
  for (std::size_t j = 0; j < work.bodies.size(); ++j)
    add_forces(joint_of(subsystem, data, j), work.first_coordinate[j], work);
  factorise_cholesky(work.inertia);
  solve_cholesky(work.inertia, work.response);
  work.solution.noalias() += work.inverse_columns.lazyProduct(work.response);
}

template void eliminate_coordinates(const Subsystem<Plane>&, const SubsystemData<Plane>&,
                                    SubsystemWork<Plane>&) noexcept;
template void eliminate_coordinates(const Subsystem<Space>&, const SubsystemData<Space>&,
                                    SubsystemWork<Space>&) noexcept;

}  // namespace spoke::subsystem
