// Updates the state of a tree of rigid bodies, and eliminates its joints.

#include "tests/engine/bodies/space/rigid_tree.h"

#include <algorithm>

#include "engine/bodies/tree/joint_recovery.h"

namespace spoke::space::testing {
namespace {

TurnFrame find_frame(const Joint& joint) {
  for (const JointPrimitive& primitive : joint.sequence())
    if (primitive.kind == JointPrimitive::Kind::spherical) return primitive.frame;
  return TurnFrame::child;
}

/// Memory of one multi-port.
struct Port {
  explicit Port(const RigidPort& body)
      : diagonal(body.diagonal.size()), pairs(body.pairs.size()), free(body.diagonal.size()) {}
  tree::MultiPort<Space> view() {
    return {static_cast<int>(diagonal.size()), diagonal.data(), pairs.data(), free.data()};
  }
  std::vector<SymmetricTwistMatrix> diagonal;
  std::vector<TwistMatrix> pairs;
  std::vector<Twist> free;
};

}  // namespace

Coordinates::Coordinates(int size, int rotation_at, TurnFrame frame)
    : q(static_cast<std::size_t>(size)),
      v(q.size()),
      a(q.size()),
      history_(GeneralizedAlpha::count * q.size()),
      rotation_at_(rotation_at),
      frame_(frame) {}

CoordinateBlock Coordinates::block() {
  CoordinateBlock block;
  block.size = static_cast<int>(q.size());
  block.q = q.data();
  block.v = v.data();
  block.a = a.data();
  for (std::size_t k = 0; k < GeneralizedAlpha::count; ++k)
    block.history[k] = history_.data() + k * q.size();
  return block;
}

RotationBlock Coordinates::rotation(CoordinateBlock& block) {
  return {&block, rotation_at_, &orientation, frame_};
}

BodyState::BodyState(const TreeBody& model)
    : port(model.body),
      coordinates(model.joint.coordinates, model.joint.spherical_at, find_frame(model.joint)) {}

RigidTree::RigidTree(const TreeHub& hub_model, const std::vector<TreeBody>& body_models,
                     const Position& g)
    : hub(hub_model),
      models(body_models),
      gravity(g),
      hub_coordinates(kTwist, hub.support == HubSupport::axle ? -1 : kPosition),
      hub_mass_(calc_mass(hub.body)) {
  for (const TreeBody& model : models) bodies.emplace_back(model);
}

bool RigidTree::is_hub_integrated() const {
  return hub.support == HubSupport::free || !hub.is_driven;
}

JointState RigidTree::joint_state(std::size_t j) const {
  const BodyState& body = bodies[j];
  return {body.coordinates.q.data(), body.coordinates.v.data(),
          &body.coordinates.orientation.reference, body.driven.data()};
}

JointTerms RigidTree::joint_terms(std::size_t j) const {
  return {models[j].joint, bodies[j].motion, bodies[j].forces};
}

std::size_t RigidTree::child_of(std::size_t j, int o) const {
  const auto is_there = [&](const TreeBody& model) {
    return model.parent == static_cast<int>(j) && model.handle == o;
  };
  return static_cast<std::size_t>(std::find_if(models.begin(), models.end(), is_there) -
                                  models.begin());
}

HubState RigidTree::hub_state() const {
  return calc_hub_state(hub_coordinates.q.data(), hub_coordinates.v.data(),
                        {hub_coordinates.orientation});
}

void RigidTree::impose(double t) {
  if (hub.is_driven) {
    const PrescribedMotion motion = hub.drive.at(t);
    hub_coordinates.q[5] = motion.value;
    hub_coordinates.v[5] = motion.rate;
    drive_acceleration_ = motion.acceleration;
  }
  for (std::size_t j = 0; j < bodies.size(); ++j)
    for (std::size_t c = 0; c < Joint::kMost; ++c) bodies[j].driven[c] = models[j].driven[c].at(t);
}

void RigidTree::update(double t, const ImplicitShares& shares) {
  impose(t);
  const HubState at_hub = hub_state();
  const Pose hub_pose{at_hub.p, at_hub.R};
  for (std::size_t j = 0; j < bodies.size(); ++j) {
    const TreeBody& model = models[j];
    BodyState& body = bodies[j];
    const bool is_root = model.parent < 0;
    const BodyState* parent = is_root ? nullptr : &bodies[static_cast<std::size_t>(model.parent)];
    const Pose& from = is_root ? hub_pose : parent->pose;
    const Position s = is_root ? Position(Position::Zero())
                               : parent->port.handles[static_cast<std::size_t>(model.handle)];
    const Twist handle = refer(-s, is_root ? at_hub.twist : parent->twist);
    calc_joint_motion(model.joint, joint_state(j), Rotation{}, handle, body.motion, body.twist);
    calc_joint_forces(model.joint, joint_state(j), shares, body.coordinates.a.data(),
                      model.motor.data(), body.forces);
    body.pose = {from.p + from.R * Position(s + body.motion.p), from.R * body.motion.R};
    body.Q = calc_gyroscopic_force(body.port.mass, body.twist) + model.load;
  }
}

void RigidTree::place_hub(HubTable& table) const {
  table.system.gravity = gravity;
  spoke::space::Hub& model = table.system.hub;
  model.support = hub.support;
  model.drive = hub.is_driven ? Drive{FixedDrive{}} : Drive{TorqueDrive{Curve{hub.torque}}};
  model.inertia = hub_mass_;
  const HubState state = hub_state();
  table.data.hub = {state.p, state.R, state.twist};
  table.data.hub_coordinates.a[Space::kAxial] = drive_acceleration_;
}

TreeAccelerations RigidTree::eliminate() const {
  const std::size_t count = bodies.size();
  std::vector<Port> ports;
  for (const BodyState& body : bodies) ports.emplace_back(body.port);
  std::vector<tree::Branch<Space>> branches(count);
  std::vector<tree::JointElimination<Space>> eliminations(count);
  std::vector<tree::RootElimination<Space>> roots(count);
  std::vector<tree::HubShare<Space>> shares;
  for (std::size_t j = count; j-- > 0;) {
    const tree::MultiPort<Space> port = ports[j].view();
    condense(bodies[j].port, bodies[j].twist, bodies[j].Q, port);
    for (int o = port.handles - 1; o > 0; --o) {
      const std::size_t c = child_of(j, o);
      tree::eliminate_child(o, joint_terms(c), branches[c], port, eliminations[c]);
    }
    branches[j] = {port.diagonal[0], port.free[0]};
    if (models[j].parent < 0)
      shares.push_back(tree::eliminate_root(joint_terms(j), branches[j], roots[j]));
  }

  TreeAccelerations found;
  HubTable table(shares);
  place_hub(table);
  found.hub = table.solve();
  found.bodies.resize(count);
  found.wrenches.resize(count);
  found.joints.resize(count);
  for (std::size_t j = 0; j < count; ++j) {
    if (models[j].parent < 0) {
      const Twist root = calc_carried_acceleration(bodies[j].motion, found.hub.acceleration);
      found.wrenches[j] =
          tree::recover_root(joint_terms(j), roots[j], root, found.joints[j].data());
    }
    const tree::MultiPort<Space> port = ports[j].view();
    std::vector<Twist> f{found.wrenches[j]};
    for (int o = 1; o < port.handles; ++o) {
      const std::size_t c = child_of(j, o);
      f.push_back(tree::recover_child(o, joint_terms(c), port, eliminations[c], f.data(),
                                      found.joints[c].data()));
      found.wrenches[c] = tree::pass_to_child<Space>(joint_terms(c), f.back());
    }
    found.bodies[j] = recover_frame(bodies[j].port, bodies[j].Q, f);
  }
  return found;
}

double RigidTree::calc_energy() const {
  const HubState at_hub = hub_state();
  double sum = calc_kinetic_energy(hub_mass_, at_hub.twist) -
               hub.body.mass * gravity.dot(at_hub.p + at_hub.R * hub.body.centre);
  for (std::size_t j = 0; j < bodies.size(); ++j) {
    const RigidBody& body = models[j].body;
    const BodyState& state = bodies[j];
    sum += calc_kinetic_energy(state.port.mass, state.twist) -
           body.mass * gravity.dot(state.pose.p + state.pose.R * body.centre) +
           calc_spring_energy(models[j].joint, joint_state(j));
  }
  return sum;
}

Twist RigidTree::calc_momentum() const {
  const auto in_space = [](const Pose& pose, const Twist& momentum) {
    return translate(pose.p, pose.R * momentum);
  };
  const HubState at_hub = hub_state();
  Twist sum = in_space({at_hub.p, at_hub.R}, hub_mass_ * at_hub.twist);
  for (const BodyState& body : bodies) sum += in_space(body.pose, body.port.mass * body.twist);
  return sum;
}

double RigidTree::calc_power(const TreeAccelerations& found) const {
  const Twist twist = hub_state().twist;
  double sum = found.hub.reaction.dot(twist) + hub.torque * twist[5];
  for (std::size_t j = 0; j < bodies.size(); ++j) {
    const Joint& joint = models[j].joint;
    const JointState state = joint_state(j);
    sum += calc_drive_power(joint, state, bodies[j].motion, found.wrenches[j]) -
           calc_dissipation(joint, state) + models[j].load.dot(bodies[j].twist);
    for (int c = 0; c < joint.coordinates; ++c)
      sum += models[j].motor[static_cast<std::size_t>(c)] * state.v[c];
  }
  return sum;
}

}  // namespace spoke::space::testing
