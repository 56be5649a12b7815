// The model of a rotor in the plane.

#include "engine/simulation/planar_model.h"

#include <utility>

#include "engine/bodies/kernels/marker_motion.h"
#include "engine/simulation/observations.h"
#include "engine/simulation/views.h"
#include "models/error.h"

namespace spoke {

PlanarModel::PlanarModel(const Scenario& scenario, SystemContext<Plane>& context)
    : scenario_(scenario), context_(context) {
  context.system = make_system(scenario.rotor);
}

std::size_t PlanarModel::count_readings(const std::vector<Sensor>& asked) const {
  return spoke::count_readings(asked, scenario_.rotor.blades.size());
}

double PlanarModel::reading_bytes() const {
  return static_cast<double>(count_mass_bytes(context_.data));
}

std::vector<SensorColumn> PlanarModel::place_sensors(const std::vector<Sensor>& asked) {
  return spoke::place_sensors(asked, scenario_.rotor, context_.data);
}

Sensors PlanarModel::make_sensors(std::vector<SensorColumn> asked,
                                  std::vector<SensorColumn> momentum) const {
  return {context_.system, std::move(asked), std::move(momentum)};
}

void PlanarModel::start(Sensors& sensors) { sensors.start(context_.system, context_.data); }

void PlanarModel::sample(std::int64_t step, double t) {
  Sensors::sample(context_.system, step, t, context_.data);
}

double PlanarModel::energy_resolution() const { return calc_energy_resolution(scenario_); }

Wrench PlanarModel::section_force(const Marker& marker) const {
  return calc_section_force(scenario_.rotor, context_, marker);
}

void PlanarModel::calc_shape(int, double, TreeShape&) {
  throw InputError("the shape of a tree: the model is in the plane, expected one in space");
}

HubPose PlanarModel::hub_pose() const {
  const double* q = context_.data.hub_coordinates.q;
  return {{q[0], q[1], 0.0}, in_space(plane::Rotation::from_angle(q[kRotation]))};
}

MarkerMotion PlanarModel::base_frame(double t) const {
  const HubPose pose = hub_pose();
  const MarkerState hub = calc_hub_frame(context_, t);
  return {pose.position, pose.rotation, hub.velocity, hub.angular_velocity};
}

MarkerMotion PlanarModel::carrier_frame(int anchor, double t) const {
  return calc_carrier_frame(context_, anchor, t);
}

}  // namespace spoke
