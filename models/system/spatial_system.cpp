// Makes the system of a description: hub or support, and the subsystems on it.

#include "models/system/spatial_system.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "models/air/blade_polars.h"
#include "models/error.h"
#include "models/system/make_drag.h"
#include "models/system/rotor_mass.h"
#include "models/system/shared_bodies.h"
#include "models/system/spatial_loads.h"
#include "models/system/spatial_subsystem.h"
#include "models/tree/drive_train.h"
#include "models/tree/mass_properties.h"
#include "models/tree/tree.h"

namespace spoke {
namespace {

space::Hub make_hub(const spatial::Hub& hub) {
  const space::Rotation to_axis = axis_rotation(hub).inverse();
  space::RigidBody body;
  body.mass = hub.mass;
  body.centre = to_axis * space::Position(hub.center);
  body.inertia = to_axis.axes * hub.inertia * to_axis.axes.transpose();
  space::Hub made;
  made.support = hub.support;
  made.drive = hub.drive;
  made.orientation = make_quaternion(to_axis.inverse());
  made.inertia = calc_mass(body);
  made.mass = hub.mass;
  made.mount = hub.mount;
  made.velocity = space::make_twist(hub.velocity, to_axis * space::Position(hub.angular_velocity));
  return made;
}

spatial::RigidBody body_of(const spatial::Fuselage& fuselage) {
  return {fuselage.mass, fuselage.center, fuselage.inertia};
}

/// Returns what a support stands on, as a hub: H has the axes of the ground, or of the fuselage.
space::Hub make_base(const spatial::Support& support, const spatial::Hub& hub,
                     const spatial::Tree& tree) {
  space::Hub made;
  if (support.from == spatial::SupportBase::ground) {
    made.drive = FixedDrive{};
    made.mount = hub.mount;
    return made;
  }
  const spatial::Fuselage& fuselage = support.fuselage;
  made.support = HubSupport::free;
  made.orientation = make_quaternion(space::exponential(fuselage.attitude));
  const spatial::RigidBody body = without_shares(body_of(fuselage), tree, -1);
  made.mass = body.mass;
  made.inertia = calc_mass(space::RigidBody{body.mass, body.center, body.inertia});
  made.position = fuselage.position;
  made.velocity = space::make_twist(fuselage.velocity, fuselage.angular_velocity);
  return made;
}

space::HubLoad make_hub_load(const spatial::HubLoad& load, const space::Rotation& to_axis) {
  const bool is_inertial = load.frame == spatial::LoadFrame::inertial;
  const space::Rotation R = is_inertial ? space::Rotation{} : to_axis;
  return {to_axis * space::Position(load.position),
          is_inertial ? LoadFrame::inertial : LoadFrame::hub,
          R * space::Position(load.force),
          R * space::Position(load.torque),
          load.ramp,
          load.factor};
}

/// Returns the centre of mass of a model, undeformed and with joint coordinates zero, in H [m].
space::Position find_mass_centre(const spatial::Hub& hub, const std::vector<spatial::Tree>& trees,
                                 const space::Rotation& to_axis) {
  double mass = hub.mass, extent = 0.0;
  space::Position moment = hub.mass * space::Position(hub.center);
  for (const spatial::Tree& tree : trees) {
    const std::vector<spatial::Placement> placements = calc_placements(tree);
    for (std::size_t j = 0; j < tree.bodies.size(); ++j) {
      const spatial::MassProperties body =
          calc_mass_properties(tree, tree.bodies[j]).seen_from_outside(placements[j]);
      mass += body.mass;
      moment += space::Position(body.first_moment);
      extent += body.first_moment.norm();
    }
  }
  // Where the trees balance one another, only round-off remains.
  if (moment.norm() <= 1e-12 * extent) return space::Position::Zero();
  return to_axis * space::Position(moment / mass);
}

/// Refuses motions by the azimuth where the hub is free in space: it has none.
void require_azimuth(const System<Space>& system) {
  if (system.hub.support == HubSupport::axle) return;
  for (const Subsystem<Space>& subsystem : system.subsystems) {
    if (subsystem.rotor >= 0) continue;
    for (const TreeBody<Space>& body : subsystem.bodies)
      for (const space::DrivenMotion& motion : body.joint.course.driven)
        if (std::holds_alternative<spatial::AzimuthMotion>(motion))
          throw InputError(
              "a joint's motion follows the azimuth of a hub that is free in space, expected a "
              "hub on an axle");
  }
}

/// Whether all that carries the axle of a rotor moves as prescribed.
bool is_moved(const System<Space>& system, const SupportedRotor& rotor) {
  if (system.hub.support == HubSupport::free ||
      system.subsystems[static_cast<std::size_t>(rotor.subsystem)].rotor >= 0)
    return false;
  std::vector<int> path = find_path(system, rotor);
  path.pop_back();  // the hub, whose origin is on the axle
  const auto& bodies = system.subsystems[static_cast<std::size_t>(rotor.subsystem)].bodies;
  return std::all_of(path.begin(), path.end(), [&bodies](int j) {
    const TreeBody<Space>& body = bodies[static_cast<std::size_t>(j)];
    return body.body->rigid() && body.joint.joint.coordinates == 0;
  });
}

/// Lets the joints of a subsystem that a controller names follow its angle. `tree`: that of the
/// subsystem.
void control_joints(const std::vector<std::string>& joints, const DemandedAngle& angle,
                    const spatial::Tree& tree, Subsystem<Space>& subsystem) {
  for (std::size_t j = 0; j < tree.bodies.size(); ++j) {
    const std::string& name = tree.bodies[j].joint.name;
    if (name.empty() || std::find(joints.begin(), joints.end(), name) == joints.end()) continue;
    subsystem.bodies[j].joint.course.control = 0;
    subsystem.controls = {angle};
  }
}

/// Lets the joints of a subsystem follow the controller of a model.
void control_joints(const spatial::Model& model, const spatial::Tree& tree, bool is_support,
                    Subsystem<Space>& subsystem) {
  if (const auto& law = model.pitch_control; law && !is_support)
    control_joints(law->joints, {law, true, law->initial, law->sign}, tree, subsystem);
  const auto& outer = model.outer_control;
  if (outer && is_support)
    control_joints({outer->yaw_joint}, {{}, false, 0.0, 1.0}, tree, subsystem);
  if (outer && !is_support && tree.rotor == 0)
    control_joints(outer->joints, {{}, true, outer->initial, outer->sign}, tree, subsystem);
}

/// Turns the loads on the hub of a rotor to loads on the body that it is.
void move_hub_loads(const spatial::Model& model, int rotor, TreeBody<Space>& hub) {
  const space::Rotation to_axis = axis_rotation(hub_of(model, rotor)).inverse();
  for (const spatial::HubLoad& load : model.hub_loads) {
    if (load.rotor != rotor) continue;
    const space::HubLoad made = make_hub_load(load, to_axis);
    BodyLoad<Space> moved{
        {},
        load.frame == spatial::LoadFrame::inertial ? spatial::LoadFrame::inertial
                                                   : spatial::LoadFrame::body,
        made.force,
        made.moment,
        std::make_shared<LoadCourse>(LoadCourse{load.factor, load.ramp, load.name})};
    moved.points.push_back({0, 0.0, 1.0, made.position});
    hub.loads.push_back(std::move(moved));
  }
}

/// Whether a coupling acts on the joint that carries a body.
bool couples_axle(const Subsystem<Space>& carrier, int body) {
  return std::any_of(carrier.loops.begin(), carrier.loops.end(), [body](const LoopModel& loop) {
    return std::any_of(loop.coupled.begin(), loop.coupled.end(),
                       [body](const CoupledCoordinate& at) { return at.body == body; });
  });
}

/// Puts the rotors on the subsystems that carry them, which are made.
void add_rotors(const spatial::Model& model, const std::vector<spatial::Tree>& trees,
                System<Space>& system) {
  for (int r = 0; r < count_rotors(model); ++r) {
    const spatial::BodyAt hub = find_hub(trees, r);
    Subsystem<Space>& carrier = system.subsystems[hub.tree];
    move_hub_loads(model, r, carrier.bodies[hub.body]);
    SupportedRotor& rotor = system.rotors.emplace_back();
    rotor.subsystem = static_cast<int>(hub.tree);
    rotor.body = static_cast<int>(hub.body);
    const spatial::Axle& axle = axle_of(model, r);
    rotor.driven = rotor.body - (axle.train ? 1 : 0);  // see build_trees()
    if (axle.train) rotor.gear_ratio = axle.train->gear_ratio;
    rotor.is_coupled = couples_axle(carrier, rotor.body);
    rotor.is_moved = is_moved(system, rotor);
    rotor.prefix = prefix_of_rotor(model, r);
  }
}

/// Whether a loop of a tree, or a coupling behind these, spans several.
bool spans_several(const spatial::Tree& tree, std::size_t loop) {
  if (loop < tree.loops.size()) return tree.loops[loop].to.carrier == LoopPlace::Carrier::elsewhere;
  const std::vector<CoupledJoint>& joints = tree.couplings[loop - tree.loops.size()].joints;
  return std::any_of(joints.begin(), joints.end(),
                     [](const CoupledJoint& at) { return at.is_elsewhere(); });
}

/// Finds the loops and couplings that span several subsystems, and their shares.
void list_shared_loops(const std::vector<spatial::Tree>& trees, System<Space>& system) {
  const auto at = [](std::size_t subsystem, std::size_t loop) {
    return LoopAt{static_cast<int>(subsystem), static_cast<int>(loop)};
  };
  const auto mark = [&system](const LoopAt& share) {
    system.subsystems[static_cast<std::size_t>(share.subsystem)]
        .loops[static_cast<std::size_t>(share.loop)]
        .shared = static_cast<int>(system.shared_loops.size()) - 1;
  };
  const auto own_loops = [](const spatial::Tree& tree) {
    return tree.loops.size() + tree.couplings.size();
  };
  for (std::size_t i = 0; i < trees.size(); ++i)
    for (std::size_t k = 0; k < own_loops(trees[i]); ++k) {
      if (!spans_several(trees[i], k)) continue;
      SharedLoop& shared = system.shared_loops.emplace_back();
      mark(shared.own = at(i, k));
      for (std::size_t j = 0; j < trees.size(); ++j) {
        const spatial::Tree& tree = trees[j];
        for (std::size_t e = 0; e < tree.ends.size(); ++e) {
          if (tree.ends[e].tree != i || tree.ends[e].number != k) continue;
          const LoopAt share = at(j, own_loops(tree) + e);
          mark(share);
          if (tree.ends[e].is_on_hub)
            shared.on_hubs.push_back(
                {share, tree.bodies[static_cast<std::size_t>(tree.ends[e].place.body)].rotor});
          else
            shared.ends.push_back(share);
        }
      }
    }
}

/// Places the aerodynamics of a blade on the bodies of its subsystem; where two bodies meet, a
/// station is on the inner one. `alike`: the air on a blade of equal aerodynamics, or none.
std::shared_ptr<const BladeAirModel> make_blade_air(const spatial::Blade& blade,
                                                    const std::shared_ptr<const spatial::Air>& air,
                                                    double hub_radius, int blades,
                                                    const BladeAirModel* alike,
                                                    const Subsystem<Space>& subsystem) {
  BladeAirModel made{*blade.aerodynamics, air, blades, hub_radius, hub_radius, {}, {}};
  made.tip_radius += blade.beam.length * std::cos(blade.precone);
  for (const double station : blade.aerodynamics->station) {
    std::size_t j = 0;
    const auto own = [&] { return station - subsystem.bodies[j].begin; };
    while (j + 1 < subsystem.bodies.size() && subsystem.bodies[j + 1].body->flexible() &&
           subsystem.bodies[j].body->flexible()->stations.back() < own())
      ++j;
    made.places.push_back({static_cast<int>(j), own()});
  }
  made.polars =
      alike ? alike->polars : air::make_polars(made.aerodynamics, *air, made.aerodynamics.station);
  return std::make_shared<const BladeAirModel>(std::move(made));
}

/// Returns the air on a blade that has the same aerodynamics, if it is made already.
const BladeAirModel* find_alike(const spatial::BladeAerodynamics& aerodynamics,
                                const std::vector<Subsystem<Space>>& subsystems) {
  for (const Subsystem<Space>& subsystem : subsystems)
    if (subsystem.air && subsystem.air->aerodynamics == aerodynamics) return subsystem.air.get();
  return nullptr;
}

/// Returns the description of the bodies of a tree that is no blade's.
const std::vector<spatial::Body>& bodies_of_tree(const spatial::Model& model, std::size_t tree) {
  return model.subsystems[tree - model.blades.size()].bodies;
}

/// Lets air act on the blades that have aerodynamics, and on bodies that have drag.
void add_air(const spatial::Model& model, const std::vector<spatial::Tree>& trees,
             System<Space>& system) {
  const auto air = std::make_shared<const spatial::Air>(*model.air);
  system.wind = make_wind(air->wind);
  const auto count_in_air = [&model](int rotor) {
    return static_cast<int>(std::count_if(
        model.blades.begin(), model.blades.end(), [rotor](const spatial::Blade& blade) {
          return blade.rotor == rotor && blade.aerodynamics.has_value();
        }));
  };
  for (std::size_t i = 0; i < model.blades.size(); ++i)
    if (const spatial::Blade& blade = model.blades[i]; blade.aerodynamics)
      system.subsystems[i].air =
          make_blade_air(blade, air, hub_of(model, blade.rotor).radius, count_in_air(blade.rotor),
                         find_alike(*blade.aerodynamics, system.subsystems), system.subsystems[i]);
  for (std::size_t i = model.blades.size(); i < trees.size(); ++i)
    system.subsystems[i].drag =
        make_drag(bodies_of_tree(model, i), trees[i], system.subsystems[i], air->density);
}

}  // namespace

System<Space> make_system(const spatial::Model& model, const std::vector<spatial::Tree>& trees,
                          const solid::Control& control) {
  assert(trees.size() == model.blades.size() + model.subsystems.size());
  assert(std::all_of(trees.begin(), trees.end(), [](const spatial::Tree& tree) {
    return !tree.bodies.empty() && tree.bodies.front().parent < 0;
  }));
  const space::Rotation to_axis = axis_rotation(model.hub).inverse();
  System<Space> system;
  system.hub = make_hub(model.hub);
  system.gravity = model.gravity;
  system.gravity_ramp = model.gravity_ramp;
  system.damping = model.damping;
  const std::size_t on_hub = trees.size() - (model.support ? 1 : 0);
  if (!model.support)
    for (const spatial::HubLoad& load : model.hub_loads)
      system.hub_loads.push_back(make_hub_load(load, to_axis));
  space::Position centre = space::Position::Zero();
  if (model.hub.support == HubSupport::free) centre = find_mass_centre(model.hub, trees, to_axis);
  const MachineCentre machine = find_machine_centre(model, trees);
  SharedBodies bodies(model.damping, control);
  std::vector<CarriedRotor> carried;
  if (model.support) carried = list_carried(model, trees);
  for (std::size_t i = 0; i < on_hub; ++i) {
    const int rotor = trees[i].rotor;
    if (model.support) centre = machine.from_hubs[static_cast<std::size_t>(rotor)];
    system.subsystems.push_back(
        make_subsystem(trees[i],
                       {.to_axis = axis_rotation(hub_of(model, rotor)).inverse(),
                        .centre = centre,
                        .rotors = carried},
                       make_body_loads(model, trees[i], i), bodies));
    if (model.support) system.subsystems.back().rotor = rotor;
    control_joints(model, trees[i], false, system.subsystems.back());
  }
  if (model.support) {
    const spatial::Tree& tree = trees.back();
    system.hub = make_base(*model.support, model.hub, tree);
    const SubsystemSetting setting{
        .centre = machine.from_base, .rotors = carried, .base = body_of(model.support->fuselage)};
    system.subsystems.push_back(
        make_subsystem(tree, setting, make_body_loads(model, tree, on_hub), bodies));
    control_joints(model, tree, true, system.subsystems.back());
    add_rotors(model, trees, system);
  }
  list_shared_loops(trees, system);
  for (const Anchor& anchor : model.anchors) {
    // What a support stands on has the axes of the description.
    const bool is_of_base = model.support && anchor.frame == Anchor::Frame::mount;
    system.anchors.push_back(
        make_anchor(anchor, is_of_base ? space::Rotation{}
                                       : axis_rotation(hub_of(model, anchor.rotor)).inverse()));
  }
  if (model.air) add_air(model, trees, system);
  require_azimuth(system);
  return system;
}

System<Space> make_support_alone(const spatial::Model& model,
                                 const std::vector<spatial::Tree>& trees,
                                 const std::vector<Ballast>& ballasts,
                                 const solid::Control& control) {
  assert(model.support && std::cmp_equal(ballasts.size(), count_rotors(model)));
  spatial::Tree tree = trees.back();
  for (int r = 0; r < count_rotors(model); ++r) {
    const Ballast& ballast = ballasts[static_cast<std::size_t>(r)];
    spatial::TreeBody& hub = tree.bodies[find_hub(tree, r)];
    hub.shape = spatial::RigidBody{ballast.mass, spatial::Vector::Zero(),
                                   ballast.inertia * spatial::Tensor::Identity()};
    hub.joint.coordinates[0].motion = spatial::MotionTable{};
  }
  System<Space> system;
  system.hub = make_base(*model.support, model.hub, tree);
  system.gravity = model.gravity;
  system.gravity_ramp = model.gravity_ramp;
  system.damping = model.damping;
  SharedBodies bodies(model.damping, control);
  const MachineCentre machine = find_machine_centre(model, trees);
  system.subsystems.push_back(make_subsystem(
      tree,
      {.centre = machine.from_base, .is_alone = true, .base = body_of(model.support->fuselage)},
      make_body_loads(model, tree, trees.size() - 1), bodies));
  for (const Anchor& anchor : model.anchors)
    system.anchors.push_back(make_anchor(anchor, space::Rotation{}));
  if (!model.air) return system;
  Subsystem<Space>& support = system.subsystems.back();
  support.drag =
      make_drag(bodies_of_tree(model, trees.size() - 1), tree, support, model.air->density);
  system.wind = make_wind(model.air->wind);
  return system;
}

System<Space> make_system(const spatial::Model& model) {
  return make_system(model, build_trees(model));
}

std::vector<int> find_path(const System<Space>& system, const SupportedRotor& rotor) {
  std::vector<int> path;
  const auto& bodies = system.subsystems[static_cast<std::size_t>(rotor.subsystem)].bodies;
  for (int j = rotor.body; j >= 0; j = bodies[static_cast<std::size_t>(j)].parent)
    path.push_back(j);
  std::reverse(path.begin(), path.end());
  return path;
}

const Drive& drive_of(const System<Space>& system, int number) {
  assert(number == 0 || std::cmp_less(number, system.rotors.size()));
  if (system.rotors.empty()) return system.hub.drive;
  const SupportedRotor& rotor = system.rotors[static_cast<std::size_t>(number)];
  return *system.subsystems[static_cast<std::size_t>(rotor.subsystem)]
              .bodies[static_cast<std::size_t>(rotor.driven)]
              .joint.course.drive;
}

bool is_hub_prescribed(const System<Space>& system, int number) {
  const Drive& drive = drive_of(system, number);
  if (system.rotors.empty()) return prescribes_motion(drive);
  const SupportedRotor& rotor = system.rotors[static_cast<std::size_t>(number)];
  return rotor.driven == rotor.body && prescribes_motion(drive);
}

Drive& drive_of(System<Space>& system, int number) {
  return const_cast<Drive&>(drive_of(std::as_const(system), number));
}

}  // namespace spoke
