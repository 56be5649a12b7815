// Makes the scene of a model in space.

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "engine/output/scene/carriers.h"
#include "engine/output/scene/make_scene.h"
#include "engine/output/scene/mesh_surface.h"
#include "engine/output/scene/section_size.h"
#include "engine/output/scene/solids.h"
#include "models/solid/solid.h"
#include "models/tree/axle_carrier.h"
#include "models/tree/space_beam.h"
#include "models/tree/tree.h"

namespace spoke::scene {
namespace {

using spatial::Placement;
using spatial::SolidPart;
using spatial::Tree;
using spatial::TreeBody;

/// Returns the number of nodes of the scene for a solid: its frame, its interfaces, and the sets
/// that loads act on.
std::size_t count_solid_nodes(const SolidPart& part) {
  return 1 + part.body().interfaces.size() + part.sets.size();
}

std::size_t count_nodes(const std::vector<Tree>& trees) {
  std::size_t nodes = 0;
  for (const Tree& tree : trees)
    for (const TreeBody& body : tree.bodies) {
      const auto* beam = std::get_if<spatial::FlexibleBody>(&body.shape);
      const auto* solid = std::get_if<SolidPart>(&body.shape);
      nodes += beam ? beam->nodes.size() : solid ? count_solid_nodes(*solid) : 1;
    }
  return nodes;
}

std::vector<const Loop*> find_loops(const std::vector<Tree>& trees) {
  std::vector<const Loop*> loops;
  for (const Tree& tree : trees)
    for (const spatial::TreeLoop& loop : tree.loops) loops.push_back(&loop.loop);
  return loops;
}

std::string describe(const spatial::JointCoordinate& coordinate) {
  if (coordinate.motion) return "prescribed";
  return coordinate.stiffness > 0.0 ? "sprung" : "free";
}

/// A place of a load, and the axes there, in the frame of the hub.
struct LoadedPlace {
  Place at;
  spatial::Tensor body, section;
};

/// The surfaces of a scene's solids; equal solids share one.
class Surfaces {
 public:
  Surfaces(const SolidsInTrees& solids, std::size_t most_nodes, Scene& scene)
      : solids_(solids), most_nodes_(most_nodes), scene_(scene) {
    for (const auto& tree : solids)
      for (const auto& solid : tree)
        if (solid && solid->nodal()) ++nodal_;
  }

  /// Returns the index of the surface of a body, which it adds if it is new.
  int find_or_add(int tree, std::size_t body, const SolidPart& part) {
    const auto i = static_cast<std::size_t>(tree);
    SolidView view{part.geometry().mesh, part.geometry().interfaces.front().point, nullptr};
    if (i < solids_.size() && body < solids_[i].size()) view.constants = solids_[i][body];
    const void* key = view.constants ? static_cast<const void*>(view.constants.get())
                                     : static_cast<const void*>(part.kept.get());
    const auto [found, is_new] = made_.try_emplace(key, static_cast<int>(scene_.surfaces.size()));
    if (is_new)
      scene_.surfaces.push_back(
          make_surface(view, count_drawn_nodes(view.constants.get(), nodal_, most_nodes_)));
    return found->second;
  }

 private:
  const SolidsInTrees& solids_;
  std::size_t most_nodes_, nodal_ = 0;
  std::map<const void*, int> made_;  ///< by constants, or by description
  Scene& scene_;
};

/// Adds one subsystem to a scene.
class SubsystemScene {
 public:
  SubsystemScene(const Tree& tree, int number, bool is_blade, std::size_t stride, int per_element,
                 Surfaces& surfaces, Scene& scene)
      : tree_(tree),
        number_(number),
        is_blade_(is_blade),
        stride_(stride),
        per_element_(per_element),
        placements_(calc_placements(tree)),
        surfaces_(surfaces),
        scene_(scene) {
    for (const spatial::Beam& beam : tree.beams) beams_.push_back(make_space_beam(beam));
  }

