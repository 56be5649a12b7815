// Makes bodies and joints of blades and subsystems.

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <utility>

#include "models/space/reference_curve.h"
#include "models/space/rotation_vector.h"
#include "models/tree/anchors_on_bodies.h"
#include "models/tree/axle_carrier.h"
#include "models/tree/beam_cuts.h"
#include "models/tree/beam_strain.h"
#include "models/tree/drive_train.h"
#include "models/tree/loops_across.h"
#include "models/tree/space_beam.h"
#include "models/tree/tree.h"

namespace spoke::spatial {
namespace {

Tensor rotation_of(const Vector& rotation_vector) {
  return space::exponential(rotation_vector).axes;
}

/// A place to which a body is joined: on the hub, on a rigid body, at a node, or at an interface.
struct Handle {
  int body = -1;
  std::size_t node = 0;
};

/// Returns the node of a body at a station, if there is one.
std::optional<std::size_t> find_node(const FlexibleBody& body, double station, double resolution) {
  for (std::size_t k = 0; k < body.nodes.size(); ++k)
    if (std::abs(body.nodes[k] - station) <= resolution) return k;
  return std::nullopt;
}

/// Moves the frame in which a joint is placed by the joint's own offset and orientation.
Placement take_offset(const Placement& placement, Joint& joint) {
  Placement moved = placement * Placement{joint.offset, rotation_of(joint.orientation)};
  joint.offset = joint.orientation = Vector::Zero();
  return moved;
}

/// Adds a body on a handle. The joint's offset and orientation become the placement.
int add_body(Tree& tree, std::string name, decltype(TreeBody::shape) shape, const Handle& parent,
             Placement placement, Joint joint) {
  placement = take_offset(placement, joint);
  tree.bodies.push_back(
      {std::move(name), std::move(shape), parent.body, parent.node, placement, std::move(joint)});
  return static_cast<int>(tree.bodies.size()) - 1;
}

/// The joints within a beam, and the place to which its root is joined.
struct BeamRoot {
  Handle parent;        ///< parent of the beam's first body
  Placement placement;  ///< placement in the parent's frame
  Joint joint;          ///< joint of the beam's first body, if no joint of `inner` is at the root
};

/// Returns the root of a beam whose axis may begin beside the origin of the beam's frame: there its
/// first body has its own. A joint at the beam's root stands on the axis, as joints further out do;
/// the one that carries the beam, which is fixed, at the origin.
BeamRoot move_to_axis(BeamRoot root, const Beam& beam, bool has_joint_at_root) {
  const Vector begin = find_axis_begin(beam.sections);
  if (begin.isZero(0.0)) return root;
  assert(has_joint_at_root || root.joint.kind == JointKind::fixed);
  if (!has_joint_at_root) root.placement = take_offset(root.placement, root.joint);
  root.placement = root.placement * Placement{begin, Tensor::Identity()};
  return root;
}

/// Adds the bodies of a beam; `inner` joints part it, there are nodes at `places`.
void add_beam(Tree& tree, const Beam& beam, const std::string& name, const BeamRoot& carried,
              const std::vector<BladeJoint>& inner, const std::vector<double>& places) {
  std::vector<double> cuts;
  for (const BladeJoint& joint : inner) cuts.push_back(joint.station);
  const std::size_t index = tree.beams.size();
  tree.beams.push_back(beam);
  const std::vector<std::vector<double>> all_nodes = cut_beam(beam, cuts, places);
  const bool has_joint_at_root =
      !cuts.empty() && std::abs(cuts.front() - all_nodes.front().front()) <= resolution_of(beam);
  const BeamRoot root = move_to_axis(carried, beam, has_joint_at_root);
  Handle parent = root.parent;
  Placement placement = root.placement;
  for (std::size_t i = 0; i < all_nodes.size(); ++i) {
    const std::vector<double>& nodes = all_nodes[i];
    const auto here = std::find_if(inner.begin(), inner.end(), [&](const BladeJoint& joint) {
      return std::abs(joint.station - nodes.front()) <= resolution_of(beam);
    });
    const Joint joint = here != inner.end() ? here->joint : i == 0 ? root.joint : Joint{};
    const std::string label = all_nodes.size() == 1 ? name
                                                    : name + (name.empty() ? "body " : " / body ") +
                                                          std::to_string(i + 1);
    const int body = add_body(tree, label, FlexibleBody{index, nodes}, parent, placement, joint);
    parent = {body, nodes.size() - 1};
    placement = {};
  }
}

/// Returns the stations at which loops are fixed to a beam, those that come from other trees among
/// them; `body`: its name.
std::vector<double> loop_stations(const std::vector<Loop>& loops,
                                  const std::vector<LoopFromElsewhere>& others,
                                  const std::string& body, const Beam& beam) {
  std::vector<double> stations;
  const auto add = [&](const LoopPlace& place) {
    if (place.name == body) stations.push_back(place.station.value_or(beam.length));
  };
  for (const Loop& loop : loops)
    for (const LoopPlace* place : {&loop.from, &loop.to})
      if (place->carrier == LoopPlace::Carrier::body) add(*place);
  for (const LoopFromElsewhere& other : others) add(other.loop->to);
  return stations;
}

/// Finds places of loops in a tree whose bodies are made.
class LoopBuilder {
 public:
  /// `turn`: of places that no body carries.
  LoopBuilder(const std::vector<Anchor>& anchors, const Tensor& turn, Tree& tree)
      : anchors_(anchors), turn_(turn), tree_(tree) {}

