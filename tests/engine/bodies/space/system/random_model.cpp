#include "tests/engine/bodies/space/system/random_model.h"

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

}  // namespace

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
