// Sets states of the table, runs the nodes that find accelerations there, and reads them.

#include "engine/small_motions/steady/steady_system.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "engine/bodies/columns/spatial_columns.h"
#include "engine/bodies/kernels/deformation_limits.h"
#include "engine/bodies/kernels/hub_motion.h"
#include "engine/bodies/kernels/hub_solve.h"
#include "engine/bodies/kernels/kinematics.h"
#include "engine/bodies/kernels/loops/loop_motion.h"
#include "engine/bodies/kernels/plane/section_balance.h"
#include "engine/bodies/kernels/readings.h"
#include "engine/bodies/kernels/samples.h"
#include "engine/small_motions/steady/steady_anchors.h"
#include "engine/small_motions/steady/steady_loops.h"
#include "engine/small_motions/steady/subsystem_access.h"
#include "engine/small_motions/steady/subsystem_forces.h"
#include "engine/step/assembly.h"
#include "engine/step/formulation/loops/loops.h"
#include "engine/step/formulation/loops/shared_loops.h"
#include "engine/step/step_graph_builder.h"
#include "models/error.h"
#include "models/system/spatial_system.h"
#include "models/system/tip_body.h"
#include "models/tree/tree.h"

namespace spoke::steady {
namespace {

/// A time at which all ramps are over.
constexpr double kLate = std::numeric_limits<double>::max();

/// Returns the undeformed frame of the body on the hub from which another one hangs.
plane::Rotation root_rotation(const Subsystem<Plane>& subsystem, int) { return subsystem.root.R; }
space::Rotation root_rotation(const Subsystem<Space>& subsystem, int body) {
  const TreeBody<Space>* root = &subsystem.bodies[static_cast<std::size_t>(body)];
  while (root->parent >= 0) root = &subsystem.bodies[static_cast<std::size_t>(root->parent)];
  return root->joint.joint.offset.R;
}

}  // namespace

template <class World>
SteadySystem<World>::SteadySystem(const SystemMaker<World>& maker,
                                  std::vector<SubsystemNames> names, const SteadyOptions& options)
    : names_(std::move(names)) {
  speed_ = options.speed;
  is_support_ = options.is_support;
  holds_forces_ = options.holds_forces;
  maker.fill(context_.system);
  const std::vector<std::vector<LoopRowUse>> use = start_loops_of(context_.system, maker.loops);
  hub_ = context_.system.hub;
  for (int c = 0; c < World::kTwist; ++c)
    if (!is_prescribed(hub_, c)) free_.push_back(c);
  const bool is_axial = (speed_ != 0.0 || options.is_axial) && !options.is_whole;
  loads_.emplace(context_.system, is_axial, options.instant);
  if (context_.system.wind) blow(is_axial, options.is_whole);
  hold_anchors(context_.system, speed_ != 0.0, options.instant);
  context_.system.hub.support = HubSupport::axle;
  hold_hub();
  context_.integrator = {Rk4{1.0}, {}};
  context_.linear_range = 0.0;  // find_large_deflection() reports every deflection
  context_.loop_limits.has_started = true;
  allocate(context_);
  for (std::size_t i = 0; i < subsystems(); ++i) data(i).loops.use = use[i];
  take_uses_of_shared_loops(context_.system, context_.data);
  outputs_.resize(subsystems());
  if (options.has_outputs) set_outputs(maker.place_sensors(context_.system, context_.data));
  std::fill(context_.data.progress.begin(), context_.data.progress.end(),
            make_progress_between_steps(context_.integrator, 0, PassControl::kEvaluateOnly));
  graph_.emplace(build_step_graph(context_));
  find_nodes();
  hold_rotors();
  for (std::size_t i = 0; i < subsystems(); ++i)
    rows_.push_back(list_rows(context_.system.subsystems[i], data(i)));
  standing_springs_.resize(subsystems());
  for (std::size_t i = 0; speed_ != 0.0 && i < subsystems(); ++i)
    standing_springs_[i] = find_standing_springs(context_.system, i);
  set_undeformed();
}

/// Takes the wind at the hub for that of all places, unless it counts in full.
template <class World>
void SteadySystem<World>::blow(bool is_axial, bool is_whole) {
  if constexpr (std::is_same_v<World, Space>) {
    System<Space>& system = context_.system;
    wind_ = std::make_shared<SteadyWind>(system.wind, is_whole || is_support_);
    if (is_axial) wind_->keep_axial(make_rotation(system.hub.orientation).axes.col(2));
    system.wind = wind_;
  }
}

template <class World>
void SteadySystem<World>::hold_states(std::size_t subsystem, bool holds) {
  for (const auto& pair : data(subsystem).delayed) holds ? pair->keep() : pair->forget();
}

template <class World>
void SteadySystem<World>::hold_states_at(std::size_t subsystem, std::span<const double> states) {
  for (const auto& pair : data(subsystem).delayed) {
    assert(states.size() >= pair->kept.size());
    std::copy_n(states.begin(), pair->kept.size(), pair->kept.begin());
    states = states.subspan(pair->kept.size());
  }
  assert(states.empty());
}

template <class World>
std::vector<double> SteadySystem<World>::advance_states(std::size_t subsystem, double elapsed) {
  for (const auto& actor : context_.data.actors) actor->advance(subsystem, elapsed);
  std::vector<double> states;
  for (const auto& pair : data(subsystem).delayed) {
    pair->keep();
    states.insert(states.end(), pair->kept.begin(), pair->kept.end());
  }
  return states;
}

template <class World>
std::size_t SteadySystem<World>::count_states(std::size_t subsystem) const {
  std::size_t count = 0;
  for (const auto& pair : data(subsystem).delayed) count += pair->kept.size();
  return count;
}

template <class World>
std::vector<ForceState> SteadySystem<World>::force_states(std::size_t subsystem) const {
  if (holds_forces_) return {};
  std::vector<RelaxingState> relaxing;
  for (const auto& actor : context_.data.actors) actor->list_relaxing(subsystem, relaxing);
  std::vector<ForceState> list;
  for (const RelaxingState& own : relaxing) {
    ForceState& state = list.emplace_back();
    state.coordinate = find_coordinate(subsystem, own.body, own.coordinate);
    state.stiffness = own.stiffness;
    state.time = own.time;
    state.state = own.index;
    for (const auto& pair : data(subsystem).delayed) {
      if (pair.get() == own.pair) break;
      state.state += pair->kept.size();
    }
  }
  return list;
}

/// Returns the number of a coordinate of the joint that carries a body.
template <class World>
Eigen::Index SteadySystem<World>::find_coordinate(std::size_t subsystem, int body,
                                                  int coordinate) const {
  Eigen::Index at = coordinate;
  for (int j = 0; j < body; ++j) {
    const TreeBody<World>& before =
        context_.system.subsystems[subsystem].bodies[static_cast<std::size_t>(j)];
    at += count_joint_coordinates(before) + before.body->coordinates();
  }
  return at;
}

template <class World>
void SteadySystem<World>::hold_hub() {
  context_.system.hub.drive = ConstantSpeed{std::sqrt(share_) * speed_};
}

template <class World>
void SteadySystem<World>::move_hub(double turn, double rate, double acceleration) {
  moved_ = no_offset();
  moved_->turn[World::kAxial] = turn;
  moved_->twist[World::kAxial] = rate;
  moved_->acceleration[World::kAxial] = acceleration;
}

template <class World>
void SteadySystem<World>::find_nodes() {
  terms_.resize(subsystems());
  solution_.resize(subsystems());
  for (const graph::NodeId node : graph_->serial_order()) {
    const graph::NodeLabel& label = graph_->node(node).label;
    const StageRole role = role_of(label.stage, context_.data);
    if (role != StageRole::given && label.stage != stages::kFinish.name) pass_.push_back(node);
    if (label.subsystem < 0) continue;
    const auto subsystem = static_cast<std::size_t>(label.subsystem);
    if (role == StageRole::terms) terms_[subsystem].push_back(node);
    if (role == StageRole::solution) solution_[subsystem].push_back(node);
  }
  for (std::size_t subsystem = 0; subsystem < subsystems(); ++subsystem)
    assert(!terms_[subsystem].empty() && !solution_[subsystem].empty());
}

/// Names the coordinates, gives elastic forces coordinates of their own, and keeps the directions
/// of tips.
template <class World>
void SteadySystem<World>::set_undeformed() {
  for (std::size_t i = 0; i < subsystems(); ++i) {
    std::vector<SubsystemCoordinate>& list = coordinates_.emplace_back();
    std::vector<Eigen::VectorXd>& q = q_elastic_.emplace_back();
    std::vector<Eigen::VectorXd>& v = v_elastic_.emplace_back();
    for (std::size_t j = 0; j < data(i).bodies.size(); ++j) {
      BodyData<World>& body = data(i).bodies[j];
      for (SubsystemCoordinate& coordinate : name_coordinates(
               *body.model, static_cast<int>(j), names_[i].bodies[j], names_[i].joints[j]))
        list.push_back(std::move(coordinate));
      q.push_back(Eigen::VectorXd::Zero(body.layout.size()));
      v.push_back(Eigen::VectorXd::Zero(body.layout.size()));
    }
    for (std::size_t j = 0; j < data(i).bodies.size(); ++j) {
      data(i).bodies[j].q_elastic = q[j].data();
      data(i).bodies[j].v_elastic = data(i).bodies[j].v_modal = v[j].data();
    }
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(std::ssize(list));
    SubsystemResponse response;
    evaluate(i, {zero, zero, zero, zero}, no_offset(), response);
    calc_poses(context_.system.subsystems[i], data(i), data(i).poses);
    tip_axes_.push_back(outer_axes(data(i), find_tip_body(context_.system, i)));
  }
  stiffness_.resize(subsystems());
}

template <class World>
const Eigen::MatrixXd& SteadySystem<World>::stiffness(std::size_t subsystem) {
  const auto& bodies = data(subsystem).bodies;
  Eigen::MatrixXd& stiffness = stiffness_[subsystem];
  if (stiffness.size() == 0 ||
      std::any_of(bodies.begin(), bodies.end(),
                  [](const BodyData<World>& body) { return has_nonlinear_strain(body); }))
    stiffness = assemble_stiffness(subsystem);
  return stiffness;
}

template <class World>
Eigen::MatrixXd SteadySystem<World>::assemble_stiffness(std::size_t subsystem) const {
  const Eigen::Index n = std::ssize(coordinates_[subsystem]);
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n);
  Eigen::Index at = 0;
  for (const BodyData<World>& body : data(subsystem).bodies) {
    const Eigen::Index nf = body.model->body->coordinates();
    at += count_joint_coordinates(*body.model);
    if (nf > 0) K.block(at, at, nf, nf) = calc_body_stiffness(body);
    at += nf;
  }
  return K;
}

