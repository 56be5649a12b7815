// Each kind of joint as a sequence of simple freedoms.

#include "models/tree/space_joint.h"

#include <vector>

namespace spoke::spatial {
namespace {

space::JointPrimitive make_primitive(space::JointPrimitive::Kind kind, const Vector& axis,
                                     const JointCoordinate& coordinate) {
  space::JointPrimitive primitive;
  primitive.kind = kind;
  if (kind != space::JointPrimitive::Kind::spherical) primitive.axis = axis.normalized();
  primitive.is_driven = coordinate.motion.has_value();
  primitive.stiffness = coordinate.stiffness;
  primitive.damping = coordinate.damping;
  primitive.rest = coordinate.rest;
  if (coordinate.stop) {
    const Stop& stop = *coordinate.stop;
    primitive.stop = {stop.lower, stop.upper, stop.stiffness, stop.damping, stop.width};
  }
  if (coordinate.friction) {
    const Friction& friction = *coordinate.friction;
    primitive.friction = {friction.force, friction.static_force.value_or(friction.force),
                          friction.speed, friction.stribeck.value_or(friction.speed)};
  }
  return primitive;
}

}  // namespace

space::Joint make_space_joint(const Joint& joint, const Placement& placement) {
  using Kind = space::JointPrimitive::Kind;
  std::vector<space::JointPrimitive> primitives;
  const auto add = [&](Kind kind, std::size_t axis, std::size_t coordinate) {
    primitives.push_back(make_primitive(kind, joint.axes[axis], joint.coordinates[coordinate]));
  };
  switch (joint.kind) {
    case JointKind::fixed:
      break;
    case JointKind::revolute:
      add(Kind::revolute, 0, 0);
      break;
    case JointKind::universal:
      add(Kind::revolute, 0, 0);
      add(Kind::revolute, 1, 1);
      break;
    case JointKind::spherical:
      add(Kind::spherical, 0, 0);
      break;
    case JointKind::prismatic:
      add(Kind::prismatic, 0, 0);
      break;
    case JointKind::cylindrical:
      add(Kind::revolute, 0, 0);
      add(Kind::prismatic, 0, 1);
      break;
    case JointKind::bushing:
      for (std::size_t c = 0; c < 6; ++c)
        primitives.push_back(make_primitive(c < 3 ? Kind::prismatic : Kind::revolute,
                                            Vector::Unit(static_cast<Eigen::Index>(c % 3)),
                                            joint.coordinates[c]));
      break;
  }
  return space::make_joint({placement.position, {placement.rotation}}, primitives);
}

space::DrivenMotion make_driven_motion(const Motion& motion) {
  if (const auto* table = std::get_if<MotionTable>(&motion)) return *table;
  if (const auto* azimuth = std::get_if<AzimuthMotion>(&motion)) return *azimuth;
  return space::SaidMotion{0.0, std::get<ProgramMotion>(motion).initial, 0.0, 0.0};
}

}  // namespace spoke::spatial
