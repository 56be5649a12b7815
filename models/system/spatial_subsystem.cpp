// Makes bodies, joints, loops, tension and loads of a subsystem.

#include "models/system/spatial_subsystem.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "models/system/coupling_model.h"
#include "models/system/solid_tension.h"
#include "models/tree/axle_carrier.h"
#include "models/tree/drive_train.h"
#include "models/tree/mass_properties.h"
#include "models/tree/space_joint.h"

namespace spoke {
namespace {

using spatial::Placement;

space::Pose pose_of(const Placement& placement) {
  return {placement.position, {placement.rotation}};
}

/// Makes the subsystem of one tree.
class SubsystemMaker {
 public:
  SubsystemMaker(const spatial::Tree& tree, const SubsystemSetting& setting, SharedBodies& made)
      : tree_(tree),
        to_axis_(setting.to_axis),
        centre_(setting.centre),
        rotors_(setting.rotors),
        is_alone_(setting.is_alone),
        base_(setting.base),
        placements_(calc_placements(tree)),
        places_(find_places(tree)),
        shared_(made) {
    for (std::size_t k = 0; k < tree.beams.size(); ++k)
      beams_.push_back(made.find_or_make(tree.beams[k], nodes_of(k)));
  }

  /// Makes the subsystem. `loads`: by body, as the description resolves them.
  Subsystem<Space> make(std::vector<std::vector<BodyLoad<Space>>> loads) {
    find_children();
    for (std::size_t j = 0; j < tree_.bodies.size(); ++j) add_body(j);
    for (std::size_t k = 0; k < beams_.size(); ++k) add_modes(k);
    for (const spatial::TreeLoop& loop : tree_.loops) add_loop(loop);
    for (std::size_t k = 0; k < tree_.couplings.size(); ++k)
      made_.loops.push_back(make_coupling(tree_, k));
    for (const spatial::LoopEnd& end : tree_.ends) add_share(end);
    for (std::size_t j = 0; j < tree_.bodies.size(); ++j) add_joint(j);
    for (std::size_t j = 0; j < tree_.bodies.size(); ++j)
      made_.bodies[j].joint.slide = find_slide(j);
    add_tension();
    for (std::size_t j = 0; j < loads.size(); ++j) add_loads(j, std::move(loads[j]));
    made_.root = {to_axis_ * pose_of(placements_[0]).p, to_axis_ * pose_of(placements_[0]).R};
    const std::size_t last = find_tip_body(tree_);
    made_.tip = place_of(last) * tip_of(last);
    return std::move(made_);
  }

 private:
  const spatial::TreeBody& body(std::size_t j) const { return tree_.bodies[j]; }
  const spatial::FlexibleBody* flexible(std::size_t j) const {
    return std::get_if<spatial::FlexibleBody>(&body(j).shape);
  }
  const spatial::SolidPart* solid(std::size_t j) const {
    return std::get_if<spatial::SolidPart>(&body(j).shape);
  }

  /// Whether a body is the hub of a rotor that turns on its axle.
  bool is_hub(std::size_t j) const { return body(j).is_hub() && !is_alone_; }
  const CarriedRotor& rotor_of(std::size_t j) const {
    return rotors_[static_cast<std::size_t>(body(j).rotor)];
  }

  /// Returns the bodies that are parts of a beam, from its root to its tip.
  std::vector<std::size_t> parts_of(std::size_t beam) const {
    std::vector<std::size_t> parts;
    for (std::size_t j = 0; j < tree_.bodies.size(); ++j)
      if (flexible(j) && flexible(j)->beam == beam) parts.push_back(j);
    std::sort(parts.begin(), parts.end(), [this](std::size_t a, std::size_t b) {
      return flexible(a)->nodes.front() < flexible(b)->nodes.front();
    });
    return parts;
  }

  /// Returns the stations of all nodes of a beam. The last node of a part is the first of the next.
  std::vector<double> nodes_of(std::size_t beam) const {
    std::vector<double> nodes;
    for (const std::size_t j : parts_of(beam)) {
      if (!nodes.empty()) nodes.pop_back();
      nodes.insert(nodes.end(), flexible(j)->nodes.begin(), flexible(j)->nodes.end());
    }
    return nodes;
  }

  /// Shares the modes that damp a beam out to its parts.
  void add_modes(std::size_t beam) {
    const BeamModes* modes = beams_[beam].modes.get();
    if (!modes) return;
    int node = 0;
    for (const std::size_t j : parts_of(beam)) {
      const space::FlexibleBody& body = *made_.bodies[j].body->flexible();
      made_.bodies[j].modal = make_modal_share(*modes, body, node);
      made_.bodies[j].modal.first = static_cast<int>(made_.modal_factors.size());
      node += body.elements;
    }
    made_.modal_factors.insert(made_.modal_factors.end(), modes->factors.begin(),
                               modes->factors.end());
  }