  /// Adds a loop. `find_bodies(name)`: the bodies that make up the body of that name.
  template <class FindBodies>
  void add(const Loop& loop, const FindBodies& find_bodies) {
    tree_.loops.push_back({loop, find(loop.from, find_bodies), find(loop.to, find_bodies)});
  }
  /// Adds the end of a loop of another tree.
  template <class FindBodies>
  void add_end(const LoopFromElsewhere& other, const FindBodies& find_bodies) {
    LoopPlace place = other.loop->to;
    place.carrier = LoopPlace::Carrier::body;
    tree_.ends.push_back({other.tree, other.number, {}, *other.loop, find(place, find_bodies)});
  }

 private:
  template <class FindBodies>
  TreePlace find(const LoopPlace& place, const FindBodies& find_bodies) const {
    TreePlace found;
    found.carrier = place.carrier;
    found.placement = {place.point, rotation_of(place.orientation.value_or(Vector::Zero()))};
    if (place.carrier == LoopPlace::Carrier::anchor) {
      const auto at = std::find_if(anchors_.begin(), anchors_.end(),
                                   [&](const Anchor& a) { return a.name == place.name; });
      assert(at != anchors_.end());
      found.anchor = static_cast<std::size_t>(at - anchors_.begin());
    }
    if (place.moved_by >= 0) {
      found.is_moved = true;
      found.anchor = static_cast<std::size_t>(place.moved_by);
    }
    if (place.carrier == LoopPlace::Carrier::body)
      find_body(place, find_bodies(place.name), found);
    else if (place.carrier != LoopPlace::Carrier::elsewhere)
      found.placement = Placement{Vector::Zero(), turn_} * found.placement;
    return found;
  }

  /// Finds the outermost of the bodies `first` to `last` that has a node at the place.
  void find_body(const LoopPlace& place, const std::pair<std::size_t, std::size_t>& bodies,
                 TreePlace& found) const {
    for (std::size_t i = bodies.second + 1; i-- > bodies.first;) {
      found.body = static_cast<int>(i);
      if (const auto* solid = std::get_if<SolidPart>(&tree_.bodies[i].shape))
        found.node = find_interface(solid->body(), place.interface).value();
      const auto* part = std::get_if<FlexibleBody>(&tree_.bodies[i].shape);
      if (part == nullptr) return;
      const Beam& beam = tree_.beams[part->beam];
      const auto node = find_node(*part, place.station.value_or(beam.length), resolution_of(beam));
      if (!node) continue;
      found.node = *node;
      return;
    }
    assert(false && "places of loops are nodes");
  }

