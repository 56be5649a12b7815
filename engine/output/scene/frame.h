#pragma once

// A scene at one time: the places of its nodes, and the loads of its elements.

#include <cassert>
#include <vector>

#include "engine/output/scene/scene.h"
#include "engine/simulation.h"
#include "models/tree/mass_properties.h"

namespace spoke::scene {

/// A node is where its group moves it, displaced and turned further by its own displacement and
/// rotation, both resolved in the frame of the hub. So drawings can exaggerate displacements and
/// leave the motion of joints as it is.
struct Frame {
  HubPose hub;
  double hub_angle = 0.0;                   ///< about the axle, not reduced to one turn [rad]
  std::vector<spatial::Placement> groups;   ///< motions, in the hub's frame
  std::vector<Vector> displacements;        ///< by node [m]
  std::vector<Vector> rotations;            ///< by node, rotation vectors [rad]
  std::vector<std::vector<double>> solids;  ///< deformation coordinates, by solid of the scene
  std::vector<double> axial_forces;         ///< by element, in tension positive [N]
  std::vector<double> bending_moments;      ///< by element, magnitudes [N m]

  /// Returns the place of a node in the frame of the hub [m].
  Vector place(const Scene& scene, std::size_t node) const;
};

/// Takes frames of a simulation.
class FrameReader {
 public:
  /// `scene`: that of the scenario of the simulation; must outlive this.
  explicit FrameReader(const Scene& scene) : scene_(scene) {}

  /// Reads the frame at simulation.time(). `frame` keeps its memory from call to call.
  void read(const Simulation& simulation, Frame& frame);
  /// Returns the shape that the last frame was read from. Precondition: the scene is in space.
  const TreeBodyShape& body_of(const NodeSource& source) const {
    assert(source.subsystem >= 0 &&
           static_cast<std::size_t>(source.subsystem) < spatial_shapes_.size());
    return spatial_shapes_[static_cast<std::size_t>(source.subsystem)]
        .bodies[static_cast<std::size_t>(source.body)];
  }

 private:
  void read_plane(const Simulation& simulation, Frame& frame);
  void read_space(const Simulation& simulation, Frame& frame);
  void read_roots(const Simulation& simulation, Frame& frame) const;
  void read_carriers(const Simulation& simulation, Frame& frame) const;
  void read_forces(const Strip& strip, Frame& frame) const;

  const Scene& scene_;
  std::vector<BladeShape> planar_shapes_;
  std::vector<TreeShape> spatial_shapes_;
};

/// Makes the frame at t = 0 of a scenario that is not simulated: undeformed, joints at their
/// initial coordinates.
Frame make_first_frame(const Scenario& scenario, const Scene& scene);

}  // namespace spoke::scene
