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

namespace {

/// Returns the index of the body of a tree that is the hub of a rotor; of none, their number.
std::size_t search_hub(const Tree& tree, int rotor) {
  const auto hub = std::find_if(tree.bodies.begin(), tree.bodies.end(),
                                [rotor](const TreeBody& body) { return body.rotor == rotor; });
  return static_cast<std::size_t>(hub - tree.bodies.begin());
}

}  // namespace

std::size_t find_hub(const Tree& carrier, int rotor) {
  const std::size_t hub = search_hub(carrier, rotor);
  assert(rotor >= 0 && hub < carrier.bodies.size());
  return hub;
}

BodyAt find_hub(const std::vector<Tree>& trees, int rotor) {
  assert(rotor >= 0);
  for (std::size_t i = trees.size(); i-- > 0;)
    if (const std::size_t hub = search_hub(trees[i], rotor); hub < trees[i].bodies.size())
      return {i, hub};
  assert(false && "the axle of a rotor is on a tree");
  return {};
}

Placement find_hub_placement(const Model& model, const std::vector<Tree>& trees, int rotor) {
  const BodyAt at = find_hub(trees, rotor);
  Placement own = calc_placements(trees[at.tree])[at.body];
  if (at.tree + 1 == trees.size()) return own;  // on the support
  const int carrier = trees[at.tree].rotor;
  return find_hub_placement(model, trees, carrier) *
         inverse(rotor_placement(hub_of(model, carrier))) * own;
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