  const std::vector<Anchor>& anchors_;
  Tensor turn_;
  Tree& tree_;
};

/// Returns the hub on a support, in its frame with z along the drive's axis.
RigidBody make_hub_body(const Hub& hub) {
  const Tensor to_axis = rotor_placement(hub).rotation.transpose();
  return {hub.mass, to_axis * hub.center, to_axis * hub.inertia * to_axis.transpose()};
}

/// Returns the axle, about which the drive turns the hub.
Joint make_axle(std::string name, const Axle& axle) {
  Joint joint;
  joint.name = std::move(name);
  joint.kind = JointKind::revolute;
  joint.axes[0] = Vector::UnitZ();
  joint.offset = axle.offset;
  joint.orientation = axle.orientation;
  return joint;
}

/// Lets the drive of a rotor turn the joint of a body.
void drive_joint(const Drive& drive, int rotor, double ratio, TreeBody& body) {
  body.driven_by = rotor;
  body.drive_ratio = ratio;
  JointCoordinate& turn = body.joint.coordinates[0];
  turn.initial_speed = ratio * calc_initial_speed(drive);
  if (prescribes_motion(drive)) turn.motion = MotionTable{};  // the drive's
}

/// Adds the generator that the drive of a rotor turns, and the shaft to its axle.
void add_generator(Tree& tree, const Model& model, int rotor, const Handle& carrier) {
  const std::string prefix = prefix_of_rotor(model, rotor);
  const Axle& axle = axle_of(model, rotor);
  const Hub& hub = hub_of(model, rotor);
  add_body(tree, prefix + std::string(kGeneratorName), make_generator(*axle.train), carrier, {},
           make_axle(prefix + std::string(kGeneratorName), axle));
  TreeBody& made = tree.bodies.back();
  made.placement = made.placement * rotor_placement(hub);
  drive_joint(hub.drive, rotor, axle.train->gear_ratio, made);
  tree.couplings.push_back(make_shaft(*axle.train, prefix));
}

/// Adds the hub of a rotor that a tree carries.
void add_hub(Tree& tree, const Model& model, int rotor, const Handle& carrier) {
  const Hub& hub = hub_of(model, rotor);
  const Axle& axle = axle_of(model, rotor);
  const std::string prefix = prefix_of_rotor(model, rotor);
  if (axle.train) add_generator(tree, model, rotor, carrier);
  add_body(tree, prefix + "hub", make_hub_body(hub), carrier, {}, make_axle(prefix + "axle", axle));
  TreeBody& made = tree.bodies.back();
  made.rotor = rotor;
  made.placement = made.placement * rotor_placement(hub);
  if (!axle.train) {
    drive_joint(hub.drive, rotor, 1.0, made);
    return;
  }
  const TreeBody& generator = tree.bodies[tree.bodies.size() - 2];
  made.joint.coordinates[0].initial_speed =
      generator.joint.coordinates[0].initial_speed / axle.train->gear_ratio;
}

/// Returns the node at a station of a blade, on the outermost of its bodies, which are `last` + 1:
/// where a joint parts it, outboard of that.
Handle find_outermost(const Tree& tree, std::size_t last, double station) {
  for (std::size_t i = last + 1; i-- > 0;) {
    const auto& part = std::get<FlexibleBody>(tree.bodies[i].shape);
    const auto node = find_node(part, station, resolution_of(tree.beams[part.beam]));
    if (node) return {static_cast<int>(i), *node};
  }
  assert(false && "places of axles are nodes");
  return {};
}

Tree build_tree(const Blade& blade, const Model& model, std::size_t number) {
  Tree tree;
  tree.name = name_of_blade(number);
  tree.azimuth = blade.azimuth;
  tree.rotor = blade.rotor;
  const Hub& hub = hub_of(model, blade.rotor);
  const Tensor turned =
      rotation_of(blade.azimuth * Vector::UnitZ()) * rotation_of(-blade.precone * Vector::UnitY());
  const Placement root =
      rotor_placement(hub) * Placement{turned * (hub.radius * Vector::UnitX()), turned};
  Beam beam = blade.beam;
  beam.strain = choose_strain(beam, find_unknown_tension(model, blade));
  const std::vector<LoopFromElsewhere> others = find_loops_from_elsewhere(model, number - 1);
  std::vector<double> places = loop_stations(blade.loops, others, "", beam);
  const std::vector<int> rotors = find_rotors_on(model, blade);
  for (const int r : rotors) places.push_back(axle_of(model, r).station.value_or(beam.length));
  add_beam(tree, beam, "", {{}, root, {}}, blade.joints, places);
  if (tree.bodies.size() == 1) tree.bodies[0].name = "body 1";
  const std::size_t last = tree.bodies.size() - 1;
  LoopBuilder builder(model.anchors, rotation_of(blade.azimuth * hub.axis.normalized()), tree);
  const auto all = [last](const std::string&) {
    return std::pair<std::size_t, std::size_t>(0, last);
  };
  for (const Loop& loop : blade.loops) builder.add(loop, all);
  for (const LoopFromElsewhere& other : others) builder.add_end(other, all);
  for (const int r : rotors)
    add_hub(tree, model, r,
            find_outermost(tree, last, axle_of(model, r).station.value_or(beam.length)));
  tree.couplings.insert(tree.couplings.begin(), blade.couplings.begin(), blade.couplings.end());
  return tree;
}

/// Adds the bodies of a subsystem, each after its parent.
class SubsystemBuilder {
 public:
  /// `number`: of the tree.
  SubsystemBuilder(std::size_t number, const Model& model, const SolidParts& solids)
      : subsystem_(model.subsystems[number - model.blades.size()]),
        model_(model),
        others_(find_loops_from_elsewhere(model, number)),
        support_(is_support(model, subsystem_) ? &*model.support : nullptr),
        base_(support_ ? base_name(support_->from) : "hub"),
        rotors_(find_rotors_on(model, subsystem_.name)),
        unknown_tension_(find_unknown_tension(model, subsystem_)),
        solids_(solids),
        turn_(rotation_of(subsystem_.azimuth * hub_of(model, subsystem_.rotor).axis.normalized())) {
    tree_.name = subsystem_.name;
    tree_.azimuth = subsystem_.azimuth;
    tree_.rotor = subsystem_.rotor;
    for (const SubsystemJoint& joint : subsystem_.joints) children_.emplace(joint.parent, &joint);
  }

