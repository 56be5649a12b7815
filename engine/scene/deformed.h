#pragma once

// Where what is fixed to the nodes of a scene is at a frame.

#include <vector>

#include "engine/scene/frame.h"

namespace spoke::scene {

/// A scene at a frame, in the hub's frame. Precondition: both outlive this.
class Deformed {
 public:
  Deformed(const Scene& scene, const Frame& frame);

  /// Of a node: its place, and how it is turned from the undeformed scene.
  const spatial::Placement& node(int k) const { return nodes_[static_cast<std::size_t>(k)]; }
  /// Of any place, likewise; between two nodes by Hermite's cubics, whose tangents turn with the
  /// nodes.
  spatial::Placement at(const Place& place) const;

 private:
  const Scene& scene_;
  const Frame& frame_;
  std::vector<spatial::Placement> nodes_;
};

}  // namespace spoke::scene