  /// Returns a body's frame B in the body's frame of the description.
  space::Rotation frame_of(std::size_t j) const {
    const space::FlexibleBody* flexible = made_.bodies[j].body->flexible();
    return flexible ? flexible->pose.R : space::Rotation{};
  }

  struct Place {
    space::Pose pose;
    space::Position operator*(const space::Position& p) const { return pose.p + pose.R * p; }
  };
  /// Returns a body's frame B in H, joint coordinates zero.
  Place place_of(std::size_t j) const {
    const space::Pose at = pose_of(placements_[j]);
    return {{to_axis_ * at.p, to_axis_ * at.R * frame_of(j)}};
  }
  space::Position tip_of(std::size_t j) const {
    const space::Body& made = *made_.bodies[j].body;
    if (made.solid()) return made.solid()->constants->tip.p;
    return made.flexible() ? made.flexible()->nodes.back() : made.rigid()->centre;
  }

  /// Finds the children of all bodies in the order of the nodes that they hang at.
  void find_children() {
    made_.bodies.resize(tree_.bodies.size());
    for (std::size_t c = 0; c < tree_.bodies.size(); ++c) {
      const int parent = made_.bodies[c].parent = body(c).parent;
      if (parent >= 0)
        made_.bodies[static_cast<std::size_t>(parent)].children.push_back(static_cast<int>(c));
    }
    for (TreeBody<Space>& made : made_.bodies)
      std::stable_sort(made.children.begin(), made.children.end(), [this](int a, int b) {
        return body(static_cast<std::size_t>(a)).parent_node <
               body(static_cast<std::size_t>(b)).parent_node;
      });
  }

  using Places = std::vector<const spatial::TreePlace*>;

  /// Returns the places of loops by body.
  static std::vector<Places> find_places(const spatial::Tree& tree) {
    std::vector<Places> places(tree.bodies.size());
    for (const spatial::TreeLoop& loop : tree.loops)
      for (const spatial::TreePlace* place : {&loop.from, &loop.to})
        if (place->carrier == LoopPlace::Carrier::body)
          places[static_cast<std::size_t>(place->body)].push_back(place);
    for (const spatial::LoopEnd& end : tree.ends)
      if (end.has_place()) places[static_cast<std::size_t>(end.place.body)].push_back(&end.place);
    return places;
  }

  LoopPlaceModel make_place(const spatial::TreePlace& place) const {
    LoopPlaceModel made;
    made.carrier = place.carrier;
    made.offset = pose_of(place.placement);
    if (place.carrier == LoopPlace::Carrier::anchor) made.anchor = static_cast<int>(place.anchor);
    if (place.carrier == LoopPlace::Carrier::elsewhere) return made;
    if (place.carrier != LoopPlace::Carrier::body) {
      // Anchors have the axes of H as well; H is that of the drive.
      made.offset = {to_axis_ * made.offset.p, to_axis_ * made.offset.R};
      return made;
    }
    const auto j = static_cast<std::size_t>(place.body);
    const Places& places = places_[j];
    made.body = place.body;
    made.handle =
        static_cast<int>(made_.bodies[j].children.size()) + 1 +
        static_cast<int>(std::find(places.begin(), places.end(), &place) - places.begin());
    const space::Rotation back = frame_of(j).inverse();
    if (place.is_moved) {
      made.anchor = static_cast<int>(place.anchor);
      made.base.R = back;
      return made;
    }
    // The handle of a rigid body is where the place is.
    const bool is_rigid = made_.bodies[j].body->rigid() != nullptr;
    made.offset = {is_rigid ? space::Position(space::Position::Zero()) : back * made.offset.p,
                   back * made.offset.R};
    return made;
  }

  void add_loop(const spatial::TreeLoop& loop) {
    LoopModel& made = made_.loops.emplace_back(make_loop(loop.loop, false));
    made.owner = tree_.name;
    made.key = tree_.key + ".loop." + std::to_string(made_.loops.size());
    made.from = make_place(loop.from);
    made.to = make_place(loop.to);
  }

