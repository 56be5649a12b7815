// The model of subsystems in space.

#include "engine/simulation/spatial_model.h"

#include <cassert>
#include <utility>

#include "engine/bodies/act/place_actors.h"
#include "engine/bodies/kernels/kinematics.h"
#include "engine/bodies/kernels/loops/loop_motion.h"
#include "engine/bodies/kernels/readings.h"
#include "engine/bodies/kernels/samples.h"
#include "engine/bodies/kernels/space/joint_values.h"
#include "engine/bodies/kernels/space/supported_rotor.h"
#include "engine/bodies/table/body_kind.h"
#include "engine/simulation/views.h"
#include "engine/support/memory.h"
#include "models/error.h"
#include "models/system/spatial_system.h"

namespace spoke {
namespace {

/// Throws if joints follow accelerations of the hub about its axle: those that a stage of rk4 finds
/// come too late for them.
void require_azimuth_motion(const SystemContext<Space>& context) {
  if (!std::holds_alternative<Rk4>(context.integrator.method)) return;
  for (const Subsystem<Space>& subsystem : context.system.subsystems)
    if (follows_azimuth(subsystem) &&
        !is_hub_prescribed(context.system, std::max(subsystem.rotor, 0)))
      throw InputError(
          "integration.method: is \"rk4\" where a joint's motion follows the azimuth of a hub "
          "that no drive prescribes the rotation of, expected \"generalized_alpha\"");
}

}  // namespace

SpatialModel::SpatialModel(const Scenario& scenario, SystemContext<Space>& context)
    : scenario_(scenario),
      context_(context),
      trees_(std::make_shared<const std::vector<spatial::Tree>>(build_trees(*scenario.space))),
      joints_(*trees_, context) {
  context.system = make_system(*scenario.space, *trees_, {{}, available_memory()});
  require_azimuth_motion(context);
}

std::size_t SpatialModel::count_readings(const std::vector<Sensor>& asked) const {
  std::size_t values = spoke::count_readings(asked, scenario_.space->blades.size(), *trees_);
  for (const Subsystem<Space>& subsystem : context_.system.subsystems)
    values +=
        static_cast<std::size_t>(count_joint_values(subsystem)) + count_actor_values(subsystem);
  return values;
}

double SpatialModel::reading_bytes() const {
  return static_cast<double>(count_reading_bytes(context_.data));
}

std::vector<SensorColumn> SpatialModel::place_sensors(const std::vector<Sensor>& asked) {
  std::vector<SubsystemData<Space>>& subsystems = context_.data.subsystems;
  for (std::size_t i = 0; i < subsystems.size(); ++i)
    subsystems[i].reading_count = count_own_values(context_.system, i, context_.data);
  std::vector<SensorColumn> columns = spoke::place_sensors(asked, scenario_.space->blades.size(),
                                                           *trees_, context_.system, context_.data);
  make_reading_rings(context_.data);
  return columns;
}

SpatialSensors SpatialModel::make_sensors(std::vector<SensorColumn> asked,
                                          std::vector<SensorColumn> momentum) const {
  return {context_.system, *trees_, context_.data, std::move(asked), std::move(momentum)};
}

void SpatialModel::start(SpatialSensors& sensors) {
  sample(0, 0.0);
  sensors.start(context_.system, context_.data);
}

void SpatialModel::sample(std::int64_t step, double t) {
  update_rotors(context_.system, t, context_.data);
  for (std::size_t i = 0; i < context_.data.subsystems.size(); ++i) {
    const Subsystem<Space>& subsystem = context_.system.subsystems[i];
    SubsystemData<Space>& data = context_.data.subsystems[i];
    prescribe_joints(context_.system, t, i, context_.data);
    update_kinematics(subsystem, data);
    update_loops(context_.system, i, t, context_.data);
    sample_subsystem(context_.system, i, step, context_.data);
    keep_own_values(i, step, t, context_.data);
    if (!data.readings.empty()) calc_readings(context_.system, i, step, t, context_.data);
  }
}

double SpatialModel::energy_resolution() const {
  const double tolerance = scenario_.integration.tolerance;
  double stiffness = 0.0;
  for (const Subsystem<Space>& subsystem : context_.system.subsystems)
    for (const TreeBody<Space>& body : subsystem.bodies)
      kind_of(*body.body).add_stiffness_trace(*body.body, stiffness);
  return 0.5 * stiffness * tolerance * tolerance;
}

Wrench SpatialModel::section_force(const Marker& marker) const {
  return calc_section_force(context_, marker);
}

void SpatialModel::calc_shape(int index, double t, TreeShape& shape) {
  assert(index >= 0 && std::cmp_less(index, context_.data.subsystems.size()));
  const auto i = static_cast<std::size_t>(index);
  const Subsystem<Space>& subsystem = context_.system.subsystems[i];
  SubsystemData<Space>& data = context_.data.subsystems[i];
  update_rotors(context_.system, t, context_.data);
  prescribe_joints(context_.system, t, i, context_.data);
  const bool is_support = i + 1 == context_.data.subsystems.size() && scenario_.space->support;
  const spatial::Tensor to_hub =
      is_support ? spatial::Tensor(spatial::Tensor::Identity())
                 : rotor_placement(hub_of(*scenario_.space, (*trees_)[i].rotor)).rotation;
  spoke::calc_shape(subsystem, data, to_hub, shape);
}

HubPose SpatialModel::hub_pose() const {
  const HubState<Space> hub =
      context_.data.rotors.empty() ? calc_hub_state(context_.data) : shown_hub(context_.data);
  return {hub.p, hub.R.axes * rotor_placement(scenario_.space->hub).rotation.transpose()};
}

MarkerMotion SpatialModel::base_frame(double t) const {
  if (context_.data.rotors.empty()) {
    const HubPose pose = hub_pose();
    const MarkerState hub = calc_hub_frame(context_, t);
    return {pose.position, pose.rotation, hub.velocity, hub.angular_velocity};
  }
  const HubState<Space> base = calc_hub_state(context_.data);
  const space::Twist velocity = base.R * base.twist;
  return {base.p, base.R.axes, linear(velocity), angular(velocity)};
}

MarkerMotion SpatialModel::carrier_frame(int anchor, double t) const {
  MarkerMotion motion = calc_carrier_frame(context_, anchor, t);
  const spatial::Model& model = *scenario_.space;
  const Anchor::Frame frame =
      anchor < 0 ? Anchor::Frame::mount : model.anchors[static_cast<std::size_t>(anchor)].frame;
  if (frame == Anchor::Frame::body) return motion;
  const bool is_of_hub = frame != Anchor::Frame::mount;
  // What a support stands on has the axes of the description.
  const int rotor = is_of_hub ? model.anchors[static_cast<std::size_t>(anchor)].rotor : 0;
  if (!model.support || is_of_hub)
    motion.rotation *= rotor_placement(hub_of(model, rotor)).rotation.transpose();
  return motion;
}

}  // namespace spoke