  void add() {
    for (std::size_t j = 0; j < tree_.bodies.size(); ++j) {
      first_.push_back(static_cast<int>(scene_.nodes.size()));
      add_group(j);
      if (std::holds_alternative<spatial::FlexibleBody>(tree_.bodies[j].shape))
        add_beam(j);
      else if (const auto* part = std::get_if<SolidPart>(&tree_.bodies[j].shape))
        add_solid(j, *part);
      else
        add_rigid(j);
      add_joint(j);
    }
    scene_.tips[static_cast<std::size_t>(number_)] = find_tip();
    for (const spatial::TreeLoop& loop : tree_.loops)
      if (loop.loop.to.carrier != LoopPlace::Carrier::elsewhere)
        add_loop(loop, find_end(loop.from), find_end(loop.to));
  }

  /// Adds the loops that end on this one, of the subsystems that are `made`.
  void add_loops_from(std::vector<SubsystemScene>& made) {
    for (const spatial::LoopEnd& end : tree_.ends) {
      if (end.is_on_hub || end.coupling) continue;
      const auto of = std::find_if(made.begin(), made.end(), [&end](const SubsystemScene& other) {
        return std::cmp_equal(other.number_, end.tree);
      });
      const spatial::TreeLoop& loop = of->tree_.loops[end.number];
      of->add_loop(loop, of->find_end(loop.from), find_end(end.place));
    }
  }

  /// Returns the place on a solid where a load acts on this subsystem; none if it acts on no solid
  /// of it.
  std::optional<LoadedPlace> find_solid_place(const spatial::PointLoad& load) const {
    for (std::size_t j = 0; j < tree_.bodies.size(); ++j)
      if (const auto* part = std::get_if<SolidPart>(&tree_.bodies[j].shape))
        if (is_on(load.place, j)) {
          const int node = first_[j] + 1 + static_cast<int>(find_loaded_place(load, *part));
          return LoadedPlace{{node, 0.0, scene_.nodes[static_cast<std::size_t>(node)].p},
                             placements_[j].rotation,
                             placements_[j].rotation};
        }
    return std::nullopt;
  }
  /// Returns the place where a load acts on this subsystem; none if it acts elsewhere. `position`:
  /// station; none: the tip.
  std::optional<LoadedPlace> find_place(const spatial::LoadPlace& place,
                                        std::optional<double> position, const Vector& point) const {
    std::optional<LoadedPlace> found;
    for (std::size_t j = 0; j < tree_.bodies.size(); ++j) {
      if (!is_on(place, j)) continue;
      if (auto turning = find_turning_place(j, point)) return turning;
      const Placement& body = placements_[j];
      const auto* part = std::get_if<spatial::FlexibleBody>(&tree_.bodies[j].shape);
      if (!part)
        return LoadedPlace{
            {first_[j], 0.0, body.position + body.rotation * point}, body.rotation, body.rotation};
      const double x = std::clamp(position.value_or(part->nodes.back()), part->nodes.front(),
                                  part->nodes.back());
      found = {place_on(j, *part, x), body.rotation, place_of(j, *part, x).rotation};
      if (position && *position <= part->nodes.back()) break;
    }
    return found;
  }
  /// Returns the length of the loaded beam [m].
  double length_of(const spatial::LoadPlace& place) const {
    for (std::size_t j = 0; j < tree_.bodies.size(); ++j)
      if (is_on(place, j))
        if (const auto* part = std::get_if<spatial::FlexibleBody>(&tree_.bodies[j].shape))
          return tree_.beams[part->beam].length;
    return 0.0;
  }

 private:
  bool is_on(const spatial::LoadPlace& place, std::size_t j) const {
    if (place.subsystem.empty())
      return is_blade_ && place.blade.holds(static_cast<std::size_t>(number_)) &&
             j <= find_tip_body(tree_);
    if (is_blade_ || place.subsystem != tree_.name) return false;
    const std::string& name = tree_.bodies[j].name;
    return name == place.body || name.starts_with(place.body + " / body ");
  }

  /// Returns the group of what carries the tree.
  int root_group() const { return scene_.roots[static_cast<std::size_t>(number_)]; }

  /// Returns a place in the frame of the hub of a support; none if the body is none.
  std::optional<LoadedPlace> find_turning_place(std::size_t j, const Vector& point) const {
    if (!tree_.bodies[j].is_hub()) return std::nullopt;
    const HubFrame& hub = scene_.hubs[static_cast<std::size_t>(tree_.bodies[j].rotor)];
    return LoadedPlace{{-1, 0.0, hub.to_hub * point, hub.group}, hub.to_hub, hub.to_hub};
  }

