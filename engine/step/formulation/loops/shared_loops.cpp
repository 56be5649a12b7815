// Gathers the rows of loops between subsystems, and hands their forces out again.

#include "engine/step/formulation/loops/shared_loops.h"

#include <algorithm>
#include <cassert>
#include <set>
#include <utility>

namespace spoke {
namespace {

const LoopPath& path_of(const auto& data, const LoopAt& at) {
  return data.subsystems[static_cast<std::size_t>(at.subsystem)]
      .loops.paths[static_cast<std::size_t>(at.loop)];
}

/// Calls `visit(share)` for the loop itself and its shares.
template <class Visit>
void for_shares(const SharedLoop& loop, Visit&& visit) {
  visit(loop.own);
  for (const LoopAt& at : loop.ends) visit(at);
  for (const LoopAt& at : loop.on_hubs) visit(at);
}

/// Whether the hub of the system carries a subsystem.
template <class World>
bool is_at_base(const System<World>& system, int subsystem) {
  return system.subsystems[static_cast<std::size_t>(subsystem)].rotor < 0;
}

/// Calls `visit(share on the hub, share of a subsystem of the rotor)` for what comes through the
/// hub of a rotor, from its subsystems and what these carry, loop by loop.
template <class World, class Visit>
void for_rows_on_hub(const System<World>& system, int rotor, Visit&& visit) {
  for (const SharedLoop& loop : system.shared_loops)
    for (const SharedLoop::OnHub& on_hub : loop.on_hubs) {
      if (on_hub.rotor != rotor) continue;
      for_shares(loop, [&](const LoopAt& of) {
        if (system.subsystems[static_cast<std::size_t>(of.subsystem)].rotor == rotor)
          visit(on_hub, of);
      });
    }
}

/// Calls `visit(row of the subsystem, row of all)` for the rows that a subsystem hands up.
template <class World, class Visit>
void for_open_rows(const System<World>& system, int subsystem, const StepData<World>& data,
                   Visit&& visit) {
  for (std::size_t k = 0; k < system.shared_loops.size(); ++k) {
    const LoopPath& of_all = data.shared_loops.rows.paths[k];
    for_shares(system.shared_loops[k], [&](const LoopAt& share) {
      if (share.subsystem != subsystem) return;
      const LoopPath& own = path_of(data, share);
      for (int row = 0; row < own.rows; ++row) visit(own.first_row + row, of_all.first_row + row);
    });
  }
}

/// Returns by loop those others that visit a subsystem on the system's hub together with it.
template <class World>
std::vector<std::vector<int>> list_neighbours(const System<World>& system) {
  const std::size_t count = system.shared_loops.size();
  std::vector<std::set<int>> tops(count);
  for (std::size_t k = 0; k < count; ++k)
    for_shares(system.shared_loops[k], [&](const LoopAt& share) {
      if (is_at_base(system, share.subsystem)) tops[k].insert(share.subsystem);
    });
  std::vector<std::vector<int>> neighbours(count);
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t b = 0; b < count; ++b)
      if (a != b &&
          std::any_of(tops[a].begin(), tops[a].end(), [&](int i) { return tops[b].contains(i); }))
        neighbours[a].push_back(static_cast<int>(b));
  return neighbours;
}

}  // namespace

