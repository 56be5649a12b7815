// Calculates places, deformations and forces of the bodies of a subsystem from its coordinates.

#include "engine/tree_shape.h"

#include "engine/bodies/kernels/kinematics.h"
#include "engine/bodies/kernels/samples.h"
#include "engine/bodies/kernels/space/body_shape.h"
#include "engine/bodies/table/body_kind.h"

namespace spoke {
namespace {

/// Reduction of places and velocities by foreshortening.
struct TreeOffset {
  space::Position p = space::Position::Zero();
  space::Position v = space::Position::Zero();
};

ElementForces forces_of(const space::Twist& load) {
  const space::Position force = linear(load), moment = angular(load);
  return {force.x(), force.tail<2>().norm(), moment.x(), moment.tail<2>().norm()};
}

/// Sets what a body from a mesh has besides nodes.
void set_mesh(const BodyData<Space>& body, TreeBodyShape& shape) {
  shape.solid = body.kind->mesh(*body.model->body);
  const int count = shape.solid ? body.coordinates.size : 0;
  shape.coordinates.assign(body.coordinates.q, body.coordinates.q + count);
  shape.velocities.assign(body.coordinates.v, body.coordinates.v + count);
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
    const BodyData<Space>& body = data_.bodies[j];
    shown_.nodes.clear();
    shown_.forces.clear();
    body.kind->add_shape(body, shown_);
    TreeBodyShape& shape = shape_.bodies[j];
    shape.forces.clear();
    for (const space::Twist& load : shown_.forces) shape.forces.push_back(forces_of(load));
    set_mesh(body, shape);
    shape.nodes.clear();
    offsets_[j].clear();
    const TreeOffset before = carried_offset(j);
    const space::Rotation& R = data_.poses[j].R;
    const space::Position w = angular(data_.twists[j]);
    for (const space::ShapeNode& node : shown_.nodes)
      add_node(j, node,
               {before.p + R * node.inward,
                before.v + R * space::Position(node.inward_rate + cross(w, node.inward))});
  }

 private:
  const TreeBody<Space>& model(std::size_t j) const { return subsystem_.bodies[j]; }

  /// Returns the pose of the body if none were deformed and the joints stood as they do.
  space::Pose find_rigid(std::size_t j) const {
    const space::JointMotion& joint = data_.joints[j];
    const space::Rotation own = data_.bodies[j].work.handles[0].turn.R;
    if (model(j).parent < 0) return {joint.p, joint.R * own};
    const auto p = static_cast<std::size_t>(model(j).parent);
    const space::Rotation back = data_.bodies[p].work.handles[model(j).handle].turn.R.inverse();
    const space::Position place = undeformed_handle(p, model(j).handle) + back * joint.p;
    return {rigid_[p].p + rigid_[p].R * place, rigid_[p].R * (back * joint.R * own)};
  }
  space::Position undeformed_handle(std::size_t p, int handle) const {
    return model(p).body->handle_at_rest(static_cast<std::size_t>(handle));
  }

  /// Returns the offset of a body by the foreshortening of its carriers.
  TreeOffset carried_offset(std::size_t j) const {
    if (model(j).parent < 0) return {};
    const auto p = static_cast<std::size_t>(model(j).parent);
    const auto handle = static_cast<std::size_t>(model(j).handle);
    return offsets_[p][kind_of(*model(p).body).node_of_handle(*model(p).body, handle)];
  }

  void add_node(std::size_t j, const space::ShapeNode& shown, const TreeOffset& offset) {
    const space::HandleMotion& motion = shown.motion;
    const space::Pose &pose = data_.poses[j], &rigid = rigid_[j];
    const space::Twist& twist = data_.twists[j];
    const space::Position w = angular(twist);
    TreeNode node;
    node.p = pose.p + pose.R * motion.s - offset.p;
    node.displacement = node.p - (rigid.p + rigid.R * shown.place);
    const space::Rotation section = pose.R * motion.turn.R;
    node.rotation = logarithm(section * rigid.R.inverse());
    node.R = (section * shown.frame.inverse()).axes;
    node.velocity = pose.R * space::Position(space::Position(linear(twist)) + cross(w, motion.s) +
                                             motion.velocity) -
                    offset.v;
    node.angular_velocity = pose.R * space::Position(w + motion.turn.velocity);
    offsets_[j].push_back(offset);
    shape_.bodies[j].nodes.push_back(node);
  }

  const Subsystem<Space>& subsystem_;
  const SubsystemData<Space>& data_;
  TreeShape& shape_;
  std::vector<space::Pose> rigid_;
  std::vector<std::vector<TreeOffset>> offsets_;  ///< by body and node
  space::BodyShape shown_;                        ///< of the body that is added
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
