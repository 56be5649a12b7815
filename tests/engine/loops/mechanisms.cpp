#include "tests/engine/loops/mechanisms.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace spoke::test {
namespace {

using spatial::JointKind;
using spatial::RigidBody;
using spatial::Subsystem;
using spatial::SubsystemJoint;
using spatial::Vector;

/// A body in the plane z = 0.
spatial::Body make_plate(const std::string& name, double mass, const Vector& center,
                         double inertia) {
  RigidBody body;
  body.mass = mass;
  body.center = center;
  body.inertia = Vector::Constant(inertia).asDiagonal();
  return {name, body};
}

Loop make_loop(const std::string& name, LoopKind kind, const LoopPlace& from, const LoopPlace& to,
               const Vector& axis = Vector::UnitZ()) {
  Loop loop;
  loop.name = name;
  loop.kind = kind;
  loop.from = from;
  loop.to = to;
  loop.axes[0] = axis;
  return loop;
}

/// Widens a joint, so that a loop of its own kind leaves what it left before.
bool widen(SubsystemJoint& joint, std::mt19937& random) {
  const JointKind kind = joint.joint.kind;
  const auto draw = [&random](int count) {
    return std::uniform_int_distribution<int>(0, count - 1)(random);
  };
  Vector across = joint.joint.axes[0].cross(Vector(0.3, -0.5, 0.8)).normalized();
  switch (kind) {
    case JointKind::fixed: {
      const JointKind wider[] = {JointKind::revolute, JointKind::universal, JointKind::spherical,
                                 JointKind::prismatic, JointKind::cylindrical};
      joint.joint.kind = wider[draw(5)];
      joint.joint.axes = {Vector(0.2, 0.9, -0.4), Vector(1.0, 0.1, 0.3)};
      joint.joint.coordinates.assign(3, {});
      return true;
    }
    case JointKind::revolute:
      joint.joint.kind = draw(2) == 0 ? JointKind::universal : JointKind::cylindrical;
      joint.joint.axes[1] = across;
      joint.joint.coordinates[1] = {};
      return true;
    case JointKind::prismatic:
      joint.joint.kind = JointKind::cylindrical;
      joint.joint.coordinates[1] = joint.joint.coordinates[0];
      joint.joint.coordinates[0] = {};
      return true;
    default:
      return false;
  }
}

LoopKind loop_kind_of(JointKind kind) {
  if (kind == JointKind::fixed) return LoopKind::fixed;
  return kind == JointKind::revolute ? LoopKind::revolute : LoopKind::prismatic;
}

/// The place of a joint on its parent.
LoopPlace place_of(const SubsystemJoint& joint) {
  LoopPlace place;
  place.point = joint.joint.offset;
  place.orientation = joint.joint.orientation;
  if (joint.parent == "hub") {
    place.carrier = LoopPlace::Carrier::hub;
    return place;
  }
  place.name = joint.parent;
  place.station = joint.station;
  return place;
}

}  // namespace

spatial::Body make_rod(const std::string& name, double mass, double length) {
  RigidBody rod;
  rod.mass = mass;
  rod.center = Vector(0.5 * length, 0.0, 0.0);
  const double across = mass * length * length / 12.0;
  rod.inertia = Vector(1e-3 * across, across, across).asDiagonal();
  return {name, rod};
}

SubsystemJoint make_hinge(const std::string& parent, const std::string& child, const Vector& offset,
                          double angle, double speed, const Vector& axis) {
  SubsystemJoint hinge;
  hinge.parent = parent;
  hinge.child = child;
  hinge.joint.kind = JointKind::revolute;
  hinge.joint.offset = offset;
  hinge.joint.axes[0] = axis;
  hinge.joint.coordinates[0].initial = angle;
  hinge.joint.coordinates[0].initial_speed = speed;
  return hinge;
}

LoopPlace on_body(const std::string& body, const Vector& point) {
  LoopPlace place;
  place.name = body;
  place.point = point;
  return place;
}

spatial::Model make_four_bars(int count, LoopKind kind) {
  constexpr double kUpright = 0.5 * std::numbers::pi;
  spatial::Model model;
  model.hub.drive = FixedDrive{};
  model.gravity = Vector(0.0, -9.81, 0.0);
  Subsystem bars{"bars", {}, {}, {}};
  const auto name = [](const char* what, int k) { return what + std::to_string(k); };
  for (int k = 0; k <= count; ++k) {
    bars.bodies.push_back(make_rod(name("bar", k), 1.0, 1.0));
    bars.joints.push_back(make_hinge("hub", name("bar", k), Vector(k, 0.0, 0.0), kUpright, -1.0));
  }
  for (int k = 0; k < count; ++k) {
    const std::string coupler = name("coupler", k), next = name("bar", k + 1);
    bars.bodies.push_back(make_rod(coupler, 1.0, 1.0));
    bars.joints.push_back(make_hinge(name("bar", k), coupler, Vector::UnitX(), -kUpright, 1.0));
    bars.loops.push_back(make_loop(name("loop", k), kind, on_body(coupler, Vector::UnitX()),
                                   on_body(next, Vector::UnitX())));
  }
  model.subsystems.push_back(bars);
  return model;
}

