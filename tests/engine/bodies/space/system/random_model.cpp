#include "tests/engine/bodies/space/system/random_model.h"

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "tests/models/space/random_space.h"

namespace spoke::spatial::testing {
namespace {

/// Draws what a model is made of.
class Dice {
 public:
  explicit Dice(std::mt19937& random) : random_(random) {}

  int index(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
  bool happens(double probability) { return std::bernoulli_distribution(probability)(random_); }
  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Vector vector(double size) {
    const double x = number(-size, size), y = number(-size, size);
    return {x, y, number(-size, size)};
  }
  Vector axis() {
    Vector v = vector(1.0);
    while (v.norm() < 0.3) v = vector(1.0);
    return v.normalized();
  }
  /// About the centre of mass of a body: those of a real one.
  Tensor inertia(double size) {
    const Vector moments{number(1.0, 2.0), number(1.0, 2.0), number(1.0, 2.0)};
    const Tensor turn = space::exponential(vector(1.0)).axes;
    return size * (turn * moments.asDiagonal() * turn.transpose());
  }

 private:
  std::mt19937& random_;
};

RigidBody make_rigid_body(Dice& dice) {
  return {dice.number(0.3, 1.0), dice.vector(0.15), dice.inertia(0.015)};
}

Beam make_beam(Dice& dice) {
  Beam beam;
  beam.length = dice.number(0.8, 1.6);
  beam.bodies = 1 + dice.index(2);
  beam.elements = beam.bodies == 1 ? 2 : 1;
  beam.reference_frame = dice.happens(0.5) ? ReferenceFrame::clamped : ReferenceFrame::chord;
  beam.geometric_stiffening = dice.happens(0.8);
  Sections& sections = beam.sections;
  const auto along = [&](double low, double high) {
    return std::vector<double>{dice.number(low, high), dice.number(low, high)};
  };
  sections.station = {0.0, beam.length};
  sections.mass_per_length = along(0.6, 1.0);
  sections.axial_stiffness = along(1e4, 2e4);
  sections.lag_stiffness = along(20.0, 40.0);
  sections.flap_stiffness = along(15.0, 30.0);
  sections.torsion_stiffness = along(12.0, 30.0);
  sections.flap_inertia = sections.lag_inertia = {2e-3, 2e-3};
  sections.twist = along(-0.3, 0.3);
  sections.prebend = {0.0, dice.number(-0.05, 0.05)};
  sections.mass_center = {{dice.number(-0.02, 0.02), 0.01}, {0.0, dice.number(-0.02, 0.02)}};
  return beam;
}

/// Sets the forces on a coordinate, or its motion.
void set_coordinate(bool may_follow_hub, bool slides, Dice& dice, JointCoordinate& coordinate) {
  const double size = slides ? 0.1 : 0.4;
  if (dice.happens(0.25)) {
    const int which = dice.index(may_follow_hub ? 3 : 2);
    if (which == 0) coordinate.motion = MotionTable{Curve(dice.number(-size, size))};
    // A test ends before the second point.
    if (which == 1)
      coordinate.motion = MotionTable{Curve(
          {0.0, 0.5, 1.0}, {0.0, dice.number(0.1, 1.0) * size, dice.number(-1.0, 1.0) * size})};
    if (which == 2) coordinate.motion = AzimuthMotion{0.1 * size, 0.2 * size, -0.1 * size};
    return;
  }
  coordinate.stiffness = slides ? dice.number(40.0, 80.0) : dice.number(3.0, 10.0);
  coordinate.damping = dice.happens(0.5) ? 0.2 : 0.0;
  coordinate.rest = dice.number(-size, size);
  coordinate.initial = dice.number(-size, size);
  coordinate.initial_speed = dice.number(-1.0, 1.0);
  if (dice.happens(0.3)) coordinate.effort = Curve(dice.number(-1.0, 1.0));
}

Joint make_joint(bool may_follow_hub, Dice& dice) {
  Joint joint;
  joint.kind = static_cast<JointKind>(dice.index(6));
  joint.offset = dice.vector(0.3);
  joint.orientation = dice.vector(1.0);
  joint.axes[0] = dice.axis();
  joint.axes[1] = dice.axis();
  while (std::abs(joint.axes[0].dot(joint.axes[1])) > 0.8) joint.axes[1] = dice.axis();
  if (joint.kind == JointKind::spherical) {
    const double stiffness = dice.number(3.0, 10.0), damping = dice.number(0.0, 0.2);
    for (JointCoordinate& coordinate : joint.coordinates)
      coordinate = {.stiffness = stiffness,
                    .damping = damping,
                    .initial = dice.number(-0.4, 0.4),
                    .initial_speed = dice.number(-1.0, 1.0)};
    return joint;
  }
  for (int c = 0; c < count_coordinates(joint.kind); ++c)
    set_coordinate(
        may_follow_hub,
        joint.kind == JointKind::prismatic || (joint.kind == JointKind::cylindrical && c == 1),
        dice, joint.coordinates[static_cast<std::size_t>(c)]);
  return joint;
}

/// Bodies on the hub, two or more of them, and on one another.
Subsystem make_forest(const std::string& name, bool may_follow_hub, Dice& dice) {
  Subsystem forest;
  forest.name = name;
  const int count = 2 + dice.index(4);
  for (int k = 0; k < count; ++k) {
    const std::string body = "body" + std::to_string(k + 1);
    if (dice.happens(0.5))
      forest.bodies.push_back({body, make_beam(dice)});
    else
      forest.bodies.push_back({body, make_rigid_body(dice)});
    SubsystemJoint joint;
    joint.child = body;
    joint.joint = make_joint(may_follow_hub, dice);
    if (k >= 2 && dice.happens(0.6)) {
      const Body& parent = forest.bodies[static_cast<std::size_t>(dice.index(k))];
      joint.parent = parent.name;
      const auto* beam = std::get_if<Beam>(&parent.shape);
      // No element becomes shorter than a quarter.
      if (beam && dice.happens(0.5)) joint.station = 0.25 * (1 + dice.index(3)) * beam->length;
    }
    forest.joints.push_back(std::move(joint));
  }
  return forest;
}

/// One rigid body that the hub carries along, or moves as it is told.
Subsystem make_rigid_part(Dice& dice) {
  Subsystem part{"part", {{"body1", make_rigid_body(dice)}}, {}};
  SubsystemJoint joint;
  joint.child = "body1";
  joint.joint.offset = dice.vector(0.5);
  if (dice.happens(0.5)) {
    joint.joint.kind = JointKind::revolute;
    joint.joint.axes[0] = dice.axis();
    joint.joint.coordinates[0].motion = MotionTable{Curve(dice.number(-1.0, 1.0))};
  }
  part.joints.push_back(std::move(joint));
  return part;
}

void set_hub(RandomHub kind, Dice& dice, Hub& hub) {
  hub.mass = dice.number(2.0, 4.0);
  hub.center = dice.vector(0.1);
  hub.inertia = dice.inertia(0.3);
  switch (kind) {
    case RandomHub::fixed:
      hub.drive = FixedDrive{};
      break;
    case RandomHub::driven:
      hub.axis = dice.axis();
      hub.drive = SpinUp{4.0, 0.5};
      break;
    case RandomHub::torque:
      hub.drive = TorqueDrive{Curve(kRandomTorque), dice.number(-2.0, 2.0)};
      break;
    case RandomHub::free:
      hub.support = HubSupport::free;
      hub.velocity = dice.vector(1.0);
      hub.angular_velocity = dice.vector(2.0);
  }
}

/// A frame that a load on such a body may have.
LoadFrame draw_frame(bool is_on_beam, Dice& dice) {
  return static_cast<LoadFrame>(dice.index(is_on_beam ? 4 : 3));
}

void add_loads(Dice& dice, Model& model) {
  for (const Subsystem& subsystem : model.subsystems)
    for (const Body& body : subsystem.bodies) {
      const auto* beam = std::get_if<Beam>(&body.shape);
      const LoadPlace place{.subsystem = subsystem.name, .body = body.name};
      if (dice.happens(0.5)) {
        PointLoad load{.place = place, .frame = draw_frame(beam != nullptr, dice)};
        if (beam)
          load.position = dice.number(0.0, beam->length);
        else
          load.point = dice.vector(0.2);
        load.force = dice.vector(2.0);
        load.moment = dice.vector(0.2);
        model.loads.push_back(load);
      }
      if (beam && dice.happens(0.3))
        model.distributed_loads.push_back({.place = place,
                                           .from = 0.2 * beam->length,
                                           .frame = draw_frame(true, dice),
                                           .force_per_length = dice.vector(2.0),
                                           .moment_per_length = dice.vector(0.2)});
    }
  if (dice.happens(0.5))
    model.hub_loads.push_back({.position = dice.vector(0.2),
                               .frame = dice.happens(0.5) ? LoadFrame::hub : LoadFrame::inertial,
                               .force = dice.vector(2.0),
                               .torque = dice.vector(0.5)});
}

Support make_base(bool flies, Dice& dice) {
  Support support;
  if (!flies) return support;
  support.from = SupportBase::free;
  support.fuselage.mass = dice.number(4.0, 8.0);
  support.fuselage.center = dice.vector(0.1);
  support.fuselage.inertia = dice.inertia(0.5);
  support.fuselage.angular_velocity = dice.vector(1.0);
  return support;
}

Hub make_hub(int rotor, Dice& dice) {
  Hub hub;
  hub.name = "r" + std::to_string(rotor);
  hub.axis = dice.axis();
  hub.mass = dice.number(0.2, 0.6);
  hub.center = dice.vector(0.05);
  hub.inertia = dice.inertia(0.02);
  const double speed = dice.number(-3.0, 3.0);
  const std::array<Drive, 4> drives{FixedDrive{}, SpinUp{speed, 0.5}, FreeDrive{speed},
                                    TorqueDrive{Curve(0.1 * speed), speed}};
  hub.drive = drives[static_cast<std::size_t>(dice.index(4))];
  return hub;
}

/// Returns an axle on any body of a subsystem.
Axle make_axle(const Subsystem& carrier, Dice& dice) {
  const Body& body =
      carrier.bodies[static_cast<std::size_t>(dice.index(static_cast<int>(carrier.bodies.size())))];
  Axle axle;
  axle.subsystem = carrier.name;
  axle.body = body.name;
  axle.offset = dice.vector(0.2);
  axle.orientation = dice.vector(1.0);
  return axle;
}

/// A spring between any bodies of two subsystems.
Loop make_spring(const Subsystem& own, const Subsystem& other, const std::string& name,
                 Dice& dice) {
  const auto place_on = [&dice](const Subsystem& subsystem) {
    LoopPlace place;
    const auto count = static_cast<int>(subsystem.bodies.size());
    const Body& body = subsystem.bodies[static_cast<std::size_t>(dice.index(count))];
    place.name = body.name;
    if (std::holds_alternative<RigidBody>(body.shape)) place.point = dice.vector(0.2);
    return place;
  };
  Loop spring;
  spring.name = name;
  spring.from = place_on(own);
  spring.to = place_on(other);
  spring.to.carrier = LoopPlace::Carrier::elsewhere;
  spring.to.subsystem = other.name;
  spring.to.orientation = Vector::Zero();
  spring.stiffness.assign(3, dice.number(2.0, 6.0));
  spring.damping.assign(3, dice.number(0.0, 0.2));
  return spring;
}

}  // namespace

Model make_random_levels(bool flies, std::mt19937& random) {
  Dice dice(random);
  Model model;
  model.support = make_base(flies, dice);
  Subsystem tree;
  tree.name = kSupportName;
  tree.bodies.push_back({"stage", make_rigid_body(dice)});
  SubsystemJoint& joint = tree.joints.emplace_back();
  joint.child = "stage";
  joint.parent = base_name(model.support->from);
  joint.joint = make_joint(false, dice);
  model.hub = make_hub(0, dice);
  model.support->axle = make_axle(tree, dice);
  model.support->axle.subsystem.clear();
  const int count = 3 + dice.index(2);
  for (int r = 0; r < count; ++r) {
    if (r > 0) {
      const int carrier = dice.index(r + 1);
      Axle axle = carrier == r
                      ? make_axle(tree, dice)
                      : make_axle(model.subsystems[static_cast<std::size_t>(carrier)], dice);
      if (carrier == r) axle.subsystem.clear();
      model.rotors.push_back({make_hub(r, dice), axle});
    }
    Subsystem forest = make_forest("s" + std::to_string(r), false, dice);
    forest.rotor = r;
    model.subsystems.push_back(std::move(forest));
  }
  for (int k = 0; k < 2; ++k) {
    Subsystem& own = model.subsystems[static_cast<std::size_t>(k)];
    const Subsystem& other = k == 0 ? tree : model.subsystems[static_cast<std::size_t>(count) - 1];
    own.loops.push_back(make_spring(own, other, "spring", dice));
  }
  model.subsystems.push_back(std::move(tree));
  model.gravity = 9.81 * dice.axis();
  model.damping.stiffness_factor = dice.number(0.0, 1e-4);
  add_loads(dice, model);
  return model;
}

Model make_random_model(RandomHub hub, std::mt19937& random) {
  Dice dice(random);
  Model model;
  set_hub(hub, dice, model.hub);
  const bool may_follow_hub = hub == RandomHub::driven;
  model.subsystems.push_back(make_forest("forest", may_follow_hub, dice));
  if (dice.happens(0.6)) model.subsystems.push_back(make_rigid_part(dice));
  if (dice.happens(0.3)) model.subsystems.push_back(make_forest("other", may_follow_hub, dice));
  model.gravity = 9.81 * dice.axis();
  model.gravity_ramp = dice.happens(0.3) ? 0.5 : 0.0;
  model.damping.stiffness_factor = dice.number(0.0, 1e-4);
  add_loads(dice, model);
  return model;
}

Model without_loads(Model model) {
  model.gravity.setZero();
  model.gravity_ramp = 0.0;
  model.loads.clear();
  model.distributed_loads.clear();
  model.hub_loads.clear();
  return model;
}

}  // namespace spoke::spatial::testing
