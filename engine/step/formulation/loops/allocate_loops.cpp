// Finds which bodies the loops of a subsystem load, which loops meet, and in what order their rows
// are eliminated; allocates them.

#include <algorithm>
#include <cassert>
#include <utility>

#include "engine/step/formulation/loops/loops.h"

namespace spoke {
namespace {

/// Finds the bodies that carry a loop, and the joints of their children.
template <class World>
LoopPath find_path(const Subsystem<World>& subsystem, const LoopModel& loop) {
  LoopPath path;
  path.rows = static_cast<int>(loop.rows.size());
  std::vector<int> carriers{loop.from.body, loop.to.body};
  for (const CoupledCoordinate& at : loop.coupled) carriers.push_back(at.body);
  for (const int carrier : carriers)
    for (int j = carrier; j >= 0; j = subsystem.bodies[static_cast<std::size_t>(j)].parent)
      path.bodies.push_back(j);
  std::sort(path.bodies.begin(), path.bodies.end(), std::greater<>());
  path.bodies.erase(std::unique(path.bodies.begin(), path.bodies.end()), path.bodies.end());
  for (const int j : path.bodies) {
    const TreeBody<World>& body = subsystem.bodies[static_cast<std::size_t>(j)];
    for (std::size_t o = body.children.size(); o > 0; --o) {
      const int child = body.children[o - 1];
      path.joints.push_back({j, child, static_cast<int>(o), path.place_of(child)});
    }
    path.handles = std::max(path.handles, static_cast<int>(body.children.size()) + 1);
    if (body.parent < 0) path.roots.push_back(j);
  }
  return path;
}

/// Adds the rows of a loop to those of all.
template <class World>
void add_rows(const LoopModel& loop, LoopData<World>& loops) {
  for (const LoopRow& row : loop.rows) {
    loops.use.push_back(row.is_rigid() ? LoopRowUse::solved : LoopRowUse::sprung);
    loops.level.push_back(loop.is_share      ? LoopRowLevel::share
                          : loop.is_shared() ? LoopRowLevel::base
                                             : LoopRowLevel::here);
    loops.closed += loops.is_closed(loops.level.size() - 1);
  }
}

/// Finds paths and how rows take part. Columns of loops follow one another.
template <class World>
void list_paths(const Subsystem<World>& subsystem, LoopData<World>& loops) {
  int first_row = 0;
  std::size_t first_joint = 0, first_branch = 0, first_handle = 0;
  for (const LoopModel& loop : subsystem.loops) {
    LoopPath& path = loops.paths.emplace_back(find_path(subsystem, loop));
    path.first_row = std::exchange(first_row, first_row + path.rows);
    path.first_joint = std::exchange(first_joint, first_joint + path.columns());
    path.first_branch = std::exchange(first_branch, first_branch + path.branches());
    path.first_handle =
        std::exchange(first_handle, first_handle + static_cast<std::size_t>(path.handles));
    loops.last_body = std::max(loops.last_body, path.bodies.front());  // from the tips on
    for (const CoupledCoordinate& at : loop.coupled) loops.coupled.push_back(at.body);
    if (loop.bearing) loops.bearings.push_back(path.first_row);
    add_rows(loop, loops);
  }
}

/// Finds which loops share a body: those that share a root, since a path leads to its roots.
template <class World>
void list_meetings(const Subsystem<World>& subsystem, LoopData<World>& loops) {
  std::vector<std::vector<int>> at_root(subsystem.bodies.size());
  for (std::size_t k = 0; k < loops.paths.size(); ++k) {
    std::vector<int>& own = loops.meets.emplace_back();
    for (const int root : loops.paths[k].roots) {
      std::vector<int>& there = at_root[static_cast<std::size_t>(root)];
      there.push_back(static_cast<int>(k));
      own.insert(own.end(), there.begin(), there.end());
    }
    std::sort(own.begin(), own.end());
    own.erase(std::unique(own.begin(), own.end()), own.end());
  }
}

/// Whether the subsystem solves for the forces of a loop.
template <class World>
bool is_closed(const LoopData<World>& loops, std::size_t loop) {
  return loops.is_closed(static_cast<std::size_t>(loops.paths[loop].first_row));
}

/// Returns the loops in the order of elimination: those that are solved here first.
template <class World>
std::vector<int> order_loops(const LoopData<World>& loops,
                             const std::vector<std::vector<int>>& neighbours) {
  std::vector<int> closed, order, place(loops.paths.size(), -1);
  for (std::size_t k = 0; k < loops.paths.size(); ++k)
    if (is_closed(loops, k)) {
      place[k] = static_cast<int>(closed.size());
      closed.push_back(static_cast<int>(k));
    }
  std::vector<std::vector<int>> among(closed.size());
  std::vector<int> sizes;
  for (std::size_t a = 0; a < closed.size(); ++a) {
    const auto loop = static_cast<std::size_t>(closed[a]);
    sizes.push_back(loops.paths[loop].rows);
    for (const int b : neighbours[loop])
      if (place[static_cast<std::size_t>(b)] >= 0)
        among[a].push_back(place[static_cast<std::size_t>(b)]);
  }
  for (const int k : find_low_order(among, sizes))
    order.push_back(closed[static_cast<std::size_t>(k)]);
  for (std::size_t k = 0; k < loops.paths.size(); ++k)
    if (!is_closed(loops, k)) order.push_back(static_cast<int>(k));
  return order;
}

/// Returns by loop those others that share a body with it.
template <class World>
std::vector<std::vector<int>> list_neighbours(const LoopData<World>& loops) {
  std::vector<std::vector<int>> neighbours(loops.paths.size());
  for (std::size_t a = 0; a < neighbours.size(); ++a)
    for (const int b : loops.meets[a]) {
      if (std::cmp_equal(a, b)) continue;
      neighbours[a].push_back(b);
      neighbours[static_cast<std::size_t>(b)].push_back(static_cast<int>(a));
    }
  return neighbours;
}

}  // namespace

template <class World>
std::vector<int> order_rows(const std::vector<std::vector<int>>& neighbours,
                            LoopData<World>& loops) {
  loops.place_of.resize(loops.use.size());
  for (const int k : order_loops(loops, neighbours)) {
    const LoopPath& path = loops.paths[static_cast<std::size_t>(k)];
    for (int row = path.first_row; row < path.first_row + path.rows; ++row) {
      loops.place_of[static_cast<std::size_t>(row)] = static_cast<int>(loops.row_at.size());
      loops.row_at.push_back(row);
    }
  }
  std::vector<int> first(loops.use.size());
  for (std::size_t a = 0; a < neighbours.size(); ++a) {
    const auto place_of_loop = [&loops](std::size_t k) {
      return loops.place_of[static_cast<std::size_t>(loops.paths[k].first_row)];
    };
    int column = place_of_loop(a);
    for (const int b : neighbours[a])
      column = std::min(column, place_of_loop(static_cast<std::size_t>(b)));
    const auto begin = first.begin() + place_of_loop(a);
    std::fill(begin, begin + loops.paths[a].rows, column);
  }
  return first;
}

template <class World>
void allocate_loops(const Subsystem<World>& subsystem, SubsystemData<World>& data) {
  LoopData<World>& loops = data.loops;
  loops = {};
  loops.rows = subsystem.loop_rows();
  if (loops.rows == 0) return;
  list_paths(subsystem, loops);
  list_meetings(subsystem, loops);
  Arena& arena = *data.arena;
  const TwistOf<World> none = TwistOf<World>::Zero();
  const auto rows = static_cast<std::size_t>(loops.rows);
  const LoopPath& last = loops.paths.back();
  loops.poses = ArenaVector<PoseOf<World>>(data.bodies.size(), arena);
  loops.accelerations = ArenaVector<TwistOf<World>>(data.bodies.size(), none, arena);
  loops.states = ArenaVector<LoopRowState<World>>(rows, arena);
  for (auto* of_joints : {&loops.joints, &loops.joint_forces})
    *of_joints = ArenaVector<TwistOf<World>>(last.first_joint + last.columns(), none, arena);
  loops.hub = ArenaVector<TwistOf<World>>(rows, none, arena);
  loops.free = ArenaVector<double>(rows, 0.0, arena);
  loops.branches = ArenaVector<TwistOf<World>>(last.first_branch + last.branches(), none, arena);
  loops.scratch = ArenaVector<TwistOf<World>>(
      last.first_handle + static_cast<std::size_t>(last.handles), none, arena);
  loops.matrix = Skyline(order_rows(list_neighbours(loops), loops), arena);
  loops.half_hub = ArenaVector<TwistOf<World>>(rows, none, arena);
  loops.half = ArenaVector<double>(rows, 0.0, arena);
  for (auto* pivots : {&loops.pivots, &loops.first_explicit, &loops.first_implicit})
    *pivots = ArenaVector<double>(rows, 1.0, arena);
  loops.multipliers = ArenaVector<double>(rows, 0.0, arena);
  loops.kept_multipliers = ArenaVector<double>(rows, 0.0, arena);
  const PartMaker& maker = data.part_maker;
  LoopParts& parts = data.parts.loops;
  parts.motion = maker.cover(
      "loop motion", Mark::none, loops.poses,
      memory_of(loops.accelerations.data(), static_cast<std::size_t>(loops.last_body + 1)),
      loops.states);
  parts.factor = maker.cover("loop factor", Mark::none, loops.multipliers);
  parts.report = maker.cover("loop report", Mark::reported, loops.report);
  maker.add(data.parts.joint_loads, loops.kept_multipliers);
}

template <class World>
graph::PartId declare_loop_rows(std::size_t k, SubsystemData<World>& data) {
  LoopData<World>& loops = data.loops;
  const auto rows = static_cast<std::size_t>(loops.paths[k].rows);
  const int row = loops.paths[k].first_row;
  data.parts.loops.columns.push_back(
      maker_of_loop(k, data).cover("columns", Mark::none, memory_of(loops.hub.data() + row, rows),
                                   memory_of(loops.free.data() + row, rows)));
  return data.parts.loops.columns.back();
}

template <class World>
void declare_loop_matrix(SubsystemData<World>& data) {
  LoopData<World>& loops = data.loops;
  if (loops.is_empty()) return;
  const PartMaker& maker = data.part_maker;
  LoopParts& parts = data.parts.loops;
  maker.add(parts.factor, loops.matrix.values(), loops.half_hub, loops.half, loops.pivots);
  parts.first_pivots =
      maker.cover("first pivots of loops", Mark::state, loops.first_explicit, loops.first_implicit);
}

template std::vector<int> order_rows(const std::vector<std::vector<int>>&, LoopData<Plane>&);
template std::vector<int> order_rows(const std::vector<std::vector<int>>&, LoopData<Space>&);
template graph::PartId declare_loop_rows(std::size_t, SubsystemData<Plane>&);
template graph::PartId declare_loop_rows(std::size_t, SubsystemData<Space>&);
template void declare_loop_matrix(SubsystemData<Plane>&);
template void declare_loop_matrix(SubsystemData<Space>&);
template void allocate_loops(const Subsystem<Plane>&, SubsystemData<Plane>&);
template void allocate_loops(const Subsystem<Space>&, SubsystemData<Space>&);

}  // namespace spoke