// Schiehlen 1990; Hairer & Wanner 1996, section VII.7: lengths, masses and moments of inertia.
spatial::Model make_andrews_squeezer() {
  const double d = 28e-3, da = 115e-4, e = 2e-2, ea = 1421e-5, rr = 7e-3, ra = 92e-5, ss = 35e-3,
               sa = 1874e-5, sb = 1043e-5, sc = 18e-3, sd = 2e-2, ta = 2308e-5, tb = 916e-5,
               u = 4e-2, ua = 1228e-5, ub = 449e-5, zf = 2e-2, zt = 4e-2, fa = 1421e-5;
  const Vector A(-0.06934, -0.00227, 0.0), B(-0.03635, 0.03273, 0.0), C(0.014, 0.072, 0.0);
  spatial::Model model;
  model.hub.drive = FixedDrive{};
  Subsystem s{"squeezer", {}, {}, {}};
  s.bodies = {make_plate("K1", 0.04325, {ra, 0, 0}, 2.194e-6),
              make_plate("K2", 0.00365, {-da, 0, 0}, 4.410e-7),
              make_plate("K3", 0.02373, {sb, -sa, 0}, 5.255e-6),
              make_plate("K5", 0.07050, {ta, tb, 0}, 1.169e-5),
              make_plate("K4", 0.00706, {0, ea - e, 0}, 5.667e-7),
              make_plate("K7", 0.05498, {-ub, -ua, 0}, 1.912e-5),
              make_plate("K6", 0.00706, {zf - fa, 0, 0}, 5.667e-7)};
  const double phi = 0.222668390165886;
  s.joints = {make_hinge("hub", "K1", Vector::Zero(), -0.0617138900142764),
              make_hinge("K1", "K2", {rr, 0, 0}, 0.0),
              make_hinge("hub", "K3", B, 0.45527981916307),
              make_hinge("hub", "K5", A, 0.487364979543843),
              make_hinge("K5", "K4", {zt, 0, 0}, phi),
              make_hinge("hub", "K7", A, 1.2305474445498),
              make_hinge("K7", "K6", {0, -u, 0}, -phi)};
  s.joints[0].joint.coordinates[0].effort = Curve(0.033);
  const LoopPlace end = on_body("K2", {-d, 0, 0});
  LoopPlace anchor;
  anchor.carrier = LoopPlace::Carrier::hub;
  anchor.point = C;
  s.loops = {make_loop("K2-K3", LoopKind::spherical, end, on_body("K3", {0, -ss, 0})),
             make_loop("K2-K4", LoopKind::spherical, end, on_body("K4", {0, -e, 0})),
             make_loop("K2-K6", LoopKind::spherical, end, on_body("K6", {zf, 0, 0})),
             make_loop("spring", LoopKind::distance, on_body("K3", {sd, -sc, 0}), anchor)};
  s.loops.back().length = 0.07785;
  s.loops.back().stiffness = {4530.0};
  model.subsystems.push_back(s);
  return model;
}

// Each hinge axis is across both bars that it joins; the bars go along the edges of a cube.
spatial::Model make_bricard() {
  spatial::Model model;
  model.hub.drive = FixedDrive{};
  model.gravity = Vector(0.0, -9.81, 0.0);
  const Vector places[] = {{0, 0, 0}, {1, 0, 0}, {1, -1, 0}, {1, -1, 1}, {0, -1, 1}, {0, 0, 1}};
  const Vector axes[] = {Vector::UnitY(), Vector::UnitZ(), Vector::UnitX(),
                         Vector::UnitY(), Vector::UnitZ(), Vector::UnitX()};
  Subsystem s{"bricard", {}, {}, {}};
  std::string parent = "hub";
  for (int k = 0; k < 5; ++k) {
    const std::string name = "bar" + std::to_string(k + 1);
    const Vector along = places[k + 1] - places[k];
    RigidBody bar;
    bar.mass = 1.0;
    bar.center = 0.5 * along;
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - along * along.transpose();
    bar.inertia = across / 12.0 + 1e-4 * Eigen::Matrix3d::Identity();
    s.bodies.push_back({name, bar});
    const Vector offset = k == 0 ? places[0] : Vector(places[k] - places[k - 1]);
    s.joints.push_back(make_hinge(parent, name, offset, 0.0, 0.0, axes[k]));
    parent = name;
  }
  LoopPlace ground;
  ground.carrier = LoopPlace::Carrier::hub;
  ground.point = places[5];
  s.loops.push_back(make_loop("closure", LoopKind::revolute, on_body(parent, places[5] - places[4]),
                              ground, axes[5]));
  model.subsystems.push_back(s);
  return model;
}

spatial::Model cut(spatial::Model tree, std::mt19937& random) {
  for (Subsystem& subsystem : tree.subsystems)
    for (SubsystemJoint& joint : subsystem.joints) {
      const LoopKind kind = loop_kind_of(joint.joint.kind);
      const Vector axis = joint.joint.axes[0];
      const LoopPlace to = place_of(joint);
      if (!widen(joint, random)) continue;
      LoopPlace from = on_body(joint.child, Vector::Zero());
      const auto child =
          std::find_if(subsystem.bodies.begin(), subsystem.bodies.end(),
                       [&joint](const spatial::Body& body) { return body.name == joint.child; });
      if (std::holds_alternative<spatial::Beam>(child->shape)) from.station = 0.0;
      subsystem.loops.push_back(
          make_loop("loop" + std::to_string(subsystem.loops.size() + 1), kind, from, to, axis));
    }
  return tree;
}

}  // namespace spoke::test
