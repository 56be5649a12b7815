#pragma once

// Places at a frame of points that are fixed to the nodes of a scene.

#include <vector>

#include "engine/output/scene/frame.h"

namespace spoke::scene {

/// A scene at a frame, in the frame of the hub. Both must outlive it.
class Deformed {
 public:
  Deformed(const Scene& scene, const Frame& frame);

  /// Returns the place of a node, and its rotation from the undeformed scene.
  const spatial::Placement& node(int k) const { return nodes_[static_cast<std::size_t>(k)]; }
  /// Returns place and rotation of any place; between two nodes by Hermite cubics, whose tangents
  /// turn with the nodes.
  spatial::Placement at(const Place& place) const;

 private:
  const Scene& scene_;
  const Frame& frame_;
  std::vector<spatial::Placement> nodes_;
};

/// Returns the place of a drawn node of a solid in the frame of the hub; `m`: index of the solid.
Vector place_of(const Scene& scene, const Frame& frame, const Deformed& deformed, std::size_t m,
                std::size_t k);
/// Returns its displacement from where it is with all bodies undeformed and joints as they are.
Vector displacement_of(const Scene& scene, const Frame& frame, const Deformed& deformed,
                       std::size_t m, std::size_t k);

}  // namespace spoke::scene