template <class World>
void allocate_shared_loops(const System<World>& system, StepData<World>& data) {
  SharedLoopData<World>& shared = data.shared_loops;
  shared = {};
  if (system.shared_loops.empty()) return;
  LoopData<World>& rows = shared.rows;
  std::set<int> tops, visited;
  for (const SharedLoop& loop : system.shared_loops) {
    LoopPath& path = rows.paths.emplace_back();
    path.first_row = rows.rows;
    path.rows = path_of(data, loop.own).rows;
    rows.rows += path.rows;
    const auto& owner = system.subsystems[static_cast<std::size_t>(loop.own.subsystem)];
    if (owner.loops[static_cast<std::size_t>(loop.own.loop)].bearing)
      rows.bearings.push_back(path.first_row);
    for_shares(loop, [&](const LoopAt& share) {
      visited.insert(share.subsystem);
      if (is_at_base(system, share.subsystem)) tops.insert(share.subsystem);
    });
  }
  shared.subsystems.assign(tops.begin(), tops.end());
  shared.visited.assign(visited.begin(), visited.end());
  const auto count = static_cast<std::size_t>(rows.rows);
  rows.use.assign(count, LoopRowUse::solved);
  rows.level.assign(count, LoopRowLevel::here);
  rows.closed = rows.rows;
  Arena& arena = *data.subsystems[static_cast<std::size_t>(shared.subsystems.front())].arena;
  const TwistOf<World> none = TwistOf<World>::Zero();
  rows.states = ArenaVector<LoopRowState<World>>(count, arena);
  rows.matrix = Skyline(order_rows(list_neighbours(system), rows), arena);
  for (auto* columns : {&rows.hub, &rows.half_hub})
    *columns = ArenaVector<TwistOf<World>>(count, none, arena);
  for (auto* values : {&rows.free, &rows.half, &rows.multipliers})
    *values = ArenaVector<double>(count, 0.0, arena);
  for (auto* pivots : {&rows.pivots, &rows.first_explicit, &rows.first_implicit})
    *pivots = ArenaVector<double>(count, 1.0, arena);
  const PartMaker maker(data.all_parts);
  data.parts.shared_loops = maker.cover(
      "shared loops", Mark::none, rows.states, rows.hub, rows.free, rows.half_hub, rows.half,
      rows.pivots, rows.multipliers, rows.matrix.values(), shared.mass, shared.force);
  data.parts.first_pivots =
      maker.cover("first pivots of loops", Mark::state, rows.first_explicit, rows.first_implicit);
}

template <class World>
void take_uses_of_shared_loops(const System<World>& system, StepData<World>& data) {
  for (std::size_t k = 0; k < system.shared_loops.size(); ++k) {
    const SharedLoop& loop = system.shared_loops[k];
    const LoopPath& own = path_of(data, loop.own);
    const auto& use = data.subsystems[static_cast<std::size_t>(loop.own.subsystem)].loops.use;
    const auto copy_to = [&](std::vector<LoopRowUse>& to, int first) {
      std::copy_n(use.begin() + own.first_row, own.rows, to.begin() + first);
    };
    copy_to(data.shared_loops.rows.use, data.shared_loops.rows.paths[k].first_row);
    for_shares(loop, [&](const LoopAt& share) {
      if (share.subsystem != loop.own.subsystem || share.loop != loop.own.loop)
        copy_to(data.subsystems[static_cast<std::size_t>(share.subsystem)].loops.use,
                path_of(data, share).first_row);
    });
  }
}

template <class World>
void put_rows_on_hub(const System<World>& system, std::size_t rotor,
                     StepData<World>& data) noexcept {
  const auto support = static_cast<std::size_t>(system.rotors[rotor].subsystem);
  LoopData<World>& loops = data.subsystems[support].loops;
  for_rows_on_hub(system, static_cast<int>(rotor), [&](const LoopAt& on_hub, const LoopAt& share) {
    const LoopPath &path = path_of(data, on_hub), &below = path_of(data, share);
    const LoopData<World>& from = data.subsystems[static_cast<std::size_t>(share.subsystem)].loops;
    for (int row = 0; row < path.rows; ++row) {
      LoopRowState<World>& state = loops.states[static_cast<std::size_t>(path.first_row + row)];
      const auto p =
          static_cast<std::size_t>(from.place_of[static_cast<std::size_t>(below.first_row + row)]);
      state.from += from.half_hub[p];
      state.target += from.half[p];
    }
  });
}

template <class World>
PartList parts_of_rows_on_hub(const System<World>& system, std::size_t rotor,
                              const StepData<World>& data) {
  PartList list;
  for_rows_on_hub(system, static_cast<int>(rotor), [&](const LoopAt&, const LoopAt& share) {
    list.push_back(data.subsystems[static_cast<std::size_t>(share.subsystem)].parts.loops.factor);
  });
  return list;
}

template <class World>
PartList parts_with_rows_on_hub(const System<World>& system, std::size_t rotor,
                                const StepData<World>& data) {
  if (parts_of_rows_on_hub(system, rotor, data).empty()) return {};
  const auto support = static_cast<std::size_t>(system.rotors[rotor].subsystem);
  return {data.subsystems[support].parts.loops.motion};
}

