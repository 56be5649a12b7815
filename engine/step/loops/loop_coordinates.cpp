// Evaluates the rows of loops at states near the start.

#include "engine/step/loops/loop_coordinates.h"

#include <algorithm>
#include <cassert>

#include "engine/bodies/kernels/hub_motion.h"
#include "engine/bodies/kernels/kinematics.h"
#include "engine/bodies/kernels/loops/loop_motion.h"
#include "engine/bodies/kernels/samples.h"
#include "engine/bodies/kernels/space/supported_rotor.h"
#include "engine/step/integrator/rotation.h"

namespace spoke {
namespace {

void list_joint(const TreeBody<Plane>&, std::size_t, int, double, std::vector<LoopCoordinate>&) {}
void list_joint(const TreeBody<Space>& body, std::size_t subsystem, int j, double length,
                std::vector<LoopCoordinate>& list) {
  int at = 0;
  for (const space::JointPrimitive& primitive : body.joint.joint.sequence()) {
    if (primitive.is_driven) continue;
    const bool slides = primitive.kind == space::JointPrimitive::Kind::prismatic;
    const bool is_spherical = primitive.kind == space::JointPrimitive::Kind::spherical;
    const int first = at;
    for (int c = 0; c < primitive.components(); ++c)
      list.push_back({subsystem, j, true, at++, slides ? length : 1.0, is_spherical ? first : -1,
                      !body.joint.course.held.empty()});
  }
}

const CoordinateBlock* joint_block(const BodyData<Plane>&) { return nullptr; }
const CoordinateBlock* joint_block(const BodyData<Space>& body) { return &body.joint.coordinates; }

void fold_joint(BodyData<Plane>&) {}
void fold_joint(BodyData<Space>& body) {
  const space::Joint& joint = body.model->joint.joint;
  if (joint.spherical_at >= 0)
    space::fold(
        {&body.joint.coordinates, joint.spherical_at, body.joint.rotation, joint.spherical_frame});
}

const std::string& held_name(const TreeBody<Plane>&) {
  static const std::string none;
  return none;
}
const std::string& held_name(const TreeBody<Space>& body) { return body.joint.course.held; }

double* driven_rate(BodyData<Plane>&, int) { return nullptr; }
double* driven_rate(BodyData<Space>& body, int c) { return &body.joint.driven[c].rate; }

}  // namespace

template <class World>
std::vector<LoopGroup> find_loop_groups(const System<World>& system) {
  const std::size_t count = system.subsystems.size();
  std::vector<std::size_t> group(count);  // by subsystem the least index of its group
  for (std::size_t i = 0; i < count; ++i) group[i] = i;
  const auto join = [&](std::size_t a, std::size_t b) {
    const auto [least, other] = std::minmax(group[a], group[b]);
    const std::size_t from = other, to = least;
    std::replace(group.begin(), group.end(), from, to);
  };
  for (const SharedLoop& loop : system.shared_loops) {
    const auto own = static_cast<std::size_t>(loop.own.subsystem);
    for (const LoopAt& at : loop.ends) join(own, static_cast<std::size_t>(at.subsystem));
    for (const LoopAt& at : loop.on_hubs) join(own, static_cast<std::size_t>(at.subsystem));
  }
  std::vector<LoopGroup> groups;
  for (std::size_t first = 0; first < count; ++first) {
    LoopGroup members;
    for (std::size_t i = first; i < count; ++i)
      if (group[i] == first && !system.subsystems[i].loops.empty()) members.push_back(i);
    std::stable_sort(members.begin(), members.end(), [&system](std::size_t a, std::size_t b) {
      return calc_level(system, static_cast<int>(a)) < calc_level(system, static_cast<int>(b));
    });
    if (!members.empty()) groups.push_back(members);
  }
  return groups;
}

template <class World>
LoopKinematics<World>::LoopKinematics(SystemContext<World>& context, const LoopGroup& group)
    : context_(context), group_(group) {
  context.data.hub = calc_hub_state(context.data);
  for (const std::size_t i : group) {
    if (!context.data.is_coupled) data(i).prescribed = calc_prescribed_motion(context.system, 0.0);
    prescribe_joints(context.system, 0.0, i, context.data);
  }
  for (const SharedLoop& loop : context.system.shared_loops)
    if (std::find(group.begin(), group.end(), static_cast<std::size_t>(loop.own.subsystem)) !=
        group.end())
      shared_.push_back(&loop);
  list_coordinates();
  list_rows();
}

template <class World>
void LoopKinematics<World>::list_rows() {
  std::vector<double> scales;
  for (const std::size_t i : group_) {
    int row = 0;
    for (const LoopModel& loop : subsystem(i).loops)
      for (const LoopRow& constants : loop.rows) {
        if (constants.is_rigid() && !loop.is_share) {
          rigid_rows_.push_back({i, row});
          scales.push_back(1.0 / loop.unit_of(constants, context_.data.length));
        }
        ++row;
      }
  }
  row_scale_ = Eigen::Map<const Eigen::VectorXd>(scales.data(), std::ssize(scales));
}

template <class World>
void LoopKinematics<World>::list_coordinates() {
  for (const std::size_t i : group_)
    for_loop_bodies(subsystem(i), data(i).loops, [&](std::size_t j) {
      list_joint(subsystem(i).bodies[j], i, static_cast<int>(j), context_.data.length,
                 coordinates_);
    });
  joint_count_ = static_cast<int>(coordinates_.size());
  for (const std::size_t i : group_)
    for_loop_bodies(subsystem(i), data(i).loops, [&](std::size_t j) {
      for (int k = 0; k < subsystem(i).bodies[j].body->coordinates(); ++k)
        coordinates_.push_back(
            {i, static_cast<int>(j), false, static_cast<int>(data(i).bodies[j].layout.offset(k))});
    });
}

template <class World>
double* LoopKinematics<World>::speed_of(const LoopCoordinate& coordinate) {
  BodyData<World>& body =
      data(coordinate.subsystem).bodies[static_cast<std::size_t>(coordinate.body)];
  return (coordinate.is_joint ? joint_block(body)->v : body.coordinates.v) + coordinate.at;
}

template <class World>
void LoopKinematics<World>::evaluate() {
  const double t = data(group_.front()).progress->control.time;
  for (const std::size_t i : group_) {
    update_kinematics(subsystem(i), data(i));
    calc_loop_motion(context_.system, i, t, {}, context_.data);
    if (shared_.empty()) continue;  // places then are on one side of an axle
    for (const int rotor : find_rotors_on(context_.system, static_cast<int>(i)))
      place_rotor(context_.system, static_cast<std::size_t>(rotor), t, false, context_.data);
  }
  for (const SharedLoop* loop : shared_)
    calc_shared_loop(context_.system, *loop, t, {}, context_.data);
}

template <class World>
Eigen::VectorXd LoopKinematics<World>::by_row(double LoopRowState<World>::*value) const {
  Eigen::VectorXd values(row_scale_.size());
  for (Eigen::Index r = 0; r < values.size(); ++r) {
    const SubsystemRow& at = rigid_rows_[static_cast<std::size_t>(r)];
    values[r] =
        row_scale_[r] * (data(at.subsystem).loops.states[static_cast<std::size_t>(at.row)].*value);
  }
  return values;
}

template <class World>
Eigen::VectorXd LoopKinematics<World>::openings() const {
  return by_row(&LoopRowState<World>::opening);
}
template <class World>
Eigen::VectorXd LoopKinematics<World>::rates() const {
  return by_row(&LoopRowState<World>::rate);
}
template <class World>
Eigen::VectorXd LoopKinematics<World>::given_rates() const {
  return by_row(&LoopRowState<World>::given_rate);
}

// Rates are linear in speeds.
template <class World>
Eigen::MatrixXd LoopKinematics<World>::calc_jacobian(int count) {
  assert(count >= 0 && std::cmp_less_equal(count, coordinates_.size()));
  evaluate();
  const Eigen::VectorXd before = rates();
  Eigen::MatrixXd jacobian(before.size(), count);
  for (int c = 0; c < count; ++c) {
    const LoopCoordinate& coordinate = coordinates_[static_cast<std::size_t>(c)];
    double& speed = *speed_of(coordinate);
    const double kept = speed;
    speed += coordinate.scale;
    evaluate();
    jacobian.col(c) = rates() - before;
    speed = kept;
  }
  evaluate();
  return jacobian;
}

template <class World>
Eigen::MatrixXd LoopKinematics<World>::calc_free_jacobian(int count) {
  Eigen::MatrixXd jacobian = calc_jacobian(count);
  for (int c = 0; c < count; ++c)
    if (coordinates_[static_cast<std::size_t>(c)].is_held) jacobian.col(c).setZero();
  return jacobian;
}

template <class World>
std::vector<std::string> LoopKinematics<World>::held_joints() const {
  std::vector<std::string> names;
  for (const std::size_t i : group_)
    for_loop_bodies(subsystem(i), data(i).loops, [&](std::size_t j) {
      if (const std::string& name = held_name(subsystem(i).bodies[j]); !name.empty())
        names.push_back(name);
    });
  return names;
}

template <class World>
Eigen::VectorXd LoopKinematics<World>::calc_driven_column(std::size_t subsystem, int body, int c) {
  evaluate();
  const Eigen::VectorXd before = rates();
  double& speed = *driven_rate(data(subsystem).bodies[static_cast<std::size_t>(body)], c);
  const double kept = speed;
  speed += 1.0;
  evaluate();
  Eigen::VectorXd column = rates() - before;
  speed = kept;
  evaluate();
  return column;
}

template <class World>
void LoopKinematics<World>::turn_hub(double by) {
  context_.data.hub.twist[World::kAxial] += by;
  for (const std::size_t i : group_) data(i).prescribed.state.twist[World::kAxial] += by;
}

template <class World>
Eigen::VectorXd LoopKinematics<World>::calc_hub_column() {
  evaluate();
  const Eigen::VectorXd before = rates();
  turn_hub(1.0);
  evaluate();
  Eigen::VectorXd column = rates() - before;
  turn_hub(-1.0);
  evaluate();
  return column;
}

template <class World>
void LoopKinematics<World>::move(const Eigen::VectorXd& by) {
  assert(by.size() <= joint_count_);
  for (Eigen::Index c = 0; c < by.size(); ++c) {
    const LoopCoordinate& coordinate = coordinates_[static_cast<std::size_t>(c)];
    BodyData<World>& body =
        data(coordinate.subsystem).bodies[static_cast<std::size_t>(coordinate.body)];
    joint_block(body)->q[coordinate.at] += coordinate.scale * by[c];
  }
  for (const std::size_t i : group_)
    for (BodyData<World>& body : data(i).bodies) fold_joint(body);
}

template <class World>
void LoopKinematics<World>::add_speeds(const Eigen::VectorXd& by) {
  assert(std::cmp_less_equal(by.size(), coordinates_.size()));
  for (Eigen::Index c = 0; c < by.size(); ++c) {
    const LoopCoordinate& coordinate = coordinates_[static_cast<std::size_t>(c)];
    *speed_of(coordinate) += coordinate.scale * by[c];
  }
}

template std::vector<LoopGroup> find_loop_groups(const System<Plane>&);
template std::vector<LoopGroup> find_loop_groups(const System<Space>&);
template class LoopKinematics<Plane>;
template class LoopKinematics<Space>;

}  // namespace spoke
