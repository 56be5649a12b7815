#pragma once

// A hub and the forces of its subsystems, as the kernels of its equation read them.

#include <span>

#include "engine/bodies/kernels/hub_motion.h"
#include "engine/bodies/kernels/hub_solve.h"
#include "engine/bodies/tree/joint_elimination.h"

namespace spoke::space::testing {

/// The table of a hub, which stays in place. Members that are not set are zero; hub.support and
/// hub.drive must be set.
struct HubTable {
  explicit HubTable(std::span<const tree::HubShare<Space>> shares = {}) : data() {
    data.progress.assign(1, {});
    data.hub_storage.fill(Twist::Zero());
    data.hub_coordinates.a = data.hub_storage[2].data();
    data.hub = {Position::Zero(), {}, Twist::Zero()};
    data.subsystems = std::vector<SubsystemData<Space>>(shares.size());
    for (std::size_t i = 0; i < shares.size(); ++i)
      data.subsystems[i].effective = {shares[i].mass.matrix(), shares[i].force, {}};
  }

  /// Returns Y'' and the reaction.
  const HubSolution<Space>& solve() {
    solve_hub(system, data);
    return data.hub_solution;
  }

  System<Space> system;
  StepData<Space> data;
};

}  // namespace spoke::space::testing
