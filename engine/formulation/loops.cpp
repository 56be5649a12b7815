// Allocates loops, solves for their forces, and hands these to the bodies.

#include "engine/formulation/loops.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "engine/formulation/tree_joints.h"

namespace spoke {
namespace {

/// Finds the bodies that carry a loop, and the joints of their children.
template <class World>
LoopPath find_path(const Subsystem<World>& subsystem, const LoopModel& loop) {
  std::vector<bool> carries(subsystem.bodies.size(), false);
  for (const LoopPlaceModel* place : {&loop.from, &loop.to})
    for (int j = place->body; j >= 0; j = subsystem.bodies[static_cast<std::size_t>(j)].parent)
      carries[static_cast<std::size_t>(j)] = true;
  LoopPath path;
  path.rows = static_cast<int>(loop.rows.size());
  for (int j = static_cast<int>(carries.size()) - 1; j >= 0; --j) {
    const TreeBody<World>& body = subsystem.bodies[static_cast<std::size_t>(j)];
    if (!carries[static_cast<std::size_t>(j)]) continue;
    path.bodies.push_back(j);
    for (std::size_t o = body.children.size(); o > 0; --o)
      path.joints.push_back({j, body.children[o - 1], static_cast<int>(o),
                             carries[static_cast<std::size_t>(body.children[o - 1])]});
    if (body.parent < 0) path.roots.push_back(j);
  }
  return path;
}

/// Sets the forces of springs that are given; others are zero.
template <class World>
void put_given_forces(bool is_implicit, LoopData<World>& loops) {
  for (std::size_t r = 0; r < loops.multipliers.size(); ++r)
    loops.multipliers[r] = is_solved(loops.use[r], is_implicit) ? 0.0 : loops.states[r].force;
}

/// Returns what is left of a row's target: less the free acceleration and what given forces do.
template <class World>
double rest_of(int r, bool is_implicit, LoopData<World>& loops) {
  double rest =
      loops.states[static_cast<std::size_t>(r)].target - loops.free[static_cast<std::size_t>(r)];
  for (int c = 0; c < loops.rows; ++c) {
    if (is_solved(loops.use[static_cast<std::size_t>(c)], is_implicit)) continue;
    rest -= loops.entry(std::max(r, c), std::min(r, c)) *
            loops.multipliers[static_cast<std::size_t>(c)];
  }
  return rest;
}

/// Takes rows out of the matrix whose forces are no unknowns.
template <class World>
void take_out(bool is_implicit, LoopData<World>& loops) {
  for (int r = 0; r < loops.rows; ++r)
    for (int c = 0; c <= r; ++c) {
      const bool is_in = is_solved(loops.use[static_cast<std::size_t>(r)], is_implicit) &&
                         is_solved(loops.use[static_cast<std::size_t>(c)], is_implicit);
      if (!is_in) loops.entry(r, c) = r == c ? 1.0 : 0.0;
    }
}

/// Factorises D = L L^T in place. A pivot that has vanished is replaced: it is reported.
template <class World>
void factorise(LoopData<World>& loops) {
  for (int r = 0; r < loops.rows; ++r) {
    const double diagonal = loops.entry(r, r);
    for (int c = 0; c <= r; ++c) {
      double sum = loops.entry(r, c);
      for (int k = 0; k < c; ++k) sum -= loops.entry(r, k) * loops.entry(c, k);
      if (c < r) {
        loops.entry(r, c) = sum / loops.entry(c, c);
        continue;
      }
      loops.pivots[static_cast<std::size_t>(r)] = sum;
      loops.entry(r, r) = std::sqrt(sum > 0.0 ? sum : std::abs(diagonal) + 1e-300);
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

/// Solves L x = b in place, for columns of numbers or of twists.
template <class World, class Columns>
void solve_half(LoopData<World>& loops, Columns& x) {
  for (int r = 0; r < loops.rows; ++r) {
    auto& own = x[static_cast<std::size_t>(r)];
    for (int c = 0; c < r; ++c) own -= loops.entry(r, c) * x[static_cast<std::size_t>(c)];
    own /= loops.entry(r, r);
  }
}

}  // namespace

template <class World>
void allocate_loops(const Subsystem<World>& subsystem, SubsystemData<World>& data) {
  LoopData<World>& loops = data.loops;
  loops.rows = subsystem.loop_rows();
  loops.bodies = static_cast<int>(data.bodies.size());
  loops.handles = 0;
  loops.last_body = -1;
  loops.paths.clear();
  loops.use.clear();
  if (loops.rows == 0) return;
  Arena& arena = *data.arena;
  const TwistOf<World> none = TwistOf<World>::Zero();
  const auto rows = static_cast<std::size_t>(loops.rows);
  std::size_t joints = 0;
  int first = 0;
  for (const LoopModel& loop : subsystem.loops) {
    LoopPath& path = loops.paths.emplace_back(find_path(subsystem, loop));
    path.first_row = first;
    path.first_joint = joints;
    first += path.rows;
    joints += path.columns();
    loops.last_body = std::max({loops.last_body, loop.from.body, loop.to.body});
    for (const LoopRow& row : loop.rows)
      loops.use.push_back(row.is_rigid() ? LoopRowUse::solved : LoopRowUse::sprung);
  }
  for (const TreeBody<World>& body : subsystem.bodies)
    loops.handles = std::max(loops.handles, static_cast<int>(body.children.size()) + 1);
  loops.poses = ArenaVector<PoseOf<World>>(data.bodies.size(), arena);
  loops.accelerations = ArenaVector<TwistOf<World>>(data.bodies.size(), none, arena);
  loops.states = ArenaVector<LoopRowState<World>>(rows, arena);
  for (auto* of_joints : {&loops.joints, &loops.joint_forces})
    *of_joints = ArenaVector<TwistOf<World>>(joints, none, arena);
  loops.hub = ArenaVector<TwistOf<World>>(rows, none, arena);
  loops.free = ArenaVector<double>(rows, 0.0, arena);
  loops.branches = ArenaVector<TwistOf<World>>(rows * data.bodies.size(), none, arena);
  loops.scratch =
      ArenaVector<TwistOf<World>>(rows * static_cast<std::size_t>(loops.handles), none, arena);
  loops.matrix = ArenaVector<double>(rows * rows, 0.0, arena);
  loops.half_hub = ArenaVector<TwistOf<World>>(rows, none, arena);
  loops.half = ArenaVector<double>(rows, 0.0, arena);
  for (auto* pivots : {&loops.pivots, &loops.first_explicit, &loops.first_implicit})
    *pivots = ArenaVector<double>(rows, 1.0, arena);
  loops.multipliers = ArenaVector<double>(rows, 0.0, arena);
  loops.kept_multipliers = ArenaVector<double>(rows, 0.0, arena);
}

template <class World>
void factorise_loops(SubsystemData<World>& data) noexcept {
  LoopData<World>& loops = data.loops;
  const bool is_implicit = data.progress->control.is_implicit;
  EffectiveInertia<World>& effective = data.effective;
  put_given_forces(is_implicit, loops);
  for (int r = 0; r < loops.rows; ++r) {
    const auto k = static_cast<std::size_t>(r);
    const bool is_unknown = is_solved(loops.use[k], is_implicit);
    effective.force += loops.multipliers[k] * loops.hub[k];  // of springs that are given
    loops.half[k] = is_unknown ? rest_of(r, is_implicit, loops) : 0.0;
    loops.half_hub[k] = is_unknown ? loops.hub[k] : TwistOf<World>(TwistOf<World>::Zero());
  }
  take_out(is_implicit, loops);
  for (int r = 0; r < loops.rows; ++r)
    loops.entry(r, r) += loops.states[static_cast<std::size_t>(r)].compliance;
  factorise(loops);
  keep_first_pivots(*data.progress, loops);
  solve_half(loops, loops.half);
  solve_half(loops, loops.half_hub);
  for (int r = 0; r < loops.rows; ++r) {
    const auto k = static_cast<std::size_t>(r);
    effective.mass += loops.half_hub[k] * loops.half_hub[k].transpose();
    effective.force += loops.half[k] * loops.half_hub[k];
  }
}

template <class World>
void calc_loop_forces(SubsystemData<World>& data) noexcept {
  LoopData<World>& loops = data.loops;
  const bool is_implicit = data.progress->control.is_implicit;
  const TwistOf<World>& hub = *data.hub_acceleration;
  for (int r = loops.rows; r-- > 0;) {
    const auto k = static_cast<std::size_t>(r);
    if (!is_solved(loops.use[k], is_implicit)) continue;
    double sum = loops.half[k] - loops.half_hub[k].dot(hub);
    for (int c = r + 1; c < loops.rows; ++c)
      if (is_solved(loops.use[static_cast<std::size_t>(c)], is_implicit))
        sum -= loops.entry(c, r) * loops.multipliers[static_cast<std::size_t>(c)];
    loops.multipliers[k] = sum / loops.entry(r, r);
  }
}

template <class World>
void put_loop_wrenches(const Subsystem<World>& subsystem, SubsystemData<World>& data) noexcept {
  LoopData<World>& loops = data.loops;
  for (std::size_t k = 0; k < subsystem.loops.size(); ++k) {
    const LoopModel& loop = subsystem.loops[k];
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
      const double opening = std::abs(state.opening) / (row.is_length() ? length : 1.0);
      if (use == LoopRowUse::solved) report.opening = std::max(report.opening, opening);
      if (use == LoopRowUse::dropped) report.dropped = std::max(report.dropped, opening);
      is_finite = is_finite && std::isfinite(loops.multipliers[r] + opening);
      const double left = loops.pivots[r] / first[r];
      if (is_solved(use, is_implicit) && !(left >= report.least_pivot)) {
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

template void allocate_loops(const Subsystem<Plane>&, SubsystemData<Plane>&);
template void factorise_loops(SubsystemData<Plane>&) noexcept;
template void calc_loop_forces(SubsystemData<Plane>&) noexcept;
template void put_loop_wrenches(const Subsystem<Plane>&, SubsystemData<Plane>&) noexcept;
template void report_loops(const Subsystem<Plane>&, double, SubsystemData<Plane>&) noexcept;
template void keep_loop_loads(SubsystemData<Plane>&) noexcept;
template void allocate_loops(const Subsystem<Space>&, SubsystemData<Space>&);
template void factorise_loops(SubsystemData<Space>&) noexcept;
template void calc_loop_forces(SubsystemData<Space>&) noexcept;
template void put_loop_wrenches(const Subsystem<Space>&, SubsystemData<Space>&) noexcept;
template void report_loops(const Subsystem<Space>&, double, SubsystemData<Space>&) noexcept;
template void keep_loop_loads(SubsystemData<Space>&) noexcept;

}  // namespace spoke