  /// Adds the share of a loop or a coupling of another tree.
  void add_share(const spatial::LoopEnd& end) {
    LoopModel& made = made_.loops.emplace_back(
        end.coupling ? make_coupling_share(tree_, *end.coupling) : make_loop(end.loop, false));
    made.name = end.owner + " / " + end.name();
    if (end.is_on_hub) made.name += " / " + body(static_cast<std::size_t>(end.place.body)).name;
    made.owner = tree_.name;
    made.is_share = true;
    if (end.has_place()) made.from = make_place(end.place);
    made.to.carrier = LoopPlace::Carrier::elsewhere;
  }

  /// Returns the nodes or interfaces of a body's handles.
  std::vector<int> handles_of(std::size_t j) const {
    std::vector<int> handles{0};
    for (const int c : made_.bodies[j].children)
      handles.push_back(static_cast<int>(body(static_cast<std::size_t>(c)).parent_node));
    for (const spatial::TreePlace* place : places_[j])
      handles.push_back(static_cast<int>(place->node));
    return handles;
  }

  /// Returns a rigid body as the equations have it.
  spatial::RigidBody rigid_body(std::size_t j) const {
    const spatial::TreeBody& own = body(j);
    const auto& rigid = std::get<spatial::RigidBody>(own.shape);
    if (!own.is_generator()) return without_shares(rigid, tree_, static_cast<int>(j));
    return with_share(tree_, j, base_);
  }

  void add_body(std::size_t j) {
    TreeBody<Space>& made = made_.bodies[j];
    if (const spatial::FlexibleBody* part = flexible(j)) {
      const SharedBodies::PlacedBody placed =
          shared_.find_or_make_body(beams_[part->beam].beam, part->nodes,
                                    tree_.beams[part->beam].reference_frame, handles_of(j));
      made.body = placed.body;
      made.begin = placed.begin;
      return;
    }
    if (const spatial::SolidPart* part = solid(j)) {
      made.body = shared_.find_or_make_solid(*part, handles_of(j));
      return;
    }
    const spatial::RigidBody rigid = rigid_body(j);
    space::RigidBody shape{rigid.mass, rigid.center, rigid.inertia, {}, rigid.spin, is_hub(j)};
    for (const int c : made.children)
      shape.outboard.emplace_back(body(static_cast<std::size_t>(c)).placement.position);
    for (const spatial::TreePlace* place : places_[j])
      shape.outboard.emplace_back(place->is_moved ? spatial::Vector(spatial::Vector::Zero())
                                                  : place->placement.position);
    made.body = std::make_shared<const space::Body>(space::Body{std::move(shape), nullptr});
  }

  void add_joint(std::size_t j) {
    TreeBody<Space>& made = made_.bodies[j];
    const space::Pose at = pose_of(body(j).placement);
    const space::Rotation own = frame_of(j);
    space::Joint& joint = made.joint.joint =
        spatial::make_space_joint(body(j).joint, body(j).placement);
    if (made.parent < 0) {
      joint.offset = {to_axis_ * at.p, to_axis_ * at.R * own};
    } else {
      const auto p = static_cast<std::size_t>(made.parent);
      const space::Rotation back = frame_of(p).inverse();
      // The handle of a rigid parent is where the joint is.
      const bool is_rigid = made_.bodies[p].body->rigid() != nullptr;
      joint.offset = {is_rigid ? space::Position(space::Position::Zero()) : back * at.p,
                      back * at.R * own};
      const std::vector<int>& siblings = made_.bodies[p].children;
      made.handle =
          1 + static_cast<int>(std::find(siblings.begin(), siblings.end(), static_cast<int>(j)) -
                               siblings.begin());
    }
    // Axes are given in the description's frame of the body.
    for (space::JointPrimitive& primitive : joint.primitives)
      primitive.axis = own.inverse() * primitive.axis;
    made.joint.course = make_course(body(j).joint);
    if (body(j).joint.hold)
      made.joint.course.held =
          body(j).joint.name.empty() ? "that of " + body(j).name : body(j).joint.name;
    if (is_alone_ || body(j).driven_by < 0) return;
    made.joint.course.drive = rotors_[static_cast<std::size_t>(body(j).driven_by)].drive;
    made.joint.course.drive_ratio = body(j).drive_ratio;
  }

  space::JointCourse make_course(const spatial::Joint& joint) const {
    space::JointCourse course;
    course.azimuth = tree_.azimuth;
    for (int c = 0; c < count_coordinates(joint.kind); ++c) {
      const spatial::JointCoordinate& coordinate = joint.coordinates[static_cast<std::size_t>(c)];
      if (coordinate.motion) {
        course.driven.push_back(spatial::make_driven_motion(*coordinate.motion));
        continue;
      }
      if (coordinate.relaxation)
        course.relaxing.push_back({static_cast<int>(course.efforts.size()),
                                   coordinate.relaxation->stiffness, coordinate.relaxation->time});
      course.efforts.push_back(coordinate.effort);
      course.initial.push_back(coordinate.initial);
      course.initial_speed.push_back(coordinate.initial_speed);
    }
    return course;
  }

