// Takes shapes of subsystems apart into motions of groups, displacements and rotations.

#include "engine/output/scene/frame.h"

#include <algorithm>
#include <cmath>

#include "models/space/rotation_vector.h"
#include "models/vectors.h"

namespace spoke::scene {
namespace {

using spatial::Placement;
using spatial::Tensor;

void clear(const Scene& scene, Frame& frame) {
  frame.groups.assign(static_cast<std::size_t>(scene.groups), Placement{});
  frame.displacements.clear();
  frame.rotations.clear();
  frame.solids.clear();
  frame.axial_forces.clear();
  frame.bending_moments.clear();
}

}  // namespace

Vector Frame::place(const Scene& scene, std::size_t node) const {
  const Placement& group = groups[static_cast<std::size_t>(scene.nodes[node].group)];
  return group.position + group.rotation * scene.nodes[node].p + displacements[node];
}

void FrameReader::read(const Simulation& simulation, Frame& frame) {
  clear(scene_, frame);
  frame.hub = simulation.hub_pose();
  if (scene_.is_planar)
    read_plane(simulation, frame);
  else
    read_space(simulation, frame);
  read_carriers(simulation, frame);
  for (const Strip& strip : scene_.strips) read_forces(strip, frame);
}

void FrameReader::read_plane(const Simulation& simulation, Frame& frame) {
  frame.hub_angle = simulation.hub().position[kRotation];  // no sensor needs to be evaluated
  planar_shapes_.resize(scene_.subsystems.size());
  for (std::size_t i = 0; i < planar_shapes_.size(); ++i)
    simulation.calc_shape(static_cast<int>(i), planar_shapes_[i]);
  for (const NodeSource& source : scene_.sources) {
    const BladeShape& blade = planar_shapes_[static_cast<std::size_t>(source.subsystem)];
    const ShapeNode& node =
        blade.nodes[static_cast<std::size_t>(source.body * blade.elements + source.node)];
    frame.displacements.emplace_back(node.displacement.x(), node.displacement.y(), 0.0);
    frame.rotations.emplace_back(0.0, 0.0, node.angle);
  }
}

void FrameReader::read_space(const Simulation& simulation, Frame& frame) {
  frame.hub_angle = simulation.sensor("hub.angle");
  spatial_shapes_.resize(scene_.subsystems.size());
  for (std::size_t i = 0; i < spatial_shapes_.size(); ++i)
    simulation.calc_shape(static_cast<int>(i), spatial_shapes_[i]);
  if (scene_.support >= 0) read_roots(simulation, frame);
  for (std::size_t k = 0; k < scene_.sources.size(); ++k) {
    const NodeSource& source = scene_.sources[k];
    const TreeNode& node = body_of(source).nodes[static_cast<std::size_t>(source.node)];
    const int root = scene_.roots[static_cast<std::size_t>(source.subsystem)];
    const Placement& carrier = frame.groups[static_cast<std::size_t>(root)];
    frame.displacements.emplace_back(carrier.rotation * node.displacement);
    frame.rotations.emplace_back(carrier.rotation * node.rotation);
    const Node& drawn = scene_.nodes[k];
    if (drawn.group == root) continue;
    // All nodes of a rigid group show the same motion, but those of hubs, which turn in theirs.
    if (std::any_of(scene_.hubs.begin(), scene_.hubs.end(),
                    [k](const HubFrame& hub) { return hub.node == static_cast<int>(k); }))
      continue;
    const Tensor now = space::exponential(node.rotation).axes.transpose() * node.R;
    Placement& group = frame.groups[static_cast<std::size_t>(drawn.group)];
    group.rotation = now * drawn.axes.transpose();
    group.position = node.p - node.displacement - group.rotation * drawn.p;
    if (root > 0) group = carrier * group;
  }
  for (const MeshBody& mesh : scene_.meshes)
    frame.solids.push_back(
        body_of(scene_.sources[static_cast<std::size_t>(mesh.node)]).coordinates);
}

/// Sets the motions of a support's base and of the hubs on it, in the frame of the first hub.
void FrameReader::read_roots(const Simulation& simulation, Frame& frame) const {
  const MarkerMotion motion = simulation.base_frame();
  const Tensor to_hub = frame.hub.rotation.transpose();
  const Placement base{to_hub * (motion.position - frame.hub.position), to_hub * motion.rotation};
  frame.groups[static_cast<std::size_t>(scene_.base_group)] = base;
  for (std::size_t r = 1; r < scene_.hubs.size(); ++r) {
    const HubFrame& hub = scene_.hubs[r];
    const NodeSource& source = scene_.sources[static_cast<std::size_t>(hub.node)];
    const TreeNode& node = body_of(source).nodes[static_cast<std::size_t>(source.node)];
    const int carrier = scene_.roots[static_cast<std::size_t>(source.subsystem)];
    frame.groups[static_cast<std::size_t>(hub.group)] =
        frame.groups[static_cast<std::size_t>(carrier)] *
        Placement{node.p, node.R * hub.to_hub.transpose()};
  }
}

void FrameReader::read_carriers(const Simulation& simulation, Frame& frame) const {
  const Tensor to_hub = frame.hub.rotation.transpose();
  for (const Carrier& carrier : scene_.carriers) {
    const MarkerMotion motion =
        carrier.anchor < 0 ? simulation.mount_frame() : simulation.anchor_frame(carrier.anchor);
    frame.groups[static_cast<std::size_t>(carrier.group)] = {
        to_hub * (motion.position - frame.hub.position), to_hub * motion.rotation};
  }
}

/// Reads forces of shown elements; where one holds several elements of the model, their mean.
void FrameReader::read_forces(const Strip& strip, Frame& frame) const {
  for (int k = 0; k + 1 < strip.nodes; ++k) {
    const auto at = static_cast<std::size_t>(strip.first + k);
    const NodeSource &from = scene_.sources[at], &to = scene_.sources[at + 1];
    double axial = 0.0, bending = 0.0;
    for (int e = from.node; e < to.node; ++e) {
      if (scene_.is_planar) {
        const BladeShape& blade = planar_shapes_[static_cast<std::size_t>(from.subsystem)];
        const auto element = static_cast<std::size_t>(from.body * blade.elements + e);
        axial += blade.axial_forces[element];
        bending += std::abs(blade.bending_moments[element]);
      } else {
        const ElementForces& forces = body_of(from).forces[static_cast<std::size_t>(e)];
        axial += forces.axial;
        bending += forces.bending;
      }
    }
    const double count = to.node - from.node;
    frame.axial_forces.push_back(axial / count);
    frame.bending_moments.push_back(bending / count);
  }
}

}  // namespace spoke::scene
