// Interpolates places between nodes.

#include "engine/output/scene/deformed.h"

#include <cassert>

#include "engine/bodies/space/solid_output.h"
#include "models/space/beam_element.h"
#include "models/space/rotation_vector.h"

namespace spoke::scene {

using spatial::Placement;
using spatial::Tensor;

Deformed::Deformed(const Scene& scene, const Frame& frame) : scene_(scene), frame_(frame) {
  assert(frame.rotations.size() == scene.nodes.size());
  for (std::size_t k = 0; k < scene.nodes.size(); ++k) {
    const Placement& group = frame.groups[static_cast<std::size_t>(scene.nodes[k].group)];
    nodes_.push_back(
        {frame.place(scene, k), space::exponential(frame.rotations[k]).axes * group.rotation});
  }
}

Placement Deformed::at(const Place& place) const {
  if (place.node < 0) {
    const Placement& group = frame_.groups[static_cast<std::size_t>(place.group)];
    return {group.position + group.rotation * place.p, group.rotation};
  }
  const auto k = static_cast<std::size_t>(place.node);
  const Placement& a = nodes_[k];
  if (place.xi == 0.0) return {a.position + a.rotation * (place.p - scene_.nodes[k].p), a.rotation};
  const Placement& b = nodes_[k + 1];
  const Vector chord = scene_.nodes[k + 1].p - scene_.nodes[k].p;
  const Eigen::Vector4d weights = space::hermite(place.xi, 1.0);
  const Vector axis = weights[0] * a.position + weights[1] * (a.rotation * chord) +
                      weights[2] * b.position + weights[3] * (b.rotation * chord);
  const Vector rotation =
      (1.0 - place.xi) * frame_.rotations[k] + place.xi * frame_.rotations[k + 1];
  const Placement& group = frame_.groups[static_cast<std::size_t>(scene_.nodes[k].group)];
  const Tensor R = space::exponential(rotation).axes * group.rotation;
  return {axis + R * (place.p - scene_.nodes[k].p - place.xi * chord), R};
}

Vector place_of(const Scene& scene, const Frame& frame, const Deformed& deformed, std::size_t m,
                std::size_t k) {
  const MeshBody& mesh = scene.meshes[m];
  const Surface& surface = scene.surfaces[static_cast<std::size_t>(mesh.surface)];
  Vector x = surface.places[k];
  if (surface.recovery && m < frame.solids.size() && !frame.solids[m].empty())
    x += surface.recovery->displacement(static_cast<int>(k), frame.solids[m].data());
  const Placement& at = deformed.node(mesh.node);
  return at.position + at.rotation * scene.nodes[static_cast<std::size_t>(mesh.node)].axes * x;
}

Vector displacement_of(const Scene& scene, const Frame& frame, const Deformed& deformed,
                       std::size_t m, std::size_t k) {
  const MeshBody& mesh = scene.meshes[m];
  const Node& node = scene.nodes[static_cast<std::size_t>(mesh.node)];
  const Placement& group = frame.groups[static_cast<std::size_t>(node.group)];
  const Vector& x = scene.surfaces[static_cast<std::size_t>(mesh.surface)].places[k];
  return place_of(scene, frame, deformed, m, k) -
         (group.position + group.rotation * (node.p + node.axes * x));
}

}  // namespace spoke::scene
