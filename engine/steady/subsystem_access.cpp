// Coordinates, matrices and nodes of bodies, by world.

#include "engine/steady/subsystem_access.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>

#include "engine/integrator/rotation.h"
#include "engine/kernels/dense_body.h"
#include "engine/plane/handle_motion.h"
#include "engine/plane/nonlinear_strain.h"
#include "engine/space/dense_body.h"
#include "engine/space/nonlinear_strain.h"
#include "engine/space/put_joint.h"
#include "engine/space/solid_places.h"
#include "engine/space/table_terms.h"

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
  static constexpr const char* kNames[] = {"u", "v", "w", "tx", "ty", "tz"};
  std::vector<SubsystemCoordinate> list;
  const space::Joint& joint = model.joint.joint;
  const space::FlexibleBody* flexible = model.body->flexible();
  const double extent = model.body->rigid() ? 1.0 : model.body->extent();
  int number = 0;
  for (const space::JointPrimitive& primitive : joint.sequence()) {
    if (primitive.is_driven) continue;
    const bool turns = primitive.kind != space::JointPrimitive::Kind::prismatic;
    const bool is_spherical = primitive.kind == space::JointPrimitive::Kind::spherical;
    for (int c = 0; c < primitive.components(); ++c) {
      std::string numbered = name;
      if (joint.coordinates > 1) numbered.append(" ").append(std::to_string(++number));
      list.push_back({numbered, name, index, -1, turns, turns ? 1.0 : extent, is_spherical});
    }
  }
  if (const space::Solid* solid = model.body->solid()) {
    const space::SolidConstants& constants = *solid->constants;
    for (int k = 0; k < solid->coordinates(); ++k)
      list.push_back({body + (body.empty() ? "" : " / ") + name_coordinate(constants, k),
                      {},
                      index,
                      0,
                      false,
                      constants.limits[static_cast<std::size_t>(k)]});
    return list;
  }
  if (!flexible) return list;
  const std::size_t first = list.size();
  list.resize(first + static_cast<std::size_t>(flexible->coordinates()));
  for (int node = 0; node < flexible->node_count(); ++node)
    for (int c = 0; c < space::kTwist; ++c) {
      const int at = flexible->coordinate(node, c);
      if (at < 0) continue;
      const bool turns = c >= space::kRotation;
      list[first + static_cast<std::size_t>(at)] = {
          name_node(body, node, kNames[c]), {}, index, node, turns, turns ? 1.0 : extent};
    }
  return list;
}

Eigen::MatrixXd calc_body_mass(const BodyData<Plane>& body) {
  const plane::FlexibleBody& flexible = *body.model->body;
  Eigen::MatrixXd mass(dense_size(flexible), dense_size(flexible));
  calc_dense_mass(body, make_dense_elastic_block(flexible, 1.0, 0.0), false, mass);
  return mass;
}
Eigen::MatrixXd calc_body_mass(const BodyData<Space>& body) {
  const space::Body& model = *body.model->body;
  if (model.rigid()) return rigid_mass_of(body).matrix();
  Eigen::MatrixXd mass(dense_size(model), dense_size(model));
  calc_dense_mass(body, make_dense_elastic_block(model, {1.0, 0.0, 0.0}), false, mass);
  return mass;
}

Eigen::MatrixXd calc_body_stiffness(const BodyData<Plane>& body) {
  if (has_nonlinear_strain(body))
    return calc_strain_stiffness(*body.model->body, body.layout, body.q_elastic);
  return make_dense_elastic_block(*body.model->body, 0.0, 1.0);
}
namespace {

/// Returns stiffness and damping of a body by its strains of second order; none of others.
std::optional<space::StrainMatrices> calc_strain_matrices(double stiffness_factor,
                                                          const BodyData<Space>& body) {
  if (!has_nonlinear_strain(body)) return std::nullopt;
  const space::FlexibleBody* flexible = body.model->body->flexible();
  Eigen::VectorXd q(space::kTwist * flexible->node_count());
  space::expand(*flexible, body.q_elastic, q.data());
  return space::calc_strain_matrices(*flexible, stiffness_factor, q.data());
}

}  // namespace

