#pragma once

// A scene at one time: where its nodes are, and what its elements bear.

#include <vector>

#include "engine/scene/scene.h"
#include "engine/simulation.h"
#include "models/tree/mass_properties.h"

namespace spoke::scene {

/// A node is where its group takes it, moved on by its displacement and turned on by its rotation,
/// both resolved in the hub's frame. So drawn displacements can be exaggerated, and the motion of
/// joints is as it is.
struct Frame {
  HubPose hub;
  double hub_angle = 0.0;                  ///< about the axle, not reduced to one turn [rad]
  std::vector<spatial::Placement> groups;  ///< motion of each, in the hub's frame
  std::vector<Vector> displacements;       ///< by node [m]
  std::vector<Vector> rotations;           ///< by node, rotation vectors [rad]
  std::vector<double> axial_forces;        ///< by element, in tension positive [N]
  std::vector<double> bending_moments;     ///< by element, magnitudes [N m]

  /// Where a node is in the hub's frame [m].
  Vector place(const Scene& scene, std::size_t node) const;
};

/// Takes frames of a simulation.
class FrameReader {
 public:
  /// The scene is that of the simulation's scenario, and outlives this.
  explicit FrameReader(const Scene& scene) : scene_(scene) {}

  /// The frame at simulation.time(). `frame` keeps its memory from call to call.
  void read(const Simulation& simulation, Frame& frame);
  /// What the last frame was read from. Precondition: the scene is one of space.
  const TreeBodyShape& body_of(const NodeSource& source) const {
    return trees_[static_cast<std::size_t>(source.tree)]
        .bodies[static_cast<std::size_t>(source.body)];
  }

 private:
  void read_blades(const Simulation& simulation, Frame& frame);
  void read_trees(const Simulation& simulation, Frame& frame);
  void read_forces(const Strip& strip, Frame& frame) const;

  const Scene& scene_;
  std::vector<BladeShape> blades_;
  std::vector<TreeShape> trees_;
};

/// The frame at t = 0 of a scenario that is not simulated: undeformed, joints at their initial
/// coordinates.
Frame make_first_frame(const Scenario& scenario, const Scene& scene);

}  // namespace spoke::scene