template <class World>
void add_handed_up(const System<World>& system, std::size_t i, StepData<World>& data) noexcept {
  LoopData<World>& loops = data.subsystems[i].loops;
  const auto add = [&](const LoopAt& a, const LoopAt& from_a, const LoopAt& b,
                       const LoopAt& from_b) {
    if (from_a.subsystem != from_b.subsystem) return;
    const LoopData<World>& from = data.subsystems[static_cast<std::size_t>(from_a.subsystem)].loops;
    const LoopPath &rows = path_of(data, a), &columns = path_of(data, b);
    const LoopPath &of_a = path_of(data, from_a), &of_b = path_of(data, from_b);
    for (int r = 0; r < rows.rows; ++r)
      for (int c = 0; c < columns.rows; ++c) {
        if (rows.first_row + r < columns.first_row + c) continue;  // of the other triangle
        const double value = from.value(of_a.first_row + r, of_b.first_row + c);
        if (value != 0.0) loops.entry(rows.first_row + r, columns.first_row + c) += value;
      }
  };
  for (int rotor = 0; std::cmp_less(rotor, system.rotors.size()); ++rotor) {
    if (!std::cmp_equal(system.rotors[static_cast<std::size_t>(rotor)].subsystem, i)) continue;
    for_rows_on_hub(system, rotor, [&](const LoopAt& a, const LoopAt& from_a) {
      for_rows_on_hub(system, rotor,
                      [&](const LoopAt& b, const LoopAt& from_b) { add(a, from_a, b, from_b); });
    });
  }
}

template <class World>
PartList parts_of_handed_up(const System<World>& system, std::size_t i,
                            const StepData<World>& data) {
  PartList list;
  for (const int rotor : find_rotors_on(system, static_cast<int>(i)))
    graph::add_to(list, parts_of_rows_on_hub(system, static_cast<std::size_t>(rotor), data));
  return list;
}

namespace {

/// Takes what the loops ask for, by the states that their own subsystems have.
template <class World>
void take_states(const System<World>& system, StepData<World>& data) {
  LoopData<World>& rows = data.shared_loops.rows;
  for (std::size_t k = 0; k < system.shared_loops.size(); ++k) {
    const LoopAt& own = system.shared_loops[k].own;
    const auto& states = data.subsystems[static_cast<std::size_t>(own.subsystem)].loops.states;
    std::copy_n(states.begin() + path_of(data, own).first_row, rows.paths[k].rows,
                rows.states.begin() + rows.paths[k].first_row);
  }
}

/// Adds what a subsystem hands up.
template <class World>
void gather(const System<World>& system, int subsystem, StepData<World>& data) {
  LoopData<World>& rows = data.shared_loops.rows;
  const LoopData<World>& from = data.subsystems[static_cast<std::size_t>(subsystem)].loops;
  for_open_rows(system, subsystem, data, [&](int r, int to) {
    const auto p = static_cast<std::size_t>(from.place_of[static_cast<std::size_t>(r)]);
    rows.hub[static_cast<std::size_t>(to)] += from.half_hub[p];
    rows.free[static_cast<std::size_t>(to)] -= from.half[p];
    for_open_rows(system, subsystem, data, [&](int c, int other) {
      if (other > to) return;
      const double value = from.value(r, c);
      if (value != 0.0) rows.entry(to, other) += value;
    });
  });
}

}  // namespace

template <class World>
void factorise_shared_loops(const System<World>& system, StepData<World>& data) noexcept {
  SharedLoopData<World>& shared = data.shared_loops;
  shared.mass.setZero();
  shared.force.setZero();
  if (system.shared_loops.empty()) return;
  take_states(system, data);
  for (TwistOf<World>& hub : shared.rows.hub) hub.setZero();
  std::fill(shared.rows.free.begin(), shared.rows.free.end(), 0.0);
  shared.rows.matrix.set_zero();
  for (const int i : shared.subsystems) gather(system, i, data);
  factorise_loops(data.progress[0], shared.rows, shared.mass, shared.force);
}