Eigen::MatrixXd calc_body_stiffness(const BodyData<Space>& body) {
  if (const auto strain = calc_strain_matrices(0.0, body)) return strain->stiffness;
  return make_dense_elastic_block(*body.model->body, {0.0, 1.0, 0.0});
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
  if (const auto strain = calc_strain_matrices(damping.stiffness_factor, body))
    return make_dense_elastic_block(*body.model->body, {damping.mass_factor, 0.0, 0.0}) +
           strain->damping;
  return make_dense_elastic_block(*body.model->body,
                                  {damping.mass_factor, damping.stiffness_factor, 1.0});
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

namespace {

/// Adds the frame of a solid and its places, which have no mass, then some nodes, at most kMost
/// evenly from its list, each with an equal share of its mass.
void add_solid_places(const space::Solid& solid, const space::Pose& pose, const double* q, int j,
                      std::vector<NodePlace>& places) {
  constexpr std::size_t kMost = 200;
  const space::SolidConstants& constants = *solid.constants;
  const std::size_t count = constants.nodes.size(), stride = (count + kMost - 1) / kMost;
  const double share = constants.mass / static_cast<double>((count + stride - 1) / stride);
  places.push_back({pose.p, pose.R.axes, pose.p, 0.0, 0.0, j});
  for (const space::SolidPlace& place : constants.places) {
    const space::HandleMotion motion = calc_place_motion(place, q, q);
    const space::Position p = pose.p + pose.R * motion.s;
    places.push_back({p, (pose.R * motion.turn.R).axes, p, 0.0, 0.0, j});
  }
  const Eigen::VectorXd u = calc_displacements(constants, q);
  for (std::size_t i = 0; i < count; i += stride) {
    const space::Position moved = u.segment<3>(static_cast<Eigen::Index>(3 * i));
    const space::Position p = pose.p + pose.R * space::Position(constants.nodes[i] + moved);
    places.push_back({p, pose.R.axes, p, share, 0.0, j});
  }
}

}  // namespace

void add_places(const SubsystemData<Space>& data, int j, std::vector<NodePlace>& places) {
  assert(j >= 0 && std::cmp_less(j, data.poses.size()));
  const BodyData<Space>& body = data.bodies[j];
  const space::Pose& pose = data.poses[j];
  const space::FlexibleBody* flexible = body.model->body->flexible();
  if (const space::Solid* solid = body.model->body->solid())
    return add_solid_places(*solid, pose, body.coordinates.q, j, places);
  if (!flexible) {
    const space::RigidBody& rigid = *body.model->body->rigid();
    places.push_back(
        {pose.p, pose.R.axes, pose.p + pose.R * rigid.centre, rigid.mass, rigid.inertia(0, 0), j});
    return;
  }
  const double mass = flexible->mass / flexible->elements;
  for (int node = 0; node < flexible->node_count(); ++node) {
    space::Twist value = space::Twist::Zero();
    for (int c = 0; c < space::kTwist; ++c) {
      const int at = flexible->coordinate(node, c);
      if (at >= 0) value[c] = body.coordinates.q[at];
    }
    const auto k = static_cast<std::size_t>(node);
    const space::Position s = flexible->nodes[k] + space::Position(value.head<3>());
    const bool is_end = node == 0 || node == flexible->elements;
    // The linear shape of torsion spreads a node's inertia by 2/3 to itself.
    const space::Position p = pose.p + pose.R * s;
    places.push_back({p, (pose.R * space::exponential(value.tail<3>())).axes, p,
                      is_end ? 0.5 * mass : mass,
                      1.5 * flexible->M.diagonal[k](space::kRotation, space::kRotation), j});
  }
}

Eigen::Matrix3d outer_axes(const SubsystemData<Plane>& data) {
  std::vector<NodePlace> places;
  add_places(data, static_cast<int>(data.bodies.size()) - 1, places);
  return places.back().axes;
}
Eigen::Matrix3d outer_axes(const SubsystemData<Space>& data) {
  const BodyData<Space>& body = data.bodies[data.bodies.size() - 1];
  if (const space::Solid* solid = body.model->body->solid())
    return (data.poses[data.poses.size() - 1].R *
            calc_place_motion(solid->constants->tip, body.coordinates.q, body.coordinates.v).turn.R)
        .axes;
  std::vector<NodePlace> places;
  add_places(data, static_cast<int>(data.bodies.size()) - 1, places);
  return places.back().axes;
}

std::shared_ptr<const space::SolidConstants> solid_of(const BodyData<Plane>& /*body*/) {
  return nullptr;
}
std::shared_ptr<const space::SolidConstants> solid_of(const BodyData<Space>& body) {
  const space::Solid* solid = body.model->body->solid();
  return solid ? solid->constants : nullptr;
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
Eigen::Matrix3d inboard_axes(const BodyData<Space>& body) {
  if (const space::Solid* solid = body.model->body->solid())
    return calc_place_motion(solid->handle(0), body.coordinates.q, body.coordinates.v).turn.R.axes;
  const space::FlexibleBody* flexible = body.model->body->flexible();
  if (!flexible) return Eigen::Matrix3d::Identity();
  const space::Section section =
      make_section(*body.model->body->beam, *flexible, flexible->stations.front());
  return (motion_at(body, section).turn.R * section.axes).axes;
}

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
