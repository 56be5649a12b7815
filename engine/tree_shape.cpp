// Calculates places, deformations and forces of the bodies of a subsystem from its coordinates.

#include "engine/tree_shape.h"

#include <algorithm>
#include <array>

#include "engine/kernels/kinematics.h"
#include "engine/kernels/samples.h"
#include "engine/space/element_products.h"
#include "engine/space/nonlinear_strain.h"
#include "engine/space/solid_places.h"
#include "engine/space/solid_table_terms.h"

namespace spoke {
namespace {

using space::Position;
using space::Rotation;

/// Reduction of places and velocities by foreshortening.
struct TreeOffset {
  Position p = Position::Zero();
  Position v = Position::Zero();
};

/// Coordinates of both nodes of an element, in the frame B of the body.
struct ElementFlex {
  std::array<double, 2 * space::kTwist> values;

  ElementFlex(const space::FlexibleBody& body, int element, const double* flex) : values{} {
    for (int node = 0; node < 2; ++node)
      for (int c = 0; c < space::kTwist; ++c) {
        const int at = body.coordinate(element + node, c);
        if (at >= 0) values[static_cast<std::size_t>(space::kTwist * node + c)] = flex[at];
      }
  }
  /// Returns (v, tz) of both nodes in the axes of the element, or (w, -ty).
  Eigen::Vector4d bending(const space::BeamElement& element, int direction) const {
    Eigen::Vector4d x;
    for (int node = 0; node < 2; ++node) {
      const double* q = values.data() + space::kTwist * node;
      const Position u(q[0], q[1], q[2]), th(q[3], q[4], q[5]);
      const double slope =
          direction == 1 ? element.axes.col(2).dot(th) : -element.axes.col(1).dot(th);
      x.segment<2>(2 * node) << element.axes.col(direction).dot(u), slope;
    }
    return x;
  }
};

/// Returns int (a' b') dx over an element, across it in both directions [m].
double integrate_slopes(const space::BeamElement& element, const ElementFlex& a,
                        const ElementFlex& b) {
  double sum = 0.0;
  for (const int direction : {1, 2})
    sum += a.bending(element, direction)
               .dot(element.stiffening.bending[0] * b.bending(element, direction));
  return sum;
}

ElementForces calc_forces(const space::FlexibleBody& body, int e, const double* flex,
                          const ElementFlex& q) {
  const space::BeamElement& element = body.beam[static_cast<std::size_t>(e)];
  space::Twist d, outer;
  if (body.is_nonlinear())
    d = calc_strain(body, e, flex);
  else
    calc_relative(element, q.values.data(), d.data());
  space::multiply(element.stiffness.data(), d.data()).store_to(outer.data());
  const Position force = element.axes.transpose() * Position(linear(outer));
  const Position moment =
      element.axes.transpose() *
      Position(Position(angular(outer)) + 0.5 * cross(element.chord, Position(linear(outer))));
  return {force.x(), force.tail<2>().norm(), moment.x(), moment.tail<2>().norm()};
}

/// Walks through a subsystem from the hub on, in the hub frame H of the table.
class SubsystemWalk {
 public:
  SubsystemWalk(const Subsystem<Space>& subsystem, const SubsystemData<Space>& data,
                TreeShape& shape)
      : subsystem_(subsystem), data_(data), shape_(shape) {
    shape.bodies.resize(data.bodies.size());
    offsets_.resize(data.bodies.size());
    for (std::size_t j = 0; j < data.bodies.size(); ++j) rigid_.push_back(find_rigid(j));
  }

  /// Adds body j. Must be called in order of bodies.
  void add(std::size_t j) {
    const space::Body& body = *data_.bodies[j].model->body;
    shape_.bodies[j].nodes.clear();
    shape_.bodies[j].forces.clear();
    shape_.bodies[j].solid.reset();
    shape_.bodies[j].coordinates.clear();
    shape_.bodies[j].velocities.clear();
    if (const space::FlexibleBody* flexible = body.flexible())
      add_flexible(j, *flexible);
    else if (const space::Solid* solid = body.solid())
      add_solid(j, *solid);
    else
      add_node(j, Rotation{}, Position::Zero(), space::make_fixed_handle(Position::Zero()),
               carried_offset(j));
  }

 private:
  const TreeBody<Space>& model(std::size_t j) const { return subsystem_.bodies[j]; }

  /// Returns the pose of the body if none were deformed and the joints stood as they do.
  space::Pose find_rigid(std::size_t j) const {
    const space::JointMotion& joint = data_.joints[j];
    const Rotation own = data_.bodies[j].work.handles[0].turn.R;
    if (model(j).parent < 0) return {joint.p, joint.R * own};
    const auto p = static_cast<std::size_t>(model(j).parent);
    const Rotation back = data_.bodies[p].work.handles[model(j).handle].turn.R.inverse();
    const Position place = undeformed_handle(p, model(j).handle) + back * joint.p;
    return {rigid_[p].p + rigid_[p].R * place, rigid_[p].R * (back * joint.R * own)};
  }
  Position undeformed_handle(std::size_t p, int handle) const {
    return model(p).body->handle_at_rest(static_cast<std::size_t>(handle));
  }

  /// Returns the offset of a body by the foreshortening of its carriers.
  TreeOffset carried_offset(std::size_t j) const {
    if (model(j).parent < 0) return {};
    const auto p = static_cast<std::size_t>(model(j).parent);
    const auto handle = static_cast<std::size_t>(model(j).handle);
    if (const space::FlexibleBody* parent = model(p).body->flexible())
      return offsets_[p][static_cast<std::size_t>(parent->handles[handle])];
    if (const space::Solid* parent = model(p).body->solid())
      return offsets_[p][1 + static_cast<std::size_t>(parent->handles[handle])];
    return offsets_[p][0];
  }