template <class World>
Eigen::Matrix3d SteadySystem<World>::root_axes(std::size_t subsystem, int body) const {
  return axes_of(root_rotation(context_.system.subsystems[subsystem], body));
}

template <class World>
bool SteadySystem<World>::has_torque_drive() const {
  return !prescribes_motion(hub_.drive) && !std::holds_alternative<FreeDrive>(hub_.drive);
}

template <class World>
void SteadySystem<World>::set_share(double share) {
  assert(share >= 0.0 && share <= 1.0);
  share_ = share;
  loads_->set_share(share);
  if (wind_) wind_->set_share(std::sqrt(share));
  hold_hub();
}

template <class World>
Eigen::VectorXd SteadySystem<World>::initial(std::size_t subsystem) const {
  Eigen::VectorXd q = Eigen::VectorXd::Zero(std::ssize(coordinates_[subsystem]));
  Eigen::Index at = 0;
  for (const TreeBody<World>& body : context_.system.subsystems[subsystem].bodies) {
    take_initial(body, q.data() + at);
    at += count_joint_coordinates(body) + body.body->coordinates();
  }
  return q;
}

template <class World>
void SteadySystem<World>::settle(std::size_t subsystem, Eigen::VectorXd& q) {
  assert(subsystem < subsystems() && std::cmp_equal(q.size(), coordinates_[subsystem].size()));
  Eigen::Index at = 0;
  for (BodyData<World>& body : data(subsystem).bodies) {
    fold_joint(q.data() + at, body);
    at += count_joint_coordinates(*body.model) + body.model->body->coordinates();
  }
}