  Tree build() && {
    // The order is depth first, with siblings in the order in which they are given.
    std::vector<const SubsystemJoint*> next = children_of(base_);
    std::reverse(next.begin(), next.end());
    while (!next.empty()) {
      const SubsystemJoint& joint = *next.back();
      next.pop_back();
      add(joint);
      const auto further = children_of(joint.child);
      next.insert(next.end(), further.rbegin(), further.rend());
    }
    for (const int r : rotors_) add_hub(tree_, model_, r, carrier_of(axle_of(model_, r)));
    LoopBuilder builder(model_.anchors, turn_, tree_);
    const auto find = [this](const std::string& name) {
      const Added& added = added_.at(name);
      return std::pair(added.first, added.last);
    };
    for (const Loop& loop : subsystem_.loops) builder.add(loop, find);
    for (const LoopFromElsewhere& other : others_) builder.add_end(other, find);
    tree_.couplings.insert(tree_.couplings.begin(), subsystem_.couplings.begin(),
                           subsystem_.couplings.end());
    return std::move(tree_);
  }

 private:
  struct Added {
    std::size_t first, last;  ///< bodies of the beam in the tree
  };

  std::vector<const SubsystemJoint*> children_of(const std::string& name) const {
    std::vector<const SubsystemJoint*> joints;
    const auto [begin, end] = children_.equal_range(name);
    for (auto it = begin; it != end; ++it) joints.push_back(it->second);
    return joints;
  }

  const Body& body(const std::string& name) const {
    return *std::find_if(subsystem_.bodies.begin(), subsystem_.bodies.end(),
                         [&](const Body& b) { return b.name == name; });
  }

  /// Returns the handle that carries a joint; on a beam, that of the innermost body with a node
  /// there.
  Handle handle_of(const SubsystemJoint& joint) const {
    if (joint.parent == base_) return {};
    const Added& parent = added_.at(joint.parent);
    if (const auto* solid = std::get_if<SolidBody>(&body(joint.parent).shape))
      return {static_cast<int>(parent.first), find_interface(*solid, joint.interface).value()};
    const auto* beam = std::get_if<Beam>(&body(joint.parent).shape);
    if (beam == nullptr) return {static_cast<int>(parent.first), 0};
    for (std::size_t i = parent.first; i <= parent.last; ++i) {
      const auto node = find_node(std::get<FlexibleBody>(tree_.bodies[i].shape),
                                  joint.station.value_or(beam->length), resolution_of(*beam));
      if (node) return {static_cast<int>(i), *node};
    }
    assert(false && "places of children are nodes");
    return {};
  }

