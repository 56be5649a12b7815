// Allocates the memory of the formulation, per subsystem.

#include <utility>

#include "engine/formulation/structured/tree_elimination.h"

namespace spoke::structured {

template <class World>
void allocate(const SubsystemData<World>& data, SubsystemWork<World>& work) {
  Arena& arena = *data.arena;
  work.bodies = ArenaVector<BodyWork<World>>(data.bodies.size(), arena);
  work.root_at.assign(data.bodies.size(), -1);
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    if (data.bodies[j].model->parent >= 0) continue;
    work.root_at[j] = static_cast<int>(work.root_bodies.size());
    work.root_bodies.push_back(static_cast<int>(j));
  }
  work.by_mass = has_rigid_bodies_alone(data);
  for (BodyWork<World>& body : work.bodies) body.by_mass = work.by_mass;
  work.roots = ArenaVector<tree::RootElimination<World>>(work.root_bodies.size(), arena);
  std::size_t total = BodyTypes<World>::Layout::kPad;
  for (const BodyData<World>& body : data.bodies) total += count_condensed(*body.model->body);
  work.storage = ArenaVector<double>(total, 0.0, arena);
  double* next = work.storage.data();
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    const typename World::Body& body = *data.bodies[j].model->body;
    place_condensed(body, std::exchange(next, next + count_condensed(body)), work.bodies[j]);
  }
}

template void allocate(const SubsystemData<Plane>&, SubsystemWork<Plane>&);
template void allocate(const SubsystemData<Space>&, SubsystemWork<Space>&);

}  // namespace spoke::structured