template <class World>
void SteadySystem<World>::settle_at(std::size_t subsystem, const Eigen::VectorXd& absolute) {
  assert(subsystem < subsystems() &&
         std::cmp_equal(absolute.size(), coordinates_[subsystem].size()));
  const double* next = absolute.data();
  for (BodyData<World>& body : data(subsystem).bodies) {
    put_absolute(next, body);
    next += count_joint_coordinates(*body.model) + body.model->body->coordinates();
  }
}

template <class World>
Eigen::VectorXd SteadySystem<World>::absolute(std::size_t subsystem,
                                              const Eigen::VectorXd& q) const {
  assert(subsystem < subsystems() && std::cmp_equal(q.size(), coordinates_[subsystem].size()));
  Eigen::VectorXd result = q;
  Eigen::Index at = 0;
  for (const BodyData<World>& body : data(subsystem).bodies) {
    make_absolute(body, result.data() + at);
    at += count_joint_coordinates(*body.model) + body.model->body->coordinates();
  }
  return result;
}

template <class World>
void SteadySystem<World>::put_bodies(std::size_t subsystem, const Eigen::VectorXd& q,
                                     const Eigen::VectorXd& v) {
  Eigen::Index at = 0;
  for (BodyData<World>& body : data(subsystem).bodies) {
    put_joint(q.data() + at, v.data() + at, body);
    at += count_joint_coordinates(*body.model);
    for (int k = 0; k < body.model->body->coordinates(); ++k, ++at) {
      body.coordinates.q[body.layout.offset(k)] = q[at];
      body.coordinates.v[body.layout.offset(k)] = v[at];
    }
  }
}

