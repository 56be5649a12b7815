#pragma once

// The forces that close the loops of a subsystem (docs/formulation.md, section 12). With D what
// unit forces do to the rows' relative accelerations while the hub is at rest, N what the hub's
// acceleration does, and free what happens without either,
//   (D + compliance) lambda + free + N Y'' = target
// so that the hub feels, besides the tree's,
//   M^C += N^T D^-1 N,   Q^C += N^T D^-1 (target - free)
// D, N and free come from the formulation: loop columns. The rest is common to `structured` and
// `subsystem`; `augmented` has the rows in its one system.
//
// Rows of loops between subsystems stay open: what the elimination of the closed rows c leaves of
// an open one o,
//   D_oo - D_oc D_cc^-1 D_co,   N_o - D_oc D_cc^-1 N_c,   free_o + D_oc D_cc^-1 (target_c - free_c)
// is handed up to where all meet, see shared_loops.h, from where lambda_o comes back.

#include <array>
#include <string>
#include <vector>

#include "engine/bodies/table/step_data.h"

namespace spoke {

/// Allocates the loops of a subsystem; all rows take part.
template <class World>
void allocate_loops(const Subsystem<World>& subsystem, SubsystemData<World>& data);

/// Orders the rows for their elimination, and returns the first column of each in this order.
/// `neighbours`: by loop those that have entries of D in common with it.
template <class World>
std::vector<int> order_rows(const std::vector<std::vector<int>>& neighbours,
                            LoopData<World>& loops);

// Declare parts of loops that a formulation solves for.

/// Returns what declares the parts of loop k.
template <class World>
PartMaker maker_of_loop(std::size_t k, const SubsystemData<World>& data) {
  return data.part_maker.of("loop " + std::to_string(k + 1));
}
/// Declares the columns of loop k, as far as both formulations have them, and returns their part.
template <class World>
graph::PartId declare_loop_rows(std::size_t k, SubsystemData<World>& data);
/// Declares the matrix of all loops, and its factor.
template <class World>
void declare_loop_matrix(SubsystemData<World>& data);

/// Whether a row's force is an unknown of the pass.
inline bool is_solved(LoopRowUse use, bool is_implicit) {
  return use == LoopRowUse::solved || (use == LoopRowUse::sprung && is_implicit);
}

/// Calls `visit(place, wrench of the unit force)` for the places of a row on bodies.
template <class World, class Visit>
void for_places_on_bodies(const LoopModel& loop, const LoopRowState<World>& row, Visit&& visit) {
  visit(loop.from, row.from);
  if (loop.to.carrier == LoopPlace::Carrier::body) visit(loop.to, row.to);
}

/// Efforts by coordinate of a joint [1].
using JointEfforts = std::array<double, space::Joint::kMost>;

/// Sets the unit efforts of a coupling on the coordinates of the joint that carries a body. Returns
/// whether there are any.
inline bool find_efforts(const LoopModel& loop, int body, JointEfforts& efforts) {
  bool has_any = false;
  efforts.fill(0.0);
  for (const CoupledCoordinate& at : loop.coupled) {
    if (at.body != body || at.is_driven) continue;
    efforts[static_cast<std::size_t>(at.component)] += at.ratio;
    has_any = true;
  }
  return has_any;
}

/// Returns the bodies that carry places of a loop, each once.
std::vector<int> bodies_of(const LoopModel& loop);

/// Eliminates the closed rows of D, which `loops.matrix` holds (its lower triangle), and adds what
/// they do to the mass and the force of the hub.
template <class World>
void factorise_loops(const StepProgress& progress, LoopData<World>& loops,
                     TwistMatrixOf<World>& mass, TwistOf<World>& force) noexcept;
template <class World>
void factorise_loops(SubsystemData<World>& data) noexcept {
  factorise_loops(*data.progress, data.loops, data.effective.mass, data.effective.force);
}

/// Sets the multipliers of all closed rows, from the hub's acceleration and the multipliers of open
/// rows.
template <class World>
void calc_loop_forces(bool is_implicit, const TwistOf<World>& hub, LoopData<World>& loops) noexcept;
template <class World>
void calc_loop_forces(SubsystemData<World>& data) noexcept {
  calc_loop_forces(data.progress->control.is_implicit, *data.hub_acceleration, data.loops);
}
/// Returns the parts that they depend on besides the rows.
template <class World>
PartList parts_of_loop_forces(const SubsystemData<World>& data) {
  const LoopParts& loops = data.parts.loops;
  return {loops.factor, loops.first_pivots, data.parts.hub_acceleration};
}

/// Adds the forces of the loops to the wrenches on the handles of bodies, behind those of joints.
template <class World>
void put_loop_wrenches(const Subsystem<World>& subsystem, SubsystemData<World>& data) noexcept;
/// Returns the parts that these depend on; none where there is no loop.
template <class World>
PartList parts_of_loop_wrenches(const SubsystemData<World>& data) {
  const LoopParts& loops = data.parts.loops;
  return loops.is_empty() ? PartList{} : PartList{loops.motion, loops.factor};
}

/// Sums what the loops did in the pass. `length`: of the model, by which openings are measured [m].
template <class World>
void report_loops(const Subsystem<World>& subsystem, double length,
                  SubsystemData<World>& data) noexcept;

/// Keeps the multipliers of the last evaluation of a step.
template <class World>
void keep_loop_loads(SubsystemData<World>& data) noexcept;
/// Returns the parts that they depend on; none where there is no loop.
template <class World>
PartList parts_of_loop_loads(const SubsystemData<World>& data) {
  const LoopParts& loops = data.parts.loops;
  return loops.is_empty() ? PartList{} : PartList{loops.factor};
}

}  // namespace spoke
