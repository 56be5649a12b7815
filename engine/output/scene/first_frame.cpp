// Places joints where they stand before a model is simulated.

#include "engine/output/scene/carriers.h"
#include "engine/output/scene/frame.h"
#include "models/space/mount.h"
#include "models/space/rotation_vector.h"
#include "models/tree/tree.h"

namespace spoke::scene {
namespace {

using spatial::Joint;
using spatial::JointCoordinate;
using spatial::JointKind;
using spatial::Placement;
using spatial::Tree;

double initial_value(const JointCoordinate& coordinate, double azimuth) {
  if (!coordinate.motion) return coordinate.initial;
  if (const auto* table = std::get_if<spatial::MotionTable>(&*coordinate.motion))
    return table->value.value(0.0);
  if (const auto* wave = std::get_if<spatial::AzimuthMotion>(&*coordinate.motion))
    return wave->mean + wave->cosine * std::cos(azimuth) + wave->sine * std::sin(azimuth);
  return std::get<spatial::ProgramMotion>(*coordinate.motion).initial;
}

Placement turned(const Vector& axis, double angle) {
  return {Vector::Zero(), space::exponential(angle * axis.normalized()).axes};
}

/// Returns the motion of the frame of the child against that of the joint.
Placement calc_motion(const Joint& joint, double azimuth) {
  Eigen::Matrix<double, 6, 1> value = Eigen::Matrix<double, 6, 1>::Zero();
  for (int c = 0; c < count_coordinates(joint.kind); ++c)
    value[c] = initial_value(joint.coordinates[static_cast<std::size_t>(c)], azimuth);
  const Vector &first = joint.axes[0], &second = joint.axes[1];
  switch (joint.kind) {
    case JointKind::fixed:
      break;
    case JointKind::revolute:
      return turned(first, value[0]);
    case JointKind::universal:
      return turned(first, value[0]) * turned(second, value[1]);
    case JointKind::spherical:
      return {Vector::Zero(), space::exponential(value.head<3>()).axes};
    case JointKind::prismatic:
      return {value[0] * first.normalized(), spatial::Tensor::Identity()};
    case JointKind::cylindrical:
      return turned(first, value[0]) *
             Placement{value[1] * first.normalized(), spatial::Tensor::Identity()};
    case JointKind::bushing:
      return Placement{value.head<3>(), spatial::Tensor::Identity()} *
             turned(Vector::UnitX(), value[3]) * turned(Vector::UnitY(), value[4]) *
             turned(Vector::UnitZ(), value[5]);
  }
  return {};
}

/// Returns the motions of the bodies of a tree in the frame of what carries it, each from its place
/// at coordinates of zero.
std::vector<Placement> calc_motions(const Tree& tree) {
  const std::vector<Placement> places = calc_placements(tree);
  std::vector<Placement> motions;
  for (std::size_t j = 0; j < tree.bodies.size(); ++j) {
    const spatial::TreeBody& body = tree.bodies[j];
    const Placement before =
        body.parent < 0 ? Placement{} : motions[static_cast<std::size_t>(body.parent)];
    motions.push_back(before * places[j] * calc_motion(body.joint, tree.azimuth) *
                      inverse(places[j]));
  }
  return motions;
}

/// Adds the motions of the groups of a subsystem, the first of which is `next`.
/// `base`: motion of what carries the subsystem.
void add_motions(const Tree& tree, const Placement& base, std::vector<Placement>& groups,
                 std::size_t& next) {
  const std::vector<Placement> motions = calc_motions(tree);
  for (std::size_t j = 0; j < tree.bodies.size(); ++j)
    if (count_coordinates(tree.bodies[j].joint.kind) > 0 && !tree.bodies[j].is_hub())
      groups[next++] = base * motions[j];
}

/// Returns the pose of the hub, which its mount may have moved.
HubPose calc_start(const spatial::Hub& hub) {
  space::Hub at_rest;
  at_rest.mount = hub.mount;
  const space::AxleMotion start = calc_axle_motion(at_rest, 0.0);
  return {start.p, start.R.axes};
}

/// Returns the pose of what a support stands on.
Placement calc_base(const spatial::Model& model) {
  if (!model.support) return {};
  if (model.support->from == spatial::SupportBase::ground) {
    const HubPose start = calc_start(model.hub);
    return {start.position, start.rotation};
  }
  const spatial::Fuselage& fuselage = model.support->fuselage;
  return {fuselage.position, space::exponential(fuselage.attitude).axes};
}

/// Returns the pose of the hub of a rotor on a support, or on what another one carries, whose
/// joints stand where they start.
Placement find_supported_hub(const spatial::Model& model, int rotor, const Placement& base,
                             const std::vector<Tree>& trees) {
  const spatial::BodyAt hub = find_hub(trees, rotor);
  const Tree& tree = trees[hub.tree];
  const bool is_on_support = hub.tree + 1 == trees.size();
  return (is_on_support ? base : find_supported_hub(model, tree.rotor, base, trees)) *
         calc_motions(tree)[hub.body] * calc_placements(tree)[hub.body] *
         inverse(rotor_placement(hub_of(model, rotor)));
}

/// A place that an anchor moves on a body of a tree.
struct MovedPlace {
  std::size_t tree = 0;
  const spatial::TreePlace* place = nullptr;  ///< null: there is none
};

/// Returns the first place that an anchor moves.
MovedPlace find_moved(const std::vector<Tree>& trees, int anchor) {
  const auto is_it = [anchor](const spatial::TreePlace& place) {
    return place.is_moved && std::cmp_equal(place.anchor, anchor);
  };
  for (std::size_t i = 0; i < trees.size(); ++i) {
    for (const spatial::TreeLoop& loop : trees[i].loops)
      if (is_it(loop.to)) return {i, &loop.to};
    for (const spatial::LoopEnd& end : trees[i].ends)
      if (end.has_place() && is_it(end.place)) return {i, &end.place};
  }
  return {};
}

/// Returns where an anchor on a body begins to move, in the frame of what carries the tree.
Placement find_start_on_body(const Tree& tree, const spatial::TreePlace& place) {
  const auto j = static_cast<std::size_t>(place.body);
  Placement at = calc_motions(tree)[j] * calc_placements(tree)[j];
  if (const auto* part = std::get_if<spatial::FlexibleBody>(&tree.bodies[j].shape))
    at = at * Placement{(part->nodes[place.node] - part->nodes.front()) * Vector::UnitX(),
                        spatial::Tensor::Identity()};
  return at;
}

/// Places the groups of mount and anchors. `mount`: the mount in the frame of the hub at its first
/// angle.
void place_carriers(const std::vector<Anchor>& anchors, const std::vector<Tree>& trees,
                    const Placement& mount, const Scene& scene, Frame& frame) {
  for (const Carrier& carrier : scene.carriers) {
    Placement& group = frame.groups[static_cast<std::size_t>(carrier.group)];
    group = mount;
    if (carrier.anchor < 0) continue;
    const Anchor& anchor = anchors[static_cast<std::size_t>(carrier.anchor)];
    Placement frame_of = mount;
    if (const MovedPlace moved = find_moved(trees, carrier.anchor); moved.place)
      frame_of = frame.groups[static_cast<std::size_t>(scene.roots[moved.tree])] *
                 find_start_on_body(trees[moved.tree], *moved.place);
    else if (anchor.frame != Anchor::Frame::mount)
      frame_of = frame.groups[static_cast<std::size_t>(group_of_hub(scene, carrier))];
    group = frame_of * calc_first_place(anchor);
  }
}

}  // namespace

Frame make_first_frame(const Scenario& scenario, const Scene& scene) {
  Frame frame;
  frame.groups.resize(static_cast<std::size_t>(scene.groups));
  frame.displacements.assign(scene.nodes.size(), Vector::Zero());
  frame.rotations = frame.displacements;
  if (!scenario.space) {
    place_carriers(scenario.rotor.anchors, {}, {}, scene, frame);
    return frame;
  }
  const std::vector<Tree> trees = build_trees(*scenario.space);
  Placement base = calc_base(*scenario.space);
  if (scenario.space->support) {
    const Placement hub = find_supported_hub(*scenario.space, 0, base, trees);
    frame.hub = {hub.position, hub.rotation};
    base = inverse(hub) * base;
  } else {
    frame.hub = calc_start(scenario.space->hub);
  }
  std::size_t next = 1 + scene.carriers.size();
  const auto add = [&](std::size_t i) {
    const auto root = static_cast<std::size_t>(scene.roots[i]);
    add_motions(trees[i], frame.groups[root], frame.groups, next);
  };
  for (std::size_t i = 0; i < trees.size(); ++i)
    if (scene.roots[i] == 0) add(i);
  if (scene.support < 0) {
    place_carriers(scenario.space->anchors, trees, base, scene, frame);
    return frame;
  }
  frame.groups[next++] = base;
  for (std::size_t r = 1; r < scene.hubs.size(); ++r)
    frame.groups[next++] = find_supported_hub(*scenario.space, static_cast<int>(r), base, trees);
  place_carriers(scenario.space->anchors, trees, base, scene, frame);
  add(static_cast<std::size_t>(scene.support));
  for (std::size_t i = 0; i < trees.size(); ++i)
    if (scene.roots[i] > scene.base_group) add(i);
  return frame;
}

}  // namespace spoke::scene