template <class World>
void SteadySystem<World>::place(std::size_t subsystem, const SubsystemState& state) {
  assert(subsystem < subsystems() &&
         std::cmp_equal(state.q.size(), coordinates_[subsystem].size()));
  assert(state.v.size() == state.q.size());
  put_bodies(subsystem, state.q, state.v);
  Eigen::Index at = 0;
  for (std::size_t j = 0; j < data(subsystem).bodies.size(); ++j) {
    const BodyData<World>& body = data(subsystem).bodies[j];
    at += count_joint_coordinates(*body.model);
    for (int k = 0; k < body.model->body->coordinates(); ++k, ++at) {
      q_elastic_[subsystem][j][body.layout.offset(k)] = state.q_elastic[at];
      v_elastic_[subsystem][j][body.layout.offset(k)] = state.v_elastic[at];
    }
  }
}

template <class World>
PrescribedHub<World> SteadySystem<World>::hub_motion(const HubOffset& offset) const {
  PrescribedHub<World> hub = calc_prescribed_motion(context_.system, 0.0);
  if (moved_) {
    hub.state.R = hub.state.R * turn_of(moved_->turn, World{});
    hub.state.twist += moved_->twist;
  }
  hub.state.R = hub.state.R * turn_of(offset.turn, World{});
  hub.state.twist += offset.twist;
  hub.acceleration = calc_prescribed_acceleration(context_.system, 0.0, hub.state, 0.0);
  hub.acceleration += offset.acceleration;
  if (moved_) hub.acceleration += moved_->acceleration;
  return hub;
}

template <class World>
Eigen::MatrixXd SteadySystem<World>::closures(std::size_t subsystem) {
  assert(subsystem < subsystems());
  return calc_closures(context_.system.subsystems[subsystem], data(subsystem));
}

template <class World>
std::vector<LoopLoad> SteadySystem<World>::loop_loads(std::size_t subsystem,
                                                      const Eigen::VectorXd& multipliers) const {
  assert(std::cmp_equal(multipliers.size(), rows_[subsystem].size()));
  return calc_loop_loads(context_.system, subsystem, multipliers, context_.data);
}

/// Runs the nodes of kinematics and terms at a state, and sets the states of the loops that are the
/// subsystem's alone.
template <class World>
void SteadySystem<World>::calc_terms(std::size_t subsystem, const SubsystemState& state,
                                     const HubOffset& hub) {
  place(subsystem, state);
  set_hub(subsystem, hub);
  for (const graph::NodeId node : terms_[subsystem]) graph_->run_node(node);
  if (!rows_[subsystem].empty())
    calc_loop_motion(context_.system, subsystem, 0.0, {}, context_.data);
}

