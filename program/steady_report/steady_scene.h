#pragma once

// A model in steady rotation as data of a page, which program/report/steady_states.js reads.

#include <vector>

#include "engine/equilibrium.h"
#include "engine/modes.h"
#include "engine/output/scene/frame.h"
#include "models/support/json.h"

namespace spoke::steady_report {

class SteadyScene {
 public:
  /// `result`: that of the scenario's model. Bodies with many elements show every few nodes, see
  /// scene::make_scene().
  SteadyScene(const Scenario& scenario, const EquilibriumResult& result, std::size_t most_nodes);

  /// Describes the undeformed scene.
  Json describe() const;
  /// Describes the equilibrium: motions of groups of bodies, displacements and rotations of nodes;
  /// undeformed if `result` has no blades.
  Json describe(const EquilibriumResult& result) const;
  /// Describes a mode about the equilibrium: names, frequency [Hz], damping ratio, the motion of
  /// the hub, and relative to it that of the trees in the mode.
  Json describe(const Mode& mode, const EquilibriumResult& result) const;

 private:
  /// Returns the placement of the frame in which an equilibrium has a subsystem in that in which it
  /// is drawn: of a support, and of what further rotors on it carry, its base's, else the hub's,
  /// whose z axis need not be that of rotation.
  spatial::Placement to_drawn(int subsystem, const EquilibriumResult& result) const;
  HubShape find_carrier(int subsystem, const Mode& mode, const EquilibriumResult& result) const;
  void put_anchors(const Scenario& scenario, const EquilibriumResult& result);

  scene::Scene scene_;
  Eigen::Matrix3d to_hub_;                 ///< from axes with z along that of rotation
  std::vector<spatial::Placement> first_;  ///< motions of its groups before bodies deform
  std::vector<std::size_t> places_;  ///< places of the scene's nodes among those of their blades
};

}  // namespace spoke::steady_report
