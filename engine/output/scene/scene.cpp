// Sizes of scenes.

#include "engine/output/scene/scene.h"

#include <algorithm>

namespace spoke::scene {

std::size_t Scene::element_count() const {
  std::size_t count = 0;
  for (const Strip& strip : strips) count += static_cast<std::size_t>(strip.nodes) - 1;
  return count;
}

double Scene::radius() const {
  double radius = 0.0;
  for (const Node& node : nodes) radius = std::max(radius, node.p.norm());
  for (const Solid& solid : solids)
    for (const Vector& vertex : solid.vertices) radius = std::max(radius, vertex.norm());
  for (const MeshBody& mesh : meshes) {
    const Node& frame = nodes[static_cast<std::size_t>(mesh.node)];
    for (const Vector& p : surfaces[static_cast<std::size_t>(mesh.surface)].places)
      radius = std::max(radius, (frame.p + frame.axes * p).norm());
  }
  return radius;
}

}  // namespace spoke::scene
