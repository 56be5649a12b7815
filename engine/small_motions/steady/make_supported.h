#pragma once

// Makes the models of rotors on a support, of the rotors alone, and of a system.

#include <memory>
#include <vector>

#include "engine/small_motions/steady/steady_system.h"
#include "engine/step/loops/loop_start.h"
#include "models/space/space.h"
#include "models/system/system.h"
#include "models/tree/tree.h"

namespace spoke::steady {

/// The wind that does not change, of a scenario whose own does.
struct SteadyWinds {
  std::vector<Wind> of_rotors;  ///< by rotor; empty: the scenario's
  /// At each place that stands; null: the scenario's.
  const Wind* at_places = nullptr;
};

/// Makes a model of a system as it is. `trees`: its own; `blades`: how many of them are blades.
std::unique_ptr<SteadySystem<Space>> make_space(const System<Space>& system,
                                                const std::vector<Sensor>& sensors,
                                                const std::vector<spatial::Tree>& trees,
                                                std::size_t blades, const LoopLimits& loops,
                                                const SteadyOptions& options);
/// Makes a model of a system, or of a part of a machine, in which subsystems that loops tie are
/// one.
std::unique_ptr<SteadyModel> make_part(const System<Space>& system,
                                       const std::vector<Sensor>& sensors,
                                       const std::vector<spatial::Tree>& trees, std::size_t blades,
                                       const LoopLimits& loops, const SteadyOptions& options);

/// Makes the model of the rotors of a scenario on their support.
std::unique_ptr<SteadyModel> make_supported(const Scenario& scenario, const SteadyWinds& winds,
                                            const SteadyOptions& options);

/// Makes the model of one of them alone, whose axle stands as on the undeformed support;
/// `options.speed` is its speed.
std::unique_ptr<SteadyModel> make_single_rotor(const Scenario& scenario, int rotor,
                                               const SteadyOptions& options);

}  // namespace spoke::steady
