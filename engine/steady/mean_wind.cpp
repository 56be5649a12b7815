// Finds the hub and asks for the wind there.

#include "engine/steady/mean_wind.h"

#include <cassert>

#include "models/space/rotation_vector.h"
#include "models/tree/tree.h"

namespace spoke::steady {
namespace {

/// Returns the place of the hub, undeformed and with joint coordinates zero, inertial frame [m].
Eigen::Vector3d find_hub(const spatial::Model& model) {
  if (!model.support) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d from_base = calc_placements(build_trees(model).back()).back().position;
  if (model.support->from == spatial::SupportBase::ground) return from_base;
  const spatial::Fuselage& fuselage = model.support->fuselage;
  return fuselage.position + space::exponential(fuselage.attitude).axes * from_base;
}

}  // namespace

bool has_changing_wind(const Scenario& scenario) {
  if (!scenario.space || !scenario.space->air) return false;
  const Wind& wind = scenario.space->air->wind;
  Wind uniform;
  uniform.velocity = wind.velocity;
  return !(wind == uniform);
}

Scenario in_mean_wind(const Scenario& scenario, Instant instant) {
  assert(has_changing_wind(scenario));
  Wind wind = scenario.space->air->wind;
  if (wind.speed && instant == Instant::end) wind.speed = Curve(wind.speed->values().back());
  if (wind.gust || wind.turbulence) {  // the mean has neither, and turbulence takes long to make
    wind.gust.reset();
    wind.turbulence.reset();
    wind.kept.reset();
  }
  Scenario calm = scenario;
  calm.space->air->wind = Wind{};
  calm.space->air->wind.velocity = make_wind(wind)->mean(find_hub(*scenario.space));
  return calm;
}

}  // namespace spoke::steady
