// What unit forces of closures do, from the factors of the subsystem's joints: docs/formulation.md,
// section 12. With C = Phi M^-1 u, and the joints' forces that follow, X = D^-1 C,
//   D of the loops = u^T M^-1 u - C^T X,    free = u . a - C^T x,    N = - C^T X_Y
// where x and X_Y are the joints' forces without loops, and by the hub's acceleration. The efforts
// e of a coupling act on the coordinates of joints alone: C = 0, and with q'' what a unit force
// makes of these, D of the loops += e . q'', free += e . q''.

#include <cassert>

#include "engine/step/formulation/loops/loops.h"
#include "engine/step/formulation/subsystem.h"
#include "engine/step/formulation/tree_joints.h"
#include "engine/support/dense.h"

namespace spoke::subsystem {
namespace {

/// Returns the acceleration of handle `h` of a body by the unit force of a row on it.
template <class World>
TwistOf<World> respond(const LoopModel& loop, const LoopRowState<World>& row, int body, int h,
                       const SubsystemWork<World>& work) {
  TwistOf<World> sum = TwistOf<World>::Zero();
  for_places_on_bodies(loop, row, [&](const LoopPlaceModel& place, const TwistOf<World>& u) {
    if (place.body == body) sum += work.bodies[body].compliance(h, place.handle) * u;
  });
  return sum;
}

/// Fills a column of C.
template <class World, class Column>
void fill_right(const Subsystem<World>& subsystem, const SubsystemData<World>& data,
                const LoopModel& loop, const LoopRowState<World>& row,
                const SubsystemWork<World>& work, Column&& column) {
  constexpr int d = World::kTwist;
  for (std::size_t k = 0; k < work.bodies.size(); ++k) {
    const int body = static_cast<int>(k), parent = subsystem.bodies[k].parent;
    TwistOf<World> sum = -respond(loop, row, body, 0, work);
    if (parent >= 0)
      sum +=
          tree::carry_to_child<World>(joint_of(subsystem, data, k),
                                      respond(loop, row, parent, subsystem.bodies[k].handle, work));
    column.template segment<d>(d * body) = sum;
  }
}

/// Calls `visit(its row among all coordinates of joints, ratio, body)` for the free coordinates of
/// a coupling.
template <class World, class Visit>
void for_efforts(const LoopModel& loop, const SubsystemWork<World>& work, const Visit& visit) {
  for (const CoupledCoordinate& at : loop.coupled)
    if (!at.is_driven)
      visit(work.first_coordinate[static_cast<std::size_t>(at.body)] + at.component, at.ratio,
            at.body);
}

/// Adds what a coupling feels of the hub's acceleration, and without it.
template <class World>
void add_coupling(const Subsystem<World>& subsystem, const SubsystemData<World>& data,
                  const LoopModel& coupling, const SubsystemWork<World>& work, TwistOf<World>& hub,
                  double& free) {
  constexpr int d = World::kTwist;
  for_efforts(coupling, work, [&](int row, double ratio, int body) {
    free += ratio * work.response(row, d);
    const auto root = joint_of(
        subsystem, data, static_cast<std::size_t>(work.root_of[static_cast<std::size_t>(body)]));
    hub += ratio * (tree::carrying_matrix<World>(root).transpose() *
                    work.response.row(row).template head<d>().transpose());
  });
}

}  // namespace

template <class World>
void calc_loop_columns(const Subsystem<World>& subsystem, std::size_t loop,
                       SubsystemWork<World>& work, SubsystemData<World>& data) noexcept {
  assert(loop < subsystem.loops.size() && work.loops.size() == subsystem.loops.size());
  constexpr int d = World::kTwist;
  const LoopModel& model = subsystem.loops[loop];
  LoopData<World>& loops = data.loops;
  typename SubsystemWork<World>::LoopColumns& columns = work.loops[loop];
  const int first = loops.paths[loop].first_row;
  // (1) C, and the joints' forces that follow from it.
  for (Eigen::Index row = 0; row < columns.right.cols(); ++row)
    fill_right(subsystem, data, model, loops.states[static_cast<std::size_t>(first + row)], work,
               columns.right.col(row));
  columns.solution = columns.right;
  solve_cholesky(work.D, columns.solution);
  if (work.columns.cols() > 0) {
    columns.response.noalias() = -work.columns.transpose().lazyProduct(columns.solution);
    for_efforts(model, work,
                [&columns](int at, double ratio, int) { columns.response(at, 0) += ratio; });
    solve_cholesky(work.inertia, columns.response);
    columns.solution.noalias() += work.inverse_columns.lazyProduct(columns.response);
  }
  // (2) The rows' accelerations by the hub's, and without it.
  for (Eigen::Index row = 0; row < columns.right.cols(); ++row) {
    const auto r = static_cast<std::size_t>(first + row);
    loops.hub[r] = loops.states[r].hub;
    for (std::size_t j = 0; j < work.bodies.size(); ++j) {
      const auto at = d * static_cast<Eigen::Index>(j);
      const TwistOf<World> share = work.solution.template block<d, d>(at, 0).transpose() *
                                   columns.right.col(row).template segment<d>(at);
      const auto root = joint_of(subsystem, data, static_cast<std::size_t>(work.root_of[j]));
      loops.hub[r] -= tree::carrying_matrix<World>(root).transpose() * share;
    }
    loops.free[r] = -columns.right.col(row).dot(work.solution.col(d));
    for_places_on_bodies(
        model, loops.states[r], [&](const LoopPlaceModel& place, const TwistOf<World>& u) {
          loops.free[r] += u.dot(work.bodies[place.body].free_acceleration(place.handle));
        });
    if (model.is_coupling())
      add_coupling(subsystem, data, model, work, loops.hub[r], loops.free[r]);
  }
}

template <class World>
PartList parts_of_loop_columns(const Subsystem<World>& subsystem, std::size_t loop,
                               const SubsystemData<World>& data) {
  const SubsystemParts& own = data.parts;
  PartList list{own.loops.motion, own.rotations, own.effective, own.workspace};
  for (const int body : bodies_of(subsystem.loops[loop]))
    list.push_back(own.bodies[static_cast<std::size_t>(body)].inverse);
  return list;
}

template <class World>
void fill_loop_matrix(const Subsystem<World>& subsystem, const SubsystemWork<World>& work,
                      SubsystemData<World>& data) noexcept {
  LoopData<World>& loops = data.loops;
  loops.matrix.set_zero();
  for (std::size_t a = 0; a < subsystem.loops.size(); ++a)
    for (const int other : loops.meets[a]) {
      const auto b = static_cast<std::size_t>(other);
      for (int i = 0; i < loops.paths[a].rows; ++i)
        for (int j = 0; j < loops.paths[b].rows && (a != b || j <= i); ++j) {
          const int r = loops.paths[a].first_row + i, c = loops.paths[b].first_row + j;
          double sum = -work.loops[a].right.col(i).dot(work.loops[b].solution.col(j));
          for_places_on_bodies(
              subsystem.loops[a], loops.states[static_cast<std::size_t>(r)],
              [&](const LoopPlaceModel& place, const TwistOf<World>& u) {
                sum += u.dot(respond(subsystem.loops[b], loops.states[static_cast<std::size_t>(c)],
                                     place.body, place.handle, work));
              });
          for_efforts(subsystem.loops[a], work, [&](int at, double ratio, int) {
            sum += ratio * work.loops[b].response(at, j);
          });
          loops.entry(r, c) = sum;
        }
    }
}

template <class World>
PartList parts_of_loop_matrix(const Subsystem<World>& subsystem, const SubsystemData<World>& data) {
  const SubsystemParts& own = data.parts;
  PartList list{own.loops.motion, own.effective};
  graph::add_to(list, own.loops.columns);
  for (const LoopModel& loop : subsystem.loops)
    for (const int body : bodies_of(loop))
      list.push_back(own.bodies[static_cast<std::size_t>(body)].inverse);
  return list;
}

template <class World>
void load_joints_by_loops(const Subsystem<World>& subsystem, const SubsystemData<World>& data,
                          SubsystemWork<World>& work) noexcept {
  constexpr int d = World::kTwist;
  const LoopData<World>& loops = data.loops;
  for (std::size_t k = 0; k < subsystem.loops.size(); ++k)
    for (int row = 0; row < loops.paths[k].rows; ++row) {
      const double lambda =
          loops.multipliers[static_cast<std::size_t>(loops.paths[k].first_row + row)];
      work.solution.col(d) += lambda * work.loops[k].solution.col(row);
      if (work.response.rows() > 0)
        work.response.col(d) += lambda * work.loops[k].response.col(row);
    }
}

template void calc_loop_columns(const Subsystem<Plane>&, std::size_t, SubsystemWork<Plane>&,
                                SubsystemData<Plane>&) noexcept;
template void fill_loop_matrix(const Subsystem<Plane>&, const SubsystemWork<Plane>&,
                               SubsystemData<Plane>&) noexcept;
template PartList parts_of_loop_columns(const Subsystem<Plane>&, std::size_t,
                                        const SubsystemData<Plane>&);
template PartList parts_of_loop_matrix(const Subsystem<Plane>&, const SubsystemData<Plane>&);
template void load_joints_by_loops(const Subsystem<Plane>&, const SubsystemData<Plane>&,
                                   SubsystemWork<Plane>&) noexcept;
template void calc_loop_columns(const Subsystem<Space>&, std::size_t, SubsystemWork<Space>&,
                                SubsystemData<Space>&) noexcept;
template void fill_loop_matrix(const Subsystem<Space>&, const SubsystemWork<Space>&,
                               SubsystemData<Space>&) noexcept;
template PartList parts_of_loop_columns(const Subsystem<Space>&, std::size_t,
                                        const SubsystemData<Space>&);
template PartList parts_of_loop_matrix(const Subsystem<Space>&, const SubsystemData<Space>&);
template void load_joints_by_loops(const Subsystem<Space>&, const SubsystemData<Space>&,
                                   SubsystemWork<Space>&) noexcept;

}  // namespace spoke::subsystem