template <class World>
void calc_shared_forces(const System<World>& system, StepData<World>& data) noexcept {
  if (system.shared_loops.empty()) return;
  LoopData<World>& rows = data.shared_loops.rows;
  const bool is_implicit = data.progress[0].control.is_implicit;
  calc_loop_forces(is_implicit, data.hub_solution.acceleration, rows);
  const auto& first = is_implicit ? rows.first_implicit : rows.first_explicit;
  for (std::size_t k = 0; k < system.shared_loops.size(); ++k) {
    const SharedLoop& loop = system.shared_loops[k];
    const int of_all = rows.paths[k].first_row;
    for_shares(loop, [&](const LoopAt& share) {
      LoopData<World>& own = data.subsystems[static_cast<std::size_t>(share.subsystem)].loops;
      std::copy_n(rows.multipliers.begin() + of_all, rows.paths[k].rows,
                  own.multipliers.begin() + path_of(data, share).first_row);
    });
    // The report of the loop's own subsystem looks at the pivots.
    LoopData<World>& own = data.subsystems[static_cast<std::size_t>(loop.own.subsystem)].loops;
    for (int row = 0; row < rows.paths[k].rows; ++row) {
      const auto p =
          static_cast<std::size_t>(rows.place_of[static_cast<std::size_t>(of_all + row)]);
      const auto r = static_cast<std::size_t>(path_of(data, loop.own).first_row + row);
      own.pivots[static_cast<std::size_t>(own.place_of[r])] = rows.pivots[p] / first[p];
    }
  }
}

template <class World>
PartList parts_of_shared_loops(const StepData<World>& data) {
  PartList list;
  for (const int i : data.shared_loops.visited)
    list.push_back(data.subsystems[static_cast<std::size_t>(i)].parts.loops.motion);
  return list;
}

template <class World>
PartList parts_with_shared_loops(const StepData<World>& data) {
  if (data.shared_loops.rows.is_empty()) return {};
  PartList list{data.parts.shared_loops, data.parts.first_pivots};
  for (const int i : data.shared_loops.visited)
    list.push_back(data.subsystems[static_cast<std::size_t>(i)].parts.loops.factor);
  return list;
}

template void allocate_shared_loops(const System<Plane>&, StepData<Plane>&);
template void take_uses_of_shared_loops(const System<Plane>&, StepData<Plane>&);
template void put_rows_on_hub(const System<Plane>&, std::size_t, StepData<Plane>&) noexcept;
template PartList parts_of_rows_on_hub(const System<Plane>&, std::size_t, const StepData<Plane>&);
template PartList parts_with_rows_on_hub(const System<Plane>&, std::size_t, const StepData<Plane>&);
template void add_handed_up(const System<Plane>&, std::size_t, StepData<Plane>&) noexcept;
template PartList parts_of_handed_up(const System<Plane>&, std::size_t, const StepData<Plane>&);
template void factorise_shared_loops(const System<Plane>&, StepData<Plane>&) noexcept;
template void calc_shared_forces(const System<Plane>&, StepData<Plane>&) noexcept;
template PartList parts_of_shared_loops(const StepData<Plane>&);
template PartList parts_with_shared_loops(const StepData<Plane>&);
template void allocate_shared_loops(const System<Space>&, StepData<Space>&);
template void take_uses_of_shared_loops(const System<Space>&, StepData<Space>&);
template void put_rows_on_hub(const System<Space>&, std::size_t, StepData<Space>&) noexcept;
template PartList parts_of_rows_on_hub(const System<Space>&, std::size_t, const StepData<Space>&);
template PartList parts_with_rows_on_hub(const System<Space>&, std::size_t, const StepData<Space>&);
template void add_handed_up(const System<Space>&, std::size_t, StepData<Space>&) noexcept;
template PartList parts_of_handed_up(const System<Space>&, std::size_t, const StepData<Space>&);
template void factorise_shared_loops(const System<Space>&, StepData<Space>&) noexcept;
template void calc_shared_forces(const System<Space>&, StepData<Space>&) noexcept;
template PartList parts_of_shared_loops(const StepData<Space>&);
template PartList parts_with_shared_loops(const StepData<Space>&);

}  // namespace spoke