  void add_flexible(std::size_t j, const space::FlexibleBody& body) {
    const BodyData<Space>& data = data_.bodies[j];
    const double *q = data.coordinates.q, *v = data.coordinates.v;
    const TreeOffset before = carried_offset(j);
    const Position w = angular(data_.twists[j]);
    double shortening = 0.0, rate = 0.0;
    offsets_[j].clear();
    for (int k = 0; k <= body.elements; ++k) {
      const int e = std::max(0, k - 1);
      const space::BeamElement& element = body.beam[static_cast<std::size_t>(e)];
      const ElementFlex flex(body, e, q), speed(body, e, v);
      if (k > 0) {
        shape_.bodies[j].forces.push_back(calc_forces(body, e, q, flex));
        if (data.model->stiffening) {
          shortening += 0.5 * integrate_slopes(element, flex, flex);
          rate += integrate_slopes(element, flex, speed);
        }
      }
      const Position shortened(shortening, 0.0, 0.0), slower(rate, 0.0, 0.0);
      const Rotation& R = data_.poses[j].R;
      const TreeOffset offset{before.p + R * shortened,
                              before.v + R * Position(slower + cross(w, shortened))};
      const std::size_t at = k == 0 ? 0 : space::kTwist;
      add_node(j, body.pose.R, body.nodes[static_cast<std::size_t>(k)],
               motion_of(flex.values.data() + at, speed.values.data() + at,
                         body.nodes[static_cast<std::size_t>(k)]),
               offset);
    }
  }
  /// Adds the frame and the places of a solid.
  void add_solid(std::size_t j, const space::Solid& solid) {
    const BodyData<Space>& data = data_.bodies[j];
    const double *q = data.coordinates.q, *v = data.coordinates.v;
    const TreeOffset before = carried_offset(j);
    const Position w = angular(data_.twists[j]);
    const Rotation& R = data_.poses[j].R;
    offsets_[j].clear();
    add_node(j, Rotation{}, Position::Zero(), space::make_fixed_handle(Position::Zero()), before);
    shape_.bodies[j].solid = solid.constants;
    shape_.bodies[j].coordinates.assign(q, q + solid.coordinates());
    shape_.bodies[j].velocities.assign(v, v + solid.coordinates());
    for (std::size_t i = 0; i < solid.constants->places.size(); ++i) {
      const space::SolidPlace& place = solid.constants->places[i];
      const space::PlaceDrawn drawn = calc_solid_drawn(data, static_cast<int>(i), q, v, nullptr);
      add_node(j, Rotation{}, place.p, calc_place_motion(place, q, v),
               {before.p - R * drawn.place,
                before.v - R * Position(drawn.rate + cross(w, drawn.place))});
    }
  }
  static space::HandleMotion motion_of(const double* q, const double* v, const Position& place) {
    return {place + Position(q[0], q[1], q[2]), Position(v[0], v[1], v[2]),
            space::calc_rotation_vector_motion({q[3], q[4], q[5]}, {v[3], v[4], v[5]})};
  }

  /// Adds a node that moves as given against the body; `frame` takes the axes of the body to those
  /// of the scenario.
  void add_node(std::size_t j, const Rotation& frame, const Position& place,
                const space::HandleMotion& motion, const TreeOffset& offset) {
    const space::Pose &pose = data_.poses[j], &rigid = rigid_[j];
    const space::Twist& twist = data_.twists[j];
    const Position w = angular(twist);
    TreeNode node;
    node.p = pose.p + pose.R * motion.s - offset.p;
    node.displacement = node.p - (rigid.p + rigid.R * place);
    const Rotation section = pose.R * motion.turn.R;
    node.rotation = logarithm(section * rigid.R.inverse());
    node.R = (section * frame.inverse()).axes;
    node.velocity =
        pose.R * Position(Position(linear(twist)) + cross(w, motion.s) + motion.velocity) -
        offset.v;
    node.angular_velocity = pose.R * Position(w + motion.turn.velocity);
    offsets_[j].push_back(offset);
    shape_.bodies[j].nodes.push_back(node);
  }

  const Subsystem<Space>& subsystem_;
  const SubsystemData<Space>& data_;
  TreeShape& shape_;
  std::vector<space::Pose> rigid_;
  std::vector<std::vector<TreeOffset>> offsets_;  ///< by body and node
};

/// Turns a node from the hub frame of the table to that of the scenario.
void turn(const spatial::Tensor& R, TreeNode& node) {
  for (spatial::Vector* v :
       {&node.p, &node.displacement, &node.rotation, &node.velocity, &node.angular_velocity})
    *v = R * *v;
  node.R = R * node.R;
}

}  // namespace

void calc_shape(const Subsystem<Space>& subsystem, SubsystemData<Space>& data,
                const spatial::Tensor& to_hub, TreeShape& shape) {
  update_kinematics(subsystem, data);
  calc_poses(subsystem, data, data.poses);
  SubsystemWalk walk(subsystem, data, shape);
  for (std::size_t j = 0; j < data.bodies.size(); ++j) walk.add(j);
  for (TreeBodyShape& body : shape.bodies)
    for (TreeNode& node : body.nodes) turn(to_hub, node);
}

}  // namespace spoke