  bool is_stiffened(std::size_t j) const {
    // With mean axes a solid is stiffened by its own rotation.
    if (const space::Solid* solid = made_.bodies[j].body->solid())
      return solid->constants->is_stiffened &&
             solid->constants->frame == spatial::SolidFrame::clamped;
    const spatial::FlexibleBody* part = flexible(j);
    if (!part) return false;
    const spatial::Beam& beam = tree_.beams[part->beam];
    return beam.geometric_stiffening && beam.strain == spatial::BeamStrain::linear;
  }

  /// Finds the coordinate of a joint that slides, and its axis in the parent's frame. It must not
  /// turn with other coordinates.
  std::optional<space::JointSlide> find_free_slide(const space::Joint& joint) const {
    using Kind = space::JointPrimitive::Kind;
    std::optional<space::JointSlide> slide;
    int coordinate = 0;
    for (const space::JointPrimitive& primitive : joint.sequence()) {
      if (primitive.kind == Kind::prismatic && !primitive.is_driven) {
        if (slide) return {};
        slide = {coordinate, joint.offset.R * primitive.axis};
      }
      if (!primitive.is_driven) coordinate += primitive.components();
    }
    if (!slide) return {};
    for (const space::JointPrimitive& primitive : joint.sequence()) {
      if (primitive.kind == Kind::prismatic) break;
      const space::Position axis = joint.offset.R * primitive.axis;
      if (primitive.kind == Kind::spherical || std::abs(axis.dot(slide->axis)) < 1.0 - 1e-9)
        return {};
    }
    return slide;
  }

  /// Finds whether the joint that carries a body slides along bodies inboard, which must be beams,
  /// none of them at an angle to it, or bent.
  std::optional<space::JointSlide> find_slide(std::size_t j) const {
    const TreeBody<Space>& body = made_.bodies[j];
    if (body.parent < 0) return {};
    std::optional<space::JointSlide> slide = find_free_slide(body.joint.joint);
    if (!slide) return {};
    slide->axis = place_of(static_cast<std::size_t>(body.parent)).pose.R * slide->axis;
    bool is_along = false;
    for (int i = body.parent; i >= 0; i = made_.bodies[static_cast<std::size_t>(i)].parent) {
      const auto k = static_cast<std::size_t>(i);
      if (!is_stiffened(k)) continue;
      if (!flexible(k)) return {};
      const double along = std::abs(place_of(k).pose.R.axes.col(0).dot(slide->axis));
      if (!made_.bodies[k].body->flexible()->is_straight || (along > 1e-9 && along < 1.0 - 1e-9))
        return {};
      is_along |= along > 0.5;
    }
    return is_along ? slide : std::nullopt;
  }

  /// Returns mass and first moment of all bodies whose inertia a joint hands on to a body along an
  /// axis.
  spatial::MassProperties calc_branch_along(
      std::size_t c, const space::Position& axis,
      const std::vector<spatial::MassProperties>& bodies) const {
    const std::optional<space::JointSlide>& slide = made_.bodies[c].joint.slide;
    if (slide && std::abs(slide->axis.dot(axis)) > 0.5) return {};
    spatial::MassProperties branch = bodies[c];
    for (const int child : made_.bodies[c].children)
      branch += calc_branch_along(static_cast<std::size_t>(child), axis, bodies);
    return branch;
  }

  /// Returns for each body its mass and first moment about the hub, in the description's frame of
  /// the hub.
  std::vector<spatial::MassProperties> calc_masses() const {
    std::vector<spatial::MassProperties> masses;
    for (std::size_t j = 0; j < tree_.bodies.size(); ++j)
      masses.push_back((is_hub(j) ? rotor_of(j).mass : calc_mass_properties(tree_, body(j)))
                           .seen_from_outside(placements_[j]));
    return masses;
  }

  /// Returns for each body its mass and first moment together with those of all bodies it carries.
  std::vector<spatial::MassProperties> sum_branches(
      std::vector<spatial::MassProperties> branches) const {
    for (std::size_t j = branches.size(); j-- > 0;)
      for (const int c : made_.bodies[j].children)
        branches[j] += branches[static_cast<std::size_t>(c)];
    return branches;
  }

