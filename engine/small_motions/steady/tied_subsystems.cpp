// Evaluates subsystems together that loops tie to one another.

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

#include "engine/bodies/kernels/loops/loop_motion.h"
#include "engine/small_motions/steady/steady_loops.h"
#include "engine/small_motions/steady/steady_system.h"

namespace spoke::steady {

template <class World>
std::vector<std::vector<std::size_t>> group_subsystems(const System<World>& system) {
  std::vector<std::size_t> first(system.subsystems.size());
  std::iota(first.begin(), first.end(), std::size_t{0});
  for (const SharedLoop& loop : system.shared_loops)
    for (const LoopAt& end : loop.ends) {
      const std::size_t a = first[static_cast<std::size_t>(loop.own.subsystem)];
      const std::size_t b = first[static_cast<std::size_t>(end.subsystem)];
      std::replace(first.begin(), first.end(), std::max(a, b), std::min(a, b));
    }
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] != i) continue;
    std::vector<std::size_t>& group = groups.emplace_back();
    for (std::size_t k = i; k < first.size(); ++k)
      if (first[k] == i) group.push_back(k);
  }
  return groups;
}

template <class World>
void SteadySystem<World>::evaluate_tied(const std::vector<std::size_t>& group,
                                        const std::vector<SubsystemState>& states,
                                        const HubOffset& hub,
                                        std::vector<SubsystemResponse>& responses) {
  assert(states.size() == group.size());
  responses.resize(group.size());
  for (std::size_t m = 0; m < group.size(); ++m) calc_terms(group[m], states[m], hub);
  calc_shared_motion(context_.system, {}, context_.data);
  for (std::size_t m = 0; m < group.size(); ++m)
    put_loops(context_.system, group[m], states[m], rows_[group[m]], context_.data, responses[m]);
  const auto forces_of = [&](const LoopAt& at) {
    const auto subsystem = static_cast<std::size_t>(at.subsystem);
    const auto place = std::find(group.begin(), group.end(), subsystem) - group.begin();
    assert(place < std::ssize(group));
    return responses[static_cast<std::size_t>(place)].multipliers.data() +
           data(subsystem).loops.paths[static_cast<std::size_t>(at.loop)].first_row;
  };
  for (const SharedLoop& loop : system().shared_loops) {
    const auto own = static_cast<std::size_t>(loop.own.subsystem);
    if (std::find(group.begin(), group.end(), own) == group.end()) continue;
    const int rows = data(own).loops.paths[static_cast<std::size_t>(loop.own.loop)].rows;
    for (const LoopAt& end : loop.ends) std::copy_n(forces_of(loop.own), rows, forces_of(end));
  }
  shared_forces_.resize(subsystems());
  for (std::size_t m = 0; m < group.size(); ++m) {
    shared_forces_[group[m]] = responses[m].multipliers;
    sum_response(group[m], responses[m]);
  }
}

/// Sets the forces of rows that other subsystems share, which a subsystem alone does not find.
template <class World>
void SteadySystem<World>::put_shared_forces(std::size_t subsystem) {
  if (subsystem >= shared_forces_.size()) return;
  const Eigen::VectorXd& forces = shared_forces_[subsystem];
  LoopData<World>& loops = data(subsystem).loops;
  for (Eigen::Index r = 0; r < forces.size(); ++r)
    if (const auto row = static_cast<std::size_t>(r); !loops.is_closed(row))
      loops.multipliers[row] = forces[r];
}

template std::vector<std::vector<std::size_t>> group_subsystems(const System<Plane>&);
template void SteadySystem<Plane>::evaluate_tied(const std::vector<std::size_t>&,
                                                 const std::vector<SubsystemState>&,
                                                 const HubOffset&, std::vector<SubsystemResponse>&);
template void SteadySystem<Plane>::put_shared_forces(std::size_t);
template std::vector<std::vector<std::size_t>> group_subsystems(const System<Space>&);
template void SteadySystem<Space>::evaluate_tied(const std::vector<std::size_t>&,
                                                 const std::vector<SubsystemState>&,
                                                 const HubOffset&, std::vector<SubsystemResponse>&);
template void SteadySystem<Space>::put_shared_forces(std::size_t);

}  // namespace spoke::steady
