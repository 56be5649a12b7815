// Solves for the forces of loops, and hands these to the bodies.

#include "engine/step/formulation/loops/loops.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "engine/step/formulation/tree_joints.h"

namespace spoke {
namespace {

/// Whether a row stays in the matrix: its force is an unknown, here or where it is handed up to.
template <class World>
bool is_in(const LoopData<World>& loops, std::size_t row, bool is_implicit) {
  return !loops.is_closed(row) || is_solved(loops.use[row], is_implicit);
}

/// Sets the forces of springs that are given; others are zero.
template <class World>
void put_given_forces(bool is_implicit, LoopData<World>& loops) {
  for (std::size_t r = 0; r < loops.multipliers.size(); ++r)
    loops.multipliers[r] = is_in(loops, r, is_implicit) ? 0.0 : loops.states[r].force;
}

/// Returns the relative acceleration that is asked of a row, as far as it is known here.
template <class World>
double target_of(const LoopData<World>& loops, std::size_t row) {
  return loops.level[row] == LoopRowLevel::base ? 0.0 : loops.states[row].target;
}

/// Takes rows out of the matrix whose forces are no unknowns; what these do goes to the other
/// side of the rows that stay.
template <class World>
void take_out(bool is_implicit, LoopData<World>& loops) {
  const auto row_at = [&loops](int p) {
    return static_cast<std::size_t>(loops.row_at[static_cast<std::size_t>(p)]);
  };
  for (int p = 0; p < loops.rows; ++p) {
    const std::size_t r = row_at(p);
    const bool own_is_in = is_in(loops, r, is_implicit);
    for (int q = loops.matrix.first(p); q <= p; ++q) {
      const std::size_t c = row_at(q);
      const bool other_is_in = is_in(loops, c, is_implicit);
      if (own_is_in && other_is_in) continue;
      double& entry = loops.matrix.entry(p, q);
      if (own_is_in) loops.half[static_cast<std::size_t>(p)] -= entry * loops.multipliers[c];
      if (other_is_in) loops.half[static_cast<std::size_t>(q)] -= entry * loops.multipliers[r];
      entry = p == q ? 1.0 : 0.0;
    }
  }
}

/// Keeps the pivots of the passes at the start, before the first step.
template <class World>
void keep_first_pivots(const StepProgress& progress, LoopData<World>& loops) {
  if (progress.step > 0 || !progress.control.is_between_steps()) return;
  auto& first = progress.control.is_implicit ? loops.first_implicit : loops.first_explicit;
  std::copy(loops.pivots.begin(), loops.pivots.end(), first.begin());
}

}  // namespace

std::vector<int> bodies_of(const LoopModel& loop) {
  std::vector<int> bodies{loop.from.body};
  const bool has_other = loop.to.carrier == LoopPlace::Carrier::body;
  if (has_other && loop.to.body != loop.from.body) bodies.push_back(loop.to.body);
  return bodies;
}

template <class World>
void factorise_loops(const StepProgress& progress, LoopData<World>& loops,
                     TwistMatrixOf<World>& mass, TwistOf<World>& force) noexcept {
  const bool is_implicit = progress.control.is_implicit;
  put_given_forces(is_implicit, loops);
  for (int row = 0; row < loops.rows; ++row) {
    const auto r = static_cast<std::size_t>(row);
    const auto p = static_cast<std::size_t>(loops.place_of[r]);
    const bool is_unknown = is_in(loops, r, is_implicit);
    force += loops.multipliers[r] * loops.hub[r];  // of springs that are given
    loops.half[p] = is_unknown ? target_of(loops, r) - loops.free[r] : 0.0;
    loops.half_hub[p] = is_unknown ? loops.hub[r] : TwistOf<World>(TwistOf<World>::Zero());
  }
  take_out(is_implicit, loops);
  const auto is_closed = [&loops](int r) { return loops.is_closed(static_cast<std::size_t>(r)); };
  for (int r = 0; r < loops.rows; ++r)
    if (is_closed(r)) loops.entry(r, r) += loops.states[static_cast<std::size_t>(r)].compliance;
  for (const int r : loops.bearings)
    if (is_closed(r))
      loops.entry(r + 1, r) += loops.states[static_cast<std::size_t>(r)].shared_compliance;
  loops.matrix.factorise(loops.pivots, loops.closed);
  std::fill(loops.pivots.begin() + loops.closed, loops.pivots.end(), 1.0);
  keep_first_pivots(progress, loops);
  loops.matrix.solve_lower(loops.half, loops.closed);
  loops.matrix.solve_lower(loops.half_hub, loops.closed);
  for (std::size_t p = 0; std::cmp_less(p, loops.closed); ++p) {
    mass += loops.half_hub[p] * loops.half_hub[p].transpose();
    force += loops.half[p] * loops.half_hub[p];
  }
}

template <class World>
void calc_loop_forces(bool is_implicit, const TwistOf<World>& hub,
                      LoopData<World>& loops) noexcept {
  for (std::size_t p = 0; p < loops.half.size(); ++p) {
    const auto r = static_cast<std::size_t>(loops.row_at[p]);
    if (loops.is_closed(r))
      loops.half[p] -= loops.half_hub[p].dot(hub);
    else
      loops.half[p] = loops.multipliers[r];
  }
  loops.matrix.solve_upper(loops.half, loops.closed);
  for (std::size_t r = 0; r < loops.multipliers.size(); ++r)
    if (loops.is_closed(r) && is_solved(loops.use[r], is_implicit))
      loops.multipliers[r] = loops.half[static_cast<std::size_t>(loops.place_of[r])];
}

template <class World>
void put_loop_wrenches(const Subsystem<World>& subsystem, SubsystemData<World>& data) noexcept {
  LoopData<World>& loops = data.loops;
  for (std::size_t k = 0; k < subsystem.loops.size(); ++k) {
    const LoopModel& loop = subsystem.loops[k];
    if (loop.is_coupling()) continue;  // acts on joints alone
    const LoopPath& path = loops.paths[k];
    TwistOf<World> from = TwistOf<World>::Zero(), to = from;
    for (int row = 0; row < path.rows; ++row) {
      const auto r = static_cast<std::size_t>(path.first_row + row);
      from += loops.multipliers[r] * loops.states[r].from;
      to += loops.multipliers[r] * loops.states[r].to;
    }
    // In space loops have handles of their own; in the plane a joint may be at the same one.
    const auto put = [&data](const LoopPlaceModel& place, const TwistOf<World>& wrench) {
      if (place.carrier != LoopPlace::Carrier::body) return;
      TwistOf<World>& on_handle =
          wrench_on(data, static_cast<std::size_t>(place.body), place.handle);
      if constexpr (tree::kHasJointCoordinates<World>)
        on_handle = wrench;
      else
        on_handle += wrench;
    };
    put(loop.from, from);
    put(loop.to, to);
  }
}

template <class World>
void report_loops(const Subsystem<World>& subsystem, double length,
                  SubsystemData<World>& data) noexcept {
  LoopData<World>& loops = data.loops;
  const bool is_implicit = data.progress->control.is_implicit;
  const auto& first = is_implicit ? loops.first_implicit : loops.first_explicit;
  LoopReport report{};
  report.least_pivot = 1.0;
  report.row = -1;
  bool is_finite = true;
  std::size_t r = 0;
  for (const LoopModel& loop : subsystem.loops)
    for (const LoopRow& row : loop.rows) {
      const LoopRowState<World>& state = loops.states[r];
      const LoopRowUse use = loops.use[r];
      report.power -= loops.multipliers[r] * state.given_rate;
      if (use == LoopRowUse::sprung) report.dissipation += row.damping * state.rate * state.rate;
      report.dissipation += state.loss;
      const double opening = std::abs(state.opening) / loop.unit_of(row, length);
      if (use == LoopRowUse::solved) report.opening = std::max(report.opening, opening);
      if (use == LoopRowUse::dropped) report.dropped = std::max(report.dropped, opening);
      is_finite = is_finite && std::isfinite(loops.multipliers[r] + opening);
      const auto p = static_cast<std::size_t>(loops.place_of[r]);
      const double left = loops.pivots[p] / first[p];
      // Pivots of a bearing with matrices change with these, and nothing is lost where they do.
      if (is_solved(use, is_implicit) && !row.is_of_bearing && !(left >= report.least_pivot)) {
        report.least_pivot = left;
        report.row = static_cast<std::int64_t>(r);
      }
      ++r;
    }
  report.is_finite = is_finite && report.least_pivot > 0.0 ? 1 : 0;
  loops.report = report;
}

template <class World>
void keep_loop_loads(SubsystemData<World>& data) noexcept {
  LoopData<World>& loops = data.loops;
  std::copy(loops.multipliers.begin(), loops.multipliers.end(), loops.kept_multipliers.begin());
}

template void factorise_loops(const StepProgress&, LoopData<Plane>&, TwistMatrix&, Twist&) noexcept;
template void calc_loop_forces(bool, const Twist&, LoopData<Plane>&) noexcept;
template void put_loop_wrenches(const Subsystem<Plane>&, SubsystemData<Plane>&) noexcept;
template void report_loops(const Subsystem<Plane>&, double, SubsystemData<Plane>&) noexcept;
template void keep_loop_loads(SubsystemData<Plane>&) noexcept;
template void factorise_loops(const StepProgress&, LoopData<Space>&, space::TwistMatrix&,
                              space::Twist&) noexcept;
template void calc_loop_forces(bool, const space::Twist&, LoopData<Space>&) noexcept;
template void put_loop_wrenches(const Subsystem<Space>&, SubsystemData<Space>&) noexcept;
template void report_loops(const Subsystem<Space>&, double, SubsystemData<Space>&) noexcept;
template void keep_loop_loads(SubsystemData<Space>&) noexcept;

}  // namespace spoke
