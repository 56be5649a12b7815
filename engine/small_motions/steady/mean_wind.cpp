// Asks for the wind at the hub.

#include "engine/small_motions/steady/mean_wind.h"

#include <cassert>

#include "models/tree/hub_place.h"

namespace spoke::steady {

bool has_changing_wind(const Scenario& scenario) {
  if (!scenario.space || !scenario.space->air) return false;
  const Wind& wind = scenario.space->air->wind;
  Wind uniform;
  uniform.velocity = wind.velocity;
  return !(wind == uniform);
}

Scenario in_mean_wind(const Scenario& scenario, Instant instant, WindPlaces places, int rotor) {
  assert(has_changing_wind(scenario));
  Wind wind = scenario.space->air->wind;
  if (wind.speed && instant == Instant::end) wind.speed = Curve(wind.speed->values().back());
  if (!wind.gusts.empty() || wind.turbulence) {  // the mean has neither, and a box takes long
    wind.gusts.clear();
    wind.turbulence.reset();
    wind.kept.reset();
  }
  Scenario calm = scenario;
  calm.space->air->wind = Wind{};
  const auto field = make_wind(wind);
  calm.space->air->wind.velocity = field->mean(spatial::find_hub_place(*scenario.space, rotor));
  if (places == WindPlaces::all)
    calm.space->air->wind = {
        .by_program = true, .field = make_wind_field([field](const Eigen::Vector3d& place, double) {
                              return field->mean(place);
                            })};
  return calm;
}

}  // namespace spoke::steady