  /// Finds the masses that the elements of a body carry, in B: each child hangs at a node of its
  /// own or a shared one.
  std::vector<space::CarriedMass> find_carried(
      std::size_t j, const space::Rotation& to_body,
      const std::vector<spatial::MassProperties>& branches) const {
    const std::vector<int>& children = made_.bodies[j].children;  // children from the root outward
    std::vector<space::CarriedMass> carried;                      // masses from the tip inward
    carried.push_back({static_cast<int>(flexible(j)->nodes.size()) - 1});
    for (auto c = children.rbegin(); c != children.rend(); ++c) {
      const auto child = static_cast<std::size_t>(*c);
      const int node = static_cast<int>(body(child).parent_node);
      if (node == 0) break;  // no element carries it
      if (node < carried.back().end) {
        carried.push_back(carried.back());
        carried.back().end = node;
      }
      const double mass = branches[child].mass;
      const space::Position moment = to_axis_ * space::Position(branches[child].first_moment);
      carried.back().mass += mass;
      carried.back().moment += to_body * space::Position(moment - mass * centre_);
    }
    std::reverse(carried.begin(), carried.end());
    return carried;
  }

  /// Finds the geometric stiffness of a solid by all that hangs at its places.
  std::shared_ptr<const space::SolidTension> find_solid_tension(
      std::size_t j, const space::Pose& pose,
      const std::vector<spatial::MassProperties>& branches) const {
    std::vector<OutboardMass> outboard;
    for (const int c : made_.bodies[j].children) {
      const auto child = static_cast<std::size_t>(c);
      outboard.push_back(make_outboard_mass(body(child).parent_node, branches[child], to_axis_,
                                            centre_, pose.R.inverse()));
      set_handed_on(made_.bodies[child].joint.joint, outboard.back());
    }
    return make_solid_tension(*made_.bodies[j].body->solid()->constants,
                              pose.R.inverse() * space::Position(pose.p - centre_), outboard);
  }

  void add_tension() {
    const std::vector<spatial::MassProperties> masses = calc_masses();
    const std::vector<spatial::MassProperties> branches = sum_branches(masses);
    const bool slides =
        std::any_of(made_.bodies.begin(), made_.bodies.end(),
                    [](const TreeBody<Space>& body) { return body.joint.slide.has_value(); });
    for (std::size_t j = 0; j < tree_.bodies.size(); ++j) {
      if (!is_stiffened(j)) continue;
      const space::Pose pose = place_of(j).pose;
      const space::Rotation to_body = pose.R.inverse();
      space::TensionPlace tension{pose.R, to_body * space::Position(pose.p - centre_), {}, {}};
      if (solid(j)) {
        tension.solid = find_solid_tension(j, pose, branches);
      } else {
        std::vector<spatial::MassProperties> along;  // used only where something slides
        for (std::size_t c = 0; slides && c < branches.size(); ++c)
          along.push_back(calc_branch_along(c, pose.R.axes.col(0), masses));
        tension.carried = find_carried(j, to_body, slides ? along : branches);
      }
      made_.bodies[j].stiffening = std::move(tension);
    }
  }

  /// Adds the loads on a body, their vectors turned to H and B.
  void add_loads(std::size_t j, std::vector<BodyLoad<Space>> loads) {
    for (BodyLoad<Space>& load : loads) {
      space::Rotation R;
      if (load.frame == spatial::LoadFrame::hub) R = to_axis_;
      if (load.frame == spatial::LoadFrame::body) R = frame_of(j).inverse();
      load.force = R * space::Position(load.force);
      load.moment = R * space::Angular(load.moment);
    }
    made_.bodies[j].loads = std::move(loads);
  }

  const spatial::Tree& tree_;
  space::Rotation to_axis_;
  space::Position centre_;
  const std::vector<CarriedRotor>& rotors_;
  bool is_alone_;
  spatial::RigidBody base_;
  /// Placements of bodies in the frame of the description's hub.
  std::vector<Placement> placements_;
  /// Places of loops by body. They have the handles behind those of its children.
  std::vector<Places> places_;
  SharedBodies& shared_;
  std::vector<SharedBodies::MadeBeam> beams_;  ///< beams of the tree
  Subsystem<Space> made_;
};

}  // namespace

Subsystem<Space> make_subsystem(const spatial::Tree& tree, const SubsystemSetting& setting,
                                std::vector<std::vector<BodyLoad<Space>>> loads,
                                SharedBodies& bodies) {
  return SubsystemMaker(tree, setting, bodies).make(std::move(loads));
}

}  // namespace spoke
