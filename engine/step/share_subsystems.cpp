// Finds the places of the table that the processes tell one another, by the subsystems of each.

#include "engine/step/share_subsystems.h"

#include <algorithm>
#include <cassert>
#include <memory>
#include <utility>

#include "engine/bodies/table/state_values.h"
#include "engine/step/pass_integration.h"
#include "graph/access.h"

namespace spoke {
namespace {

using graph::bytes_of;

/// Adds the memory that the steps of the window leave of subsystem `i`, to be recorded and
/// measured.
template <class World>
void add_window(StepData<World>& data, std::size_t i, MemoryPieces& memory) {
  SubsystemData<World>& subsystem = data.subsystems[i];
  if (!data.is_coupled) memory.push_back(bytes_of(data.progress[i]));
  for (std::int64_t step = data.window.first; step <= data.window.last; ++step) {
    if (!data.is_coupled) memory.push_back(bytes_of(of_step(subsystem.records, step)));
    if (!data.window.observed) continue;
    memory.push_back(bytes_of(of_step(subsystem.samples, step)));
    if (subsystem.reading_count > 0)
      memory.push_back(bytes_of(*readings_of(subsystem, step), subsystem.reading_count));
  }
}

/// Returns `memory_of` each subsystem, by rank.
template <class MemoryOf>
std::vector<MemoryPieces> by_rank(const std::vector<int>& first, const MemoryOf& memory_of) {
  std::vector<MemoryPieces> all(first.size() - 1);
  for (std::size_t rank = 0; rank < all.size(); ++rank)
    for (int i = first[rank]; i < first[rank + 1]; ++i) {
      const MemoryPieces memory = memory_of(static_cast<std::size_t>(i));
      all[rank].insert(all[rank].end(), memory.begin(), memory.end());
    }
  return all;
}

/// Estimates the costs of the subsystems: their coordinates, and the frames of their bodies.
template <class World>
std::vector<double> weights_of(const StepData<World>& data) {
  std::vector<double> weights;
  for (const SubsystemData<World>& subsystem : data.subsystems) {
    double weight = 0.0;
    for (const BodyData<World>& body : subsystem.bodies)
      weight += World::kTwist + body.coordinates.size;
    // The columns of a loop go through the bodies that carry it, row by row.
    for (const LoopPath& path : subsystem.loops.paths)
      weight += static_cast<double>(path.rows) * static_cast<double>(path.bodies.size());
    weights.push_back(weight);
  }
  return weights;
}

}  // namespace

template <class World>
void share_out(Exchange& exchange, SystemContext<World>& context) {
  assert(context.formulation != Formulation::augmented && !context.data.has_loads());
  assert(std::cmp_less_equal(exchange.count(), context.data.subsystems.size()));
  StepData<World>& data = context.data;
  const std::vector<int> first = share_out(weights_of(data), exchange.count());
  // All processes condense the supports.
  const auto inertia = [&data, &system = context.system](std::size_t i) {
    if (carries_rotor(system, static_cast<int>(i))) return MemoryPieces{};
    return MemoryPieces{bytes_of(data.subsystems[i].effective)};
  };
  const auto reports = [&data](std::size_t i) {
    return data.all_parts.marked(Mark::reported, static_cast<int>(i));
  };
  const auto state = [&data](std::size_t i) { return state_of_subsystem(data, i); };
  context.sharing = std::make_unique<Sharing>(
      Sharing{exchange, first, SharedPlaces(exchange, by_rank(first, inertia)),
              SharedPlaces(exchange, by_rank(first, reports)),
              SharedPlaces(exchange, by_rank(first, state)), std::nullopt});
  const auto forces = [&data](std::size_t i) {
    ArenaVector<PositionOf<World>>& sums = data.subsystems[i].applied_forces;
    return sums.empty() ? MemoryPieces{} : MemoryPieces{bytes_of(sums.front(), sums.size())};
  };
  const auto has_sums = [](const SubsystemData<World>& s) { return !s.applied_forces.empty(); };
  if (data.subsystems.front().flight_acceleration &&
      std::any_of(data.subsystems.begin(), data.subsystems.end(), has_sums))
    context.sharing->forces.emplace(exchange, by_rank(first, forces));
}

std::span<const StepProgress> StepContext::own_progress() {
  const std::vector<StepProgress>& progress = table().progress;
  if (!sharing || table().is_coupled) return progress;
  return std::span(progress).subspan(
      static_cast<std::size_t>(sharing->own_first()),
      static_cast<std::size_t>(sharing->own_last() - sharing->own_first()));
}

template <class World>
bool SystemContext<World>::share_window(bool asks_to_stop) {
  std::vector<MemoryPieces> places = by_rank(sharing->first, [this](std::size_t i) {
    MemoryPieces memory;
    add_window(data, i, memory);
    return memory;
  });
  std::vector<Flag> asks(places.size());
  asks[static_cast<std::size_t>(sharing->exchange.rank())] = asks_to_stop;
  for (std::size_t rank = 0; rank < places.size(); ++rank)
    places[rank].push_back(bytes_of(asks[rank]));
  SharedPlaces(sharing->exchange, std::move(places)).share();
  if (!data.is_coupled) record_reactions(system, integrator, data);
  return std::any_of(asks.begin(), asks.end(), [](Flag flag) -> bool { return flag; });
}

template void share_out(Exchange&, SystemContext<Plane>&);
template void share_out(Exchange&, SystemContext<Space>&);
template bool SystemContext<Plane>::share_window(bool);
template bool SystemContext<Space>::share_window(bool);

}  // namespace spoke