  /// Returns the handle that carries an axle.
  Handle carrier_of(const Axle& axle) const {
    SubsystemJoint carried;
    carried.parent = axle.body.empty() ? base_ : axle.body;
    carried.station = axle.station;
    carried.interface = axle.interface;
    return handle_of(carried);
  }

  void add(const SubsystemJoint& joint) {
    const Body& child = body(joint.child);
    const std::size_t first = tree_.bodies.size();
    const Handle parent = handle_of(joint);
    // On the hub the azimuth turns it.
    const Placement placement = parent.body < 0 ? Placement{Vector::Zero(), turn_} : Placement{};
    if (const auto* beam = std::get_if<Beam>(&child.shape)) {
      std::vector<double> places;
      for (const SubsystemJoint* further : children_of(child.name))
        places.push_back(further->station.value_or(beam->length));
      for (const double station : loop_stations(subsystem_.loops, others_, child.name, *beam))
        places.push_back(station);
      for (const int r : rotors_)
        if (const Axle& axle = axle_of(model_, r); axle.body == child.name)
          places.push_back(axle.station.value_or(beam->length));
      Beam chosen = *beam;
      chosen.strain = choose_strain(*beam, unknown_tension_);
      add_beam(tree_, chosen, child.name, {parent, placement, joint.joint}, {}, places);
    } else if (const auto* solid = std::get_if<SolidBody>(&child.shape)) {
      add_body(tree_, child.name, solids_.of(*solid), parent, placement, joint.joint);
    } else {
      add_body(tree_, child.name, std::get<RigidBody>(child.shape), parent, placement, joint.joint);
    }
    added_[child.name] = {first, tree_.bodies.size() - 1};
  }

  const Subsystem& subsystem_;
  const Model& model_;
  std::vector<LoopFromElsewhere> others_;
  const Support* support_;   ///< whose tree this is, or null
  std::string base_;         ///< name of what carries the tree
  std::vector<int> rotors_;  ///< that it carries
  std::string unknown_tension_;
  const SolidParts& solids_;
  Tensor turn_;  ///< turns by the azimuth, in the hub's frame
  /// Joints by the name of their parent.
  std::multimap<std::string, const SubsystemJoint*> children_;
  std::map<std::string, Added> added_;
  Tree tree_;
};

}  // namespace

Placement rotor_placement(const Hub& hub) {
  const Vector axis = hub.axis.normalized();
  // Among all half turns that take z to -z, the one about x is chosen.
  if (axis.z() < -1.0 + 1e-14) return {Vector::Zero(), Vector(1.0, -1.0, -1.0).asDiagonal()};
  return {Vector::Zero(), space::smallest_rotation(Vector::UnitZ(), axis).axes};
}

std::vector<Tree> build_trees(const Model& given) {
  const std::optional<Model> resolved = put_on_bodies_of_anchors(given);
  const Model& model = resolved ? *resolved : given;
  std::vector<Tree> trees;
  for (std::size_t i = 0; i < model.blades.size(); ++i)
    trees.push_back(build_tree(model.blades[i], model, i + 1));
  const SolidParts solids(model);
  while (trees.size() < model.blades.size() + model.subsystems.size())
    trees.push_back(SubsystemBuilder(trees.size(), model, solids).build());
  for (std::size_t i = 0; i < trees.size(); ++i) {
    const bool is_blade = i < model.blades.size();
    trees[i].key = is_blade ? "blades." + std::to_string(i + 1)
                            : key_of_subsystem(model, i - model.blades.size());
  }
  if (model.support) add_loops_on_hubs(model, trees);
  add_coupling_ends(model, trees);
  for (Tree& tree : trees)
    for (LoopEnd& end : tree.ends) end.owner = trees[end.tree].name;
  return trees;
}

}  // namespace spoke::spatial