  void add_group(std::size_t j) {
    const TreeBody& body = tree_.bodies[j];
    // The node of a hub shows where the body that carries the axle has it.
    if (count_coordinates(body.joint.kind) > 0 && !body.is_hub())
      groups_.push_back(scene_.groups++);
    else
      groups_.push_back(body.parent < 0 ? root_group()
                                        : groups_[static_cast<std::size_t>(body.parent)]);
  }
  void add_node(std::size_t j, int node, const Vector& p) {
    scene_.nodes.push_back({groups_[j], p, placements_[j].rotation});
    scene_.sources.push_back({number_, static_cast<int>(j), node});
  }
  std::string name_of(std::size_t j) const { return tree_.name + " / " + tree_.bodies[j].name; }

  /// Returns the placement of a station of a beam, in the frame of the hub.
  Placement place_of(std::size_t j, const spatial::FlexibleBody& part, double x) const {
    const space::Beam& beam = beams_[part.beam];
    const space::SectionAt at = beam.geometry(x);
    return placements_[j] * Placement{at.p - beam.curve.at(part.nodes.front()), at.axes.axes};
  }

  void add_beam(std::size_t j) {
    const auto& part = std::get<spatial::FlexibleBody>(tree_.bodies[j].shape);
    Strip strip{name_of(j), number_, static_cast<int>(scene_.nodes.size()), 0, {}};
    std::vector<double> stations;
    for (const int k : shown_nodes(static_cast<int>(part.nodes.size()) - 1, stride_)) {
      stations.push_back(part.nodes[static_cast<std::size_t>(k)]);
      add_node(j, k, place_of(j, part, stations.back()).position);
    }
    strip.nodes = static_cast<int>(stations.size());
    strip.rings = make_rings(stations, strip.first, per_element_, [&](double x) {
      const Placement at = place_of(j, part, x);
      const SectionSize size = find_section_size(tree_.beams[part.beam], beams_[part.beam], x);
      Ring ring;
      ring.at.p = at.position + at.rotation * Vector(0.0, size.center_y, size.center_z);
      ring.y = at.rotation.col(1);
      ring.z = at.rotation.col(2);
      ring.half_y = size.half_y;
      ring.half_z = size.half_z;
      return ring;
    });
    add_point_masses(j, part);
    scene_.strips.push_back(std::move(strip));
  }

  void add_point_masses(std::size_t j, const spatial::FlexibleBody& part) {
    for (const spatial::PointMass& mass : tree_.beams[part.beam].point_masses) {
      const bool is_here = mass.position > part.nodes.front() || j == 0;
      if (!is_here || mass.position > part.nodes.back() || mass.offset.isZero()) continue;
      const Placement at = placements_[j];
      const Placement on = place_of(j, part, mass.position);
      // The mass is drawn on a stalk from the axis, fixed to a node near by.
      scene_.links.push_back({number_, node_before(j, part, mass.position), on.position,
                              on.position + at.rotation * mass.offset});
    }
  }
  /// Returns the last shown node at or inboard of a station.
  int node_before(std::size_t j, const spatial::FlexibleBody& part, double x) const {
    int node = first_[j];
    while (node + 1 < static_cast<int>(scene_.nodes.size()) && station_of(part, node + 1) <= x)
      ++node;
    return node;
  }
  double station_of(const spatial::FlexibleBody& part, int node) const {
    return part
        .nodes[static_cast<std::size_t>(scene_.sources[static_cast<std::size_t>(node)].node)];
  }
  Place place_on(std::size_t j, const spatial::FlexibleBody& part, double x) const {
    int node = first_[j];
    while (station_of(part, node + 1) < x) ++node;
    const double a = station_of(part, node), b = station_of(part, node + 1);
    return {node, (x - a) / (b - a), place_of(j, part, x).position};
  }