/// Gives a subsystem the motion of the hub that carries it. One on a carrier follows that instead.
template <class World>
void SteadySystem<World>::set_hub(std::size_t subsystem, const HubOffset& hub) {
  SubsystemData<World>& own = data(subsystem);
  if (own.rotor >= 0) return;
  own.prescribed = hub_motion(hub);
  if (!context_.data.is_coupled) return;
  const PrescribedHub<World>& given = own.prescribed;
  context_.data.hub = given.state;
  context_.data.hub_solution.acceleration = given.acceleration;
  // Sensors read it as that of the hub's coordinates.
  TwistOf<World> inertial = given.acceleration;
  linear(inertial) = given.state.R * PositionOf<World>(linear(given.acceleration)) +
                     PositionOf<World>(context_.system.gravity_at(0.0));
  inertial[World::kAxial] -= calc_carried_spin_up(context_.system, 0.0);
  std::copy_n(inertial.data(), World::kTwist, context_.data.hub_coordinates.a);
}

template <class World>
void SteadySystem<World>::evaluate(std::size_t subsystem, const SubsystemState& state,
                                   const HubOffset& hub, SubsystemResponse& response) {
  calc_terms(subsystem, state, hub);
  calc_frame_accelerations(context_.system.subsystems[subsystem], data(subsystem));
  put_loops(context_.system, subsystem, state, rows_[subsystem], context_.data, response);
  sum_response(subsystem, {}, response);
}

/// Adds up the forces, those of rows by `response.multipliers` among them.
template <class World>
void SteadySystem<World>::sum_response(std::size_t subsystem,
                                       const std::vector<CarriedWrench<World>>& carried,
                                       SubsystemResponse& response) {
  SubsystemData<World>& own = data(subsystem);
  calc_forces(context_.system.subsystems[subsystem], carried, own, response);
  response.is_valid =
      response.force.allFinite() && response.openings.allFinite() &&
      std::none_of(own.bodies.begin(), own.bodies.end(),
                   [](const BodyData<World>& body) { return has_left_limits(body); });
}

template <class World>
Eigen::VectorXd SteadySystem<World>::accelerations(std::size_t subsystem) {
  assert(subsystem < subsystems());
  for (const graph::NodeId node : solution_[subsystem]) graph_->run_node(node);
  return take_accelerations(subsystem);
}

/// Returns the accelerations in the table.
template <class World>
Eigen::VectorXd SteadySystem<World>::take_accelerations(std::size_t subsystem) const {
  Eigen::VectorXd a(std::ssize(coordinates_[subsystem]));
  Eigen::Index at = 0;
  for (const BodyData<World>& body : data(subsystem).bodies) {
    take_joint(body, a.data() + at);
    at += count_joint_coordinates(*body.model);
    for (int k = 0; k < body.model->body->coordinates(); ++k, ++at)
      a[at] = body.a_found[body.layout.offset(k)];
  }
  return a;
}

/// Returns the coordinates in the table.
template <class World>
Eigen::VectorXd SteadySystem<World>::take_bodies(std::size_t subsystem) const {
  Eigen::VectorXd q(std::ssize(coordinates_[subsystem]));
  Eigen::Index at = 0;
  for (const BodyData<World>& body : data(subsystem).bodies) {
    take_joint_position(body, q.data() + at);
    at += count_joint_coordinates(*body.model);
    for (int k = 0; k < body.model->body->coordinates(); ++k, ++at)
      q[at] = body.coordinates.q[body.layout.offset(k)];
  }
  return q;
}

template <class World>
HubVector SteadySystem<World>::hub_force(const HubOffset& offset) const {
  const PrescribedHub<World> hub = hub_motion(offset);
  HubSolution<World> applied{};
  applied.applied_torque = share_ * calc_torque(hub_.drive, kLate, hub.state.twist[World::kAxial]);
  applied.load = calc_hub_load(context_.system, 0.0, hub.state);
  return calc_hub_force<World>(hub_, hub.state, applied) - calc_hub_mass(hub_) * hub.acceleration;
}

template <class World>
Eigen::MatrixXd SteadySystem<World>::hub_mass() const {
  return calc_hub_mass(hub_);
}

// Each file of the class makes its own members.
template SteadySystem<Plane>::SteadySystem(const SystemMaker<Plane>&, std::vector<SubsystemNames>,
                                           const SteadyOptions&);
