// Coordinates, matrices and nodes of bodies, by world.

#include "engine/small_motions/steady/subsystem_access.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "engine/bodies/kernels/dense_body.h"
#include "engine/bodies/kernels/plane/handle_motion.h"
#include "engine/bodies/kernels/space/put_joint.h"
#include "engine/bodies/plane/nonlinear_strain.h"
#include "engine/bodies/table/body_kind.h"
#include "engine/step/integrator/rotation.h"

namespace spoke::steady {
namespace {

space::RotationBlock rotation_block(BodyData<Space>& body) {
  const space::Joint& joint = body.model->joint.joint;
  return {&body.joint.coordinates, joint.spherical_at, body.joint.rotation, joint.spherical_frame};
}

bool is_spherical(const BodyData<Space>& body) { return body.model->joint.joint.spherical_at >= 0; }

std::string name_node(const std::string& body, int node, const char* component) {
  return body + " / node " + std::to_string(node) + " / " + component;
}

}  // namespace

int count_joint_coordinates(const TreeBody<Plane>&) { return 0; }
int count_joint_coordinates(const TreeBody<Space>& body) { return body.joint.joint.coordinates; }

void put_joint(const double*, const double*, BodyData<Plane>&) {}
void put_joint(const double* q, const double* v, BodyData<Space>& body) {
  std::copy_n(q, body.joint.coordinates.size, body.joint.coordinates.q);
  std::copy_n(v, body.joint.coordinates.size, body.joint.coordinates.v);
}

void take_joint_position(const BodyData<Plane>&, double*) {}
void take_joint_position(const BodyData<Space>& body, double* q) {
  std::copy_n(body.joint.coordinates.q, body.joint.coordinates.size, q);
}

void take_joint(const BodyData<Plane>&, double*) {}
void take_joint(const BodyData<Space>& body, double* a) {
  std::copy_n(body.joint.a_found, body.joint.coordinates.size, a);
}

void fold_joint(double*, BodyData<Plane>&) {}
void fold_joint(double* q, BodyData<Space>& body) {
  if (!is_spherical(body)) return;
  std::copy_n(q, body.joint.coordinates.size, body.joint.coordinates.q);
  fold(rotation_block(body));
  std::copy_n(body.joint.coordinates.q, body.joint.coordinates.size, q);
}

void put_absolute(const double*, BodyData<Plane>&) {}
void put_absolute(const double* q, BodyData<Space>& body) {
  put_joint(body.model->joint.joint, q, body.joint);
}

void make_absolute(const BodyData<Plane>&, double*) {}
void make_absolute(const BodyData<Space>& body, double* q) {
  if (!is_spherical(body)) return;
  const space::Joint& joint = body.model->joint.joint;
  double* at = q + joint.spherical_at;
  const space::Angular D(at[0], at[1], at[2]);
  const space::Angular theta =
      logarithm(turn(body.joint.rotation->reference, D, joint.spherical_frame));
  std::copy_n(theta.data(), space::kAngular, at);
}

void put_initial(const double*, TreeBody<Plane>&) {}
void put_initial(const double* q, TreeBody<Space>& body) {
  std::copy_n(q, count_joint_coordinates(body), body.joint.course.initial.begin());
}

void take_initial(const TreeBody<Plane>&, double*) {}
void take_initial(const TreeBody<Space>& body, double* q) {
  const space::JointCourse& course = body.joint.course;
  std::copy(course.initial.begin(), course.initial.end(), q);
  const int spherical = body.joint.joint.spherical_at;
  if (spherical >= 0) std::fill_n(q + spherical, space::kAngular, 0.0);
}

std::vector<SubsystemCoordinate> name_coordinates(const TreeBody<Plane>& model, int index,
                                                  const std::string& body, const std::string&) {
  static constexpr const char* kNames[] = {"u", "v", "psi"};
  const plane::FlexibleBody& flexible = *model.body;
  std::vector<SubsystemCoordinate> list(static_cast<std::size_t>(flexible.coordinates()));
  for (int node = 0; node <= flexible.elements; ++node)
    for (int c = 0; c < kTwist; ++c) {
      const int at = flexible.coordinate(node, c);
      if (at < 0) continue;
      list[static_cast<std::size_t>(at)] = {
          name_node(body, node, kNames[c]),      {}, index, node, c == kRotation,
          c == kRotation ? 1.0 : flexible.length};
    }
  return list;
}

std::vector<SubsystemCoordinate> name_coordinates(const TreeBody<Space>& model, int index,
                                                  const std::string& body,
                                                  const std::string& name) {
  std::vector<SubsystemCoordinate> list;
  const space::Joint& joint = model.joint.joint;
  const BodyView<Space>& view = kind_of(*model.body);
  const double length = view.length(*model.body), extent = length > 0.0 ? length : 1.0;
  int number = 0;
  for (const space::JointPrimitive& primitive : joint.sequence()) {
    if (primitive.is_driven) continue;
    const bool turns = primitive.kind != space::JointPrimitive::Kind::prismatic;
    const bool is_spherical = primitive.kind == space::JointPrimitive::Kind::spherical;
    const int sense = !is_spherical ? 0 : primitive.frame == space::TurnFrame::parent ? 1 : -1;
    for (int c = 0; c < primitive.components(); ++c) {
      std::string numbered = name;
      if (joint.coordinates > 1) numbered.append(" ").append(std::to_string(++number));
      list.push_back({numbered, name, index, -1, turns, turns ? 1.0 : extent, sense});
    }
  }
  for (CoordinateName& own : view.name_coordinates(*model.body))
    list.push_back(
        {body + (body.empty() ? "" : " / ") + own.name, {}, index, own.node, own.turns, own.scale});
  return list;
}

Eigen::MatrixXd calc_body_mass(const BodyData<Plane>& body) {
  const plane::FlexibleBody& flexible = *body.model->body;
  Eigen::MatrixXd mass(dense_size(flexible), dense_size(flexible));
  calc_dense_mass(body, make_dense_elastic_block(flexible, 1.0, 0.0), false, mass);
  return mass;
}
Eigen::MatrixXd calc_body_mass(const BodyData<Space>& body) {
  return body.kind->calc_own_mass(body);
}

Eigen::MatrixXd calc_body_stiffness(const BodyData<Plane>& body) {
  if (has_nonlinear_strain(body))
    return calc_strain_stiffness(*body.model->body, body.layout, body.q_elastic);
  return make_dense_elastic_block(*body.model->body, 0.0, 1.0);
}
Eigen::MatrixXd calc_body_stiffness(const BodyData<Space>& body) {
  return body.kind->calc_stiffness(body);
}

Eigen::MatrixXd calc_body_damping(const Damping& damping, const BodyData<Plane>& body) {
  Eigen::MatrixXd own = make_dense_elastic_block(*body.model->body, damping.mass_factor,
                                                 damping.stiffness_factor, 1.0);
  if (has_nonlinear_strain(body))
    own += calc_strain_damping(*body.model->body, body.layout, damping.stiffness_factor,
                               body.q_elastic);
  return own;
}
Eigen::MatrixXd calc_body_damping(const Damping& damping, const BodyData<Space>& body) {
  return body.kind->calc_damping(damping, body);
}

void add_places(const SubsystemData<Plane>& data, int j, std::vector<NodePlace>& places) {
  assert(j >= 0 && std::cmp_less(j, data.poses.size()));
  const BodyData<Plane>& body = data.bodies[j];
  const plane::FlexibleBody& flexible = *body.model->body;
  const plane::Pose& pose = data.poses[j];
  const double mass = flexible.mass / flexible.elements;
  for (int node = 0; node <= flexible.elements; ++node) {
    const auto value = [&](int c) {
      const int at = flexible.coordinate(node, c);
      return at < 0 ? 0.0 : body.coordinates.q[body.layout.offset(at)];
    };
    const double x = flexible.length * node / flexible.elements;
    const Position p = pose.p + pose.R * Position(x + value(0), value(1));
    const bool is_end = node == 0 || node == flexible.elements;
    places.push_back({{p.x(), p.y(), 0.0},
                      axes_of(pose.R * plane::Rotation::from_angle(value(kRotation))),
                      {p.x(), p.y(), 0.0},
                      is_end ? 0.5 * mass : mass,
                      0.0,
                      j});
  }
}

void add_places(const SubsystemData<Space>& data, int j, std::vector<NodePlace>& places) {
  assert(j >= 0 && std::cmp_less(j, data.poses.size()));
  const BodyData<Space>& body = data.bodies[j];
  for (const LumpedNode& node : body.kind->lump(body, data.poses[j]))
    places.push_back({node.p, node.axes, node.centre, node.mass, node.inertia, j});
}

Eigen::Matrix3d outer_axes(const SubsystemData<Plane>& data, std::size_t body) {
  std::vector<NodePlace> places;
  add_places(data, static_cast<int>(body), places);
  return places.back().axes;
}
Eigen::Matrix3d outer_axes(const SubsystemData<Space>& data, std::size_t body) {
  return data.bodies[body].kind->outer_axes(data.bodies[body], data.poses[body]);
}

std::shared_ptr<const space::SolidConstants> mesh_of(const BodyData<Plane>& /*body*/) {
  return nullptr;
}
std::shared_ptr<const space::SolidConstants> mesh_of(const BodyData<Space>& body) {
  return body.kind->mesh(*body.model->body);
}

Eigen::Vector3d force_of(const Twist& wrench) { return {wrench[0], wrench[1], 0.0}; }
Eigen::Vector3d force_of(const space::Twist& wrench) { return wrench.head<3>(); }
Eigen::Vector3d moment_of(const Twist& wrench) { return {0.0, 0.0, wrench[2]}; }
Eigen::Vector3d moment_of(const space::Twist& wrench) { return wrench.tail<3>(); }

Eigen::Matrix3d inboard_axes(const BodyData<Plane>& body) {
  const int at = body.model->body->coordinate(0, kRotation);
  return axes_of(
      plane::Rotation::from_angle(at < 0 ? 0.0 : body.coordinates.q[body.layout.offset(at)]));
}
Eigen::Matrix3d inboard_axes(const BodyData<Space>& body) { return body.kind->inboard_axes(body); }

Eigen::Matrix3d axes_of(const plane::Rotation& R) {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  axes.topLeftCorner<2, 2>() << R.cosine, -R.sine, R.sine, R.cosine;
  return axes;
}
Eigen::Matrix3d axes_of(const space::Rotation& R) { return R.axes; }

plane::Rotation turn_of(const HubVector& turn, const Plane&) {
  return plane::Rotation::from_angle(turn[2]);
}
space::Rotation turn_of(const HubVector& turn, const Space&) {
  return space::exponential(space::Angular(turn[3], turn[4], turn[5]));
}

}  // namespace spoke::steady