  void add_solid(std::size_t j, const SolidPart& part) {
    MeshBody mesh{name_of(j),
                  number_,
                  static_cast<int>(j),
                  first_[j],
                  surfaces_.find_or_add(number_, j, part),
                  {}};
    const Placement& at = placements_[j];
    add_node(j, 0, at.position);
    const auto add_place = [&](const Vector& p) {
      const auto node = static_cast<int>(scene_.nodes.size()) - first_[j];
      add_node(j, node, at.position + at.rotation * p);
      const bool is_seen =
          !scene_.surfaces[static_cast<std::size_t>(mesh.surface)].triangles.empty();
      if (!is_seen && !p.isZero(1e-12))
        scene_.links.push_back({number_, first_[j], at.position, scene_.nodes.back().p});
    };
    for (std::size_t i = 0; i < part.body().interfaces.size(); ++i) {
      add_place(part.place_of(i));
      mesh.interfaces.push_back(
          {part.body().interfaces[i].name, static_cast<int>(scene_.nodes.size()) - 1});
    }
    const Vector& origin = part.geometry().interfaces.front().point;
    for (const spatial::NodeChoice& set : part.sets)
      add_place(solid::choose_nodes(*part.geometry().mesh, set).point - origin);
    scene_.meshes.push_back(std::move(mesh));
  }

  /// Returns the last node of the body at the tip, of a solid that of its last interface.
  int find_tip() const {
    const std::size_t last = find_tip_body(tree_);
    if (const auto* part = std::get_if<SolidPart>(&tree_.bodies[last].shape))
      return first_[last] + static_cast<int>(part->body().interfaces.size());
    return last + 1 < first_.size() ? first_[last + 1] - 1
                                    : static_cast<int>(scene_.nodes.size()) - 1;
  }

  void add_rigid(std::size_t j) {
    const auto& body = std::get<spatial::RigidBody>(tree_.bodies[j].shape);
    const int node = first_[j];
    const Placement& at = placements_[j];
    add_node(j, 0, at.position);
    if (tree_.bodies[j].is_hub()) {  // it is drawn as the hub of all models
      scene_.hubs[static_cast<std::size_t>(tree_.bodies[j].rotor)].node = node;
      return;
    }
    Solid solid = tree_.bodies[j].is_generator() ? make_disc(body.inertia(2, 2))
                                                 : make_body(body.center, body.mass, body.inertia);
    solid.name = name_of(j);
    solid.subsystem = number_;
    solid.node = node;
    place(at.position, at.rotation, solid);
    scene_.solids.push_back(std::move(solid));
    const auto link = [&](const Vector& to) {
      if (!to.isZero(1e-12))
        scene_.links.push_back({number_, node, at.position, at.position + at.rotation * to});
    };
    link(body.center);
    for (const TreeBody& child : tree_.bodies)
      if (child.parent == static_cast<int>(j)) link(child.placement.position);
  }

  /// A place of a loop, and its frame in the frame of what carries it.
  struct LoopEnd {
    Place at;
    spatial::Tensor axes;
  };

  LoopEnd find_end(const spatial::TreePlace& place) {
    if (place.is_moved)
      return {{-1, 0.0, place.placement.position,
               find_group(scene_, LoopPlace::Carrier::anchor, static_cast<int>(place.anchor))},
              place.placement.rotation};
    if (place.carrier != LoopPlace::Carrier::body)
      return {{-1, 0.0, place.placement.position,
               place.carrier == LoopPlace::Carrier::hub
                   ? root_group()
                   : find_group(scene_, place.carrier, static_cast<int>(place.anchor))},
              place.placement.rotation};
    const auto j = static_cast<std::size_t>(place.body);
    if (const auto turning = find_turning_place(j, place.placement.position))
      return {turning->at, turning->body * place.placement.rotation};
    const Placement& body = placements_[j];
    const spatial::Tensor axes = body.rotation * place.placement.rotation;
    const Vector offset = body.rotation * place.placement.position;
    const auto* part = std::get_if<spatial::FlexibleBody>(&tree_.bodies[j].shape);
    Place at{first_[j], 0.0, body.position};
    int node = first_[j];
    if (std::holds_alternative<SolidPart>(tree_.bodies[j].shape)) {
      node += 1 + static_cast<int>(place.node);
      at = {node, 0.0, scene_.nodes[static_cast<std::size_t>(node)].p};
    } else if (part) {
      const double x = part->nodes[place.node];
      if (place.node > 0) at = place_on(j, *part, x);
      node = node_before(j, *part, x);
    }
    // What holds the place is drawn as a stalk.
    if (!offset.isZero(1e-12)) scene_.links.push_back({number_, node, at.p, at.p + offset});
    at.p += offset;
    return {at, axes};
  }