template bool SteadySystem<Plane>::has_torque_drive() const;
template Eigen::Matrix3d SteadySystem<Plane>::root_axes(std::size_t, int) const;
template void SteadySystem<Plane>::set_share(double);
template void SteadySystem<Plane>::hold_states(std::size_t, bool);
template void SteadySystem<Plane>::hold_states_at(std::size_t, std::span<const double>);
template std::vector<double> SteadySystem<Plane>::advance_states(std::size_t, double);
template std::vector<ForceState> SteadySystem<Plane>::force_states(std::size_t) const;
template void SteadySystem<Plane>::move_hub(double, double, double);
template Eigen::VectorXd SteadySystem<Plane>::initial(std::size_t) const;
template void SteadySystem<Plane>::settle(std::size_t, Eigen::VectorXd&);
template void SteadySystem<Plane>::settle_at(std::size_t, const Eigen::VectorXd&);
template Eigen::VectorXd SteadySystem<Plane>::absolute(std::size_t, const Eigen::VectorXd&) const;
template void SteadySystem<Plane>::put_bodies(std::size_t, const Eigen::VectorXd&,
                                              const Eigen::VectorXd&);
template Eigen::VectorXd SteadySystem<Plane>::take_bodies(std::size_t) const;
template void SteadySystem<Plane>::calc_terms(std::size_t, const SubsystemState&, const HubOffset&);
template void SteadySystem<Plane>::sum_response(std::size_t,
                                                const std::vector<CarriedWrench<Plane>>&,
                                                SubsystemResponse&);
template Eigen::VectorXd SteadySystem<Plane>::take_accelerations(std::size_t) const;
template void SteadySystem<Plane>::evaluate(std::size_t, const SubsystemState&, const HubOffset&,
                                            SubsystemResponse&);
template Eigen::VectorXd SteadySystem<Plane>::accelerations(std::size_t);
template Eigen::MatrixXd SteadySystem<Plane>::closures(std::size_t);
template std::vector<LoopLoad> SteadySystem<Plane>::loop_loads(std::size_t,
                                                               const Eigen::VectorXd&) const;
template HubVector SteadySystem<Plane>::hub_force(const HubOffset&) const;
template Eigen::MatrixXd SteadySystem<Plane>::hub_mass() const;
template SteadySystem<Space>::SteadySystem(const SystemMaker<Space>&, std::vector<SubsystemNames>,
                                           const SteadyOptions&);
template bool SteadySystem<Space>::has_torque_drive() const;
template Eigen::Matrix3d SteadySystem<Space>::root_axes(std::size_t, int) const;
template void SteadySystem<Space>::set_share(double);
template void SteadySystem<Space>::hold_states(std::size_t, bool);
template void SteadySystem<Space>::hold_states_at(std::size_t, std::span<const double>);
template std::vector<double> SteadySystem<Space>::advance_states(std::size_t, double);
template std::vector<ForceState> SteadySystem<Space>::force_states(std::size_t) const;
template std::size_t SteadySystem<Space>::count_states(std::size_t) const;
template void SteadySystem<Space>::move_hub(double, double, double);
template Eigen::VectorXd SteadySystem<Space>::initial(std::size_t) const;
template void SteadySystem<Space>::settle(std::size_t, Eigen::VectorXd&);
template void SteadySystem<Space>::settle_at(std::size_t, const Eigen::VectorXd&);
template Eigen::VectorXd SteadySystem<Space>::absolute(std::size_t, const Eigen::VectorXd&) const;
template void SteadySystem<Space>::put_bodies(std::size_t, const Eigen::VectorXd&,
                                              const Eigen::VectorXd&);
template Eigen::VectorXd SteadySystem<Space>::take_bodies(std::size_t) const;
template void SteadySystem<Space>::calc_terms(std::size_t, const SubsystemState&, const HubOffset&);
template void SteadySystem<Space>::sum_response(std::size_t,
                                                const std::vector<CarriedWrench<Space>>&,
                                                SubsystemResponse&);
template Eigen::VectorXd SteadySystem<Space>::take_accelerations(std::size_t) const;
template void SteadySystem<Space>::evaluate(std::size_t, const SubsystemState&, const HubOffset&,
                                            SubsystemResponse&);
template Eigen::VectorXd SteadySystem<Space>::accelerations(std::size_t);
template Eigen::MatrixXd SteadySystem<Space>::closures(std::size_t);
template std::vector<LoopLoad> SteadySystem<Space>::loop_loads(std::size_t,
                                                               const Eigen::VectorXd&) const;
template HubVector SteadySystem<Space>::hub_force(const HubOffset&) const;
template Eigen::MatrixXd SteadySystem<Space>::hub_mass() const;

}  // namespace spoke::steady
