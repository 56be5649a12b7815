#pragma once

// A model in steady rotation as data of a page, which engine/report/steady_states.js reads.

#include <vector>

#include "engine/equilibrium.h"
#include "engine/modes.h"
#include "engine/scene/scene.h"
#include "models/support/json.h"

namespace spoke::steady_report {

class SteadyScene {
 public:
  /// `result`: of the scenario's model. Of bodies with many elements every few nodes are shown, see
  /// scene::make_scene().
  SteadyScene(const Scenario& scenario, const EquilibriumResult& result, std::size_t most_nodes);

  /// What is drawn, undeformed.
  Json describe() const;
  /// Where it stands: motions of groups of bodies, displacements and rotations of nodes; undeformed
  /// if `result` has no blades.
  Json describe(const EquilibriumResult& result) const;
  /// How a mode about it moves it: names, frequency [Hz], damping ratio, the motion of the hub, and
  /// relative to the hub that of the trees which are in it.
  Json describe(const Mode& mode, const EquilibriumResult& result) const;

 private:
  scene::Scene scene_;
  std::vector<std::size_t> places_;  ///< by node of the scene: among those of its blade
};

}  // namespace spoke::steady_report