  void add_loop(const spatial::TreeLoop& loop, const LoopEnd& from, const LoopEnd& to) {
    LoopMark mark;
    mark.name = tree_.name + " / " + loop.loop.name;
    mark.kind = spoke::name_of(loop.loop.kind);
    mark.subsystem = number_;
    mark.from = from.at;
    mark.to = to.at;
    for (int i = 0; i < count_axes(loop.loop.kind); ++i)
      mark.axes.emplace_back(to.axes * loop.loop.axes[static_cast<std::size_t>(i)].normalized());
    mark.is_sprung = is_sprung(loop.loop);
    scene_.loops.push_back(std::move(mark));
  }

  void add_joint(std::size_t j) {
    const spatial::Joint& joint = tree_.bodies[j].joint;
    if (joint.kind == spatial::JointKind::fixed && joint.name.empty()) return;
    JointMark mark;
    mark.name = tree_.name + " / " + (joint.name.empty() ? tree_.bodies[j].name : joint.name);
    mark.kind = spatial::name_of(joint.kind);
    // A solid is joined at its first interface, which need not be its frame.
    const bool is_solid = std::holds_alternative<SolidPart>(tree_.bodies[j].shape);
    mark.node = first_[j] + (is_solid ? 1 : 0);
    for (int i = 0; i < count_axes(joint.kind); ++i)
      mark.axes.emplace_back(placements_[j].rotation *
                             joint.axes[static_cast<std::size_t>(i)].normalized());
    for (int i = 0; i < count_coordinates(joint.kind); ++i)
      mark.coordinates.push_back(describe(joint.coordinates[static_cast<std::size_t>(i)]));
    scene_.joints.push_back(std::move(mark));
  }

  const Tree& tree_;
  int number_;
  bool is_blade_;
  std::size_t stride_;
  int per_element_;
  std::vector<Placement> placements_;
  std::vector<space::Beam> beams_;
  std::vector<int> first_;   ///< first node, by body
  std::vector<int> groups_;  ///< by body
  Surfaces& surfaces_;
  Scene& scene_;
};

void add_hub(const spatial::Hub& hub, const std::string& name, int group, Scene& scene) {
  const double radius = scene.radius();
  if (hub.support == HubSupport::free) {
    scene.solids.push_back(make_body(hub.center, hub.mass, hub.inertia));
  } else {
    const double size = std::max(hub.radius, 0.02 * radius);
    scene.solids.push_back(make_cylinder(hub.axis, size, std::min(0.5 * size, 0.04 * radius)));
  }
  scene.solids.back().name = name;
  scene.solids.back().group = group;
}

/// Draws the body that a support is or stands on, and what holds the axle where no other body does.
void add_fuselage(const spatial::Fuselage& fuselage, const Tree& support, Scene& scene) {
  Solid solid = make_body(fuselage.center, fuselage.mass, fuselage.inertia);
  solid.name = spatial::base_name(spatial::SupportBase::free);
  solid.subsystem = scene.support;
  solid.group = scene.base_group;
  scene.solids.push_back(std::move(solid));
  for (const spatial::TreeBody& body : support.bodies) {
    if (!body.is_hub() || body.parent >= 0) continue;
    const int hub = scene.hubs[static_cast<std::size_t>(body.rotor)].node;
    const Vector& place = scene.nodes[static_cast<std::size_t>(hub)].p;
    if (!(place - fuselage.center).isZero(1e-12))
      scene.links.push_back({scene.support, hub, fuselage.center, place});
  }
}

/// Draws the loads of a model.
class LoadMarks {
 public:
  LoadMarks(const std::vector<SubsystemScene>& subsystems, Scene& scene)
      : subsystems_(subsystems), scene_(scene) {}

