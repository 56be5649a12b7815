// Places and masses of the bodies of a tree.

#include "models/tree/tree.h"

#include <algorithm>
#include <cassert>
#include <iterator>

#include "models/tree/space_beam.h"

namespace spoke::spatial {
namespace {

/// Returns where the frame of a node or an interface is in the frame of its body.
Placement placement_of(const Tree& tree, const TreeBody& body, std::size_t node) {
  if (const auto* solid = std::get_if<SolidPart>(&body.shape))
    return {solid->place_of(node), Tensor::Identity()};
  const auto* flexible = std::get_if<FlexibleBody>(&body.shape);
  if (flexible == nullptr) return {};
  const space::ReferenceCurve axis = make_space_beam(tree.beams[flexible->beam]).curve;
  return {axis.at(flexible->nodes[node]) - axis.at(flexible->nodes.front()), Tensor::Identity()};
}

}  // namespace

std::int64_t count_coordinates(const Tree& tree) {
  std::int64_t count = 0;
  for (const TreeBody& body : tree.bodies) {
    count += count_coordinates(body.joint.kind);
    if (const auto* beam = std::get_if<FlexibleBody>(&body.shape))
      count += 6 * (std::ssize(beam->nodes) - 1);
    else if (const auto* solid = std::get_if<SolidPart>(&body.shape))
      count += count_coordinates(*solid);
  }
  return count;
}

bool is_part_of(const TreeBody& body, const std::string& name) {
  return body.name == name || body.name.starts_with(name + " / body ");
}

std::size_t find_hub(const Tree& support, int rotor) {
  const auto hub = std::find_if(support.bodies.begin(), support.bodies.end(),
                                [rotor](const TreeBody& body) { return body.rotor == rotor; });
  assert(rotor >= 0 && hub != support.bodies.end());
  return static_cast<std::size_t>(hub - support.bodies.begin());
}

std::vector<Placement> calc_placements(const Tree& tree) {
  std::vector<Placement> placements;
  for (const TreeBody& body : tree.bodies) {
    if (body.parent < 0) {
      placements.push_back(body.placement);
      continue;
    }
    const auto parent = static_cast<std::size_t>(body.parent);
    placements.push_back(placements[parent] *
                         placement_of(tree, tree.bodies[parent], body.parent_node) *
                         body.placement);
  }
  return placements;
}

MassProperties calc_mass_properties(const Tree& tree, const TreeBody& body) {
  if (const auto* rigid = std::get_if<RigidBody>(&body.shape))
    return make_mass_properties(rigid->mass, rigid->center, rigid->inertia);
  if (const auto* solid = std::get_if<SolidPart>(&body.shape)) {
    const solid::SolidGeometry& at_rest = solid->geometry();
    const Tensor& second = at_rest.second_moment;
    return {at_rest.mass, at_rest.first_moment, second.trace() * Tensor::Identity() - second};
  }
  const auto& flexible = std::get<FlexibleBody>(body.shape);
  const space::Beam beam = make_space_beam(tree.beams[flexible.beam]);
  const double from = flexible.nodes.front(), to = flexible.nodes.back();
  return calc_mass_properties(beam, from, to)
      .seen_from_outside({-beam.curve.at(from), Tensor::Identity()});
}

MassProperties calc_mass_properties(const Tree& tree) {
  const std::vector<Placement> placements = calc_placements(tree);
  MassProperties total;
  for (std::size_t i = 0; i < tree.bodies.size(); ++i)
    total += calc_mass_properties(tree, tree.bodies[i]).seen_from_outside(placements[i]);
  return total;
}

MassProperties calc_mass_properties(const Hub& hub, const std::vector<Tree>& trees) {
  MassProperties total = make_mass_properties(hub.mass, hub.center, hub.inertia);
  for (const Tree& tree : trees) total += calc_mass_properties(tree);
  return total;
}

}  // namespace spoke::spatial