  void add(const spatial::PointLoad& load) {
    for (const SubsystemScene& subsystem : subsystems_) {
      if (const std::optional<LoadedPlace> place = subsystem.find_solid_place(load)) {
        add(place, load.frame, load.traction.value_or(load.force), load.moment, false);
        continue;
      }
      add(subsystem.find_place(load.place, load.position, load.point), load.frame, load.force,
          load.moment, false);
    }
  }
  void add(const spatial::DistributedLoad& load) {
    constexpr int kArrows = 9;
    for (const SubsystemScene& subsystem : subsystems_) {
      const double to = load.to.value_or(subsystem.length_of(load.place));
      for (int k = 0; k < kArrows; ++k) {
        const double x = load.from + (to - load.from) * k / (kArrows - 1);
        add(subsystem.find_place(load.place, x, Vector::Zero()), load.frame, load.force_per_length,
            load.moment_per_length, true);
      }
    }
  }
  void add(const spatial::HubLoad& load) {
    const int group = scene_.hubs[static_cast<std::size_t>(load.rotor)].group;
    scene_.loads.push_back({{-1, 0.0, load.position, group},
                            std::string(name_of(load.frame)),
                            load.force,
                            load.torque,
                            false});
  }

 private:
  void add(const std::optional<LoadedPlace>& place, spatial::LoadFrame frame, const Vector& force,
           const Vector& moment, bool is_distributed) {
    if (!place) return;
    spatial::Tensor R = spatial::Tensor::Identity();
    if (frame == spatial::LoadFrame::body) R = place->body;
    if (frame == spatial::LoadFrame::section) R = place->section;
    scene_.loads.push_back(
        {place->at, std::string(name_of(frame)), R * force, R * moment, is_distributed});
  }

  const std::vector<SubsystemScene>& subsystems_;
  Scene& scene_;
};

}  // namespace

Scene make_spatial_scene(const spatial::Model& model, std::size_t most_nodes,
                         const SolidsInTrees& solids) {
  const std::vector<Tree> trees = build_trees(model);
  const std::size_t nodes = count_nodes(trees);
  const std::size_t stride = std::max<std::size_t>(1, (nodes + most_nodes - 1) / most_nodes);
  Scene scene;
  scene.axis = model.hub.axis.normalized();
  scene.gravity = model.gravity;
  add_carriers(model.anchors, find_loops(trees), scene);
  Surfaces surfaces(solids, most_nodes, scene);
  for (const Tree& tree : trees) scene.subsystems.push_back(tree.name);
  scene.tips.resize(trees.size());
  scene.roots.resize(trees.size());
  for (int r = 0; r < count_rotors(model); ++r)
    scene.hubs.push_back({0, -1, spatial::rotor_placement(hub_of(model, r)).rotation});
  std::vector<SubsystemScene> made;
  const auto add = [&](std::size_t i) {
    made.emplace_back(trees[i], static_cast<int>(i), i < model.blades.size(), stride,
                      rings_per_element(nodes / stride), surfaces, scene);
    made.back().add();
  };
  // What moves with the first hub, or stands without a support, comes first.
  const std::size_t before = trees.size() - (model.support ? 1 : 0);
  for (std::size_t i = 0; i < before; ++i)
    if (trees[i].rotor == 0) add(i);
  if (model.support) {
    scene.support = static_cast<int>(before);
    scene.base_group = scene.roots[before] = scene.groups++;
    for (std::size_t r = 1; r < scene.hubs.size(); ++r) scene.hubs[r].group = scene.groups++;
    add(before);
    for (std::size_t i = 0; i < before; ++i) {
      if (trees[i].rotor == 0) continue;
      scene.roots[i] = scene.hubs[static_cast<std::size_t>(trees[i].rotor)].group;
      add(i);
    }
  }
  for (SubsystemScene& end : made) end.add_loops_from(made);
  if (model.support && model.support->from == spatial::SupportBase::free)
    add_fuselage(model.support->fuselage, trees.back(), scene);
  for (int r = 0; r < count_rotors(model); ++r)
    add_hub(hub_of(model, r), prefix_of_rotor(model, r) + "hub",
            scene.hubs[static_cast<std::size_t>(r)].group, scene);
  add_plates(model.anchors, scene);
  LoadMarks marks(made, scene);
  for (const spatial::PointLoad& load : model.loads) marks.add(load);
  for (const spatial::DistributedLoad& load : model.distributed_loads) marks.add(load);
  for (const spatial::HubLoad& load : model.hub_loads) marks.add(load);
  return scene;
}

}  // namespace spoke::scene
