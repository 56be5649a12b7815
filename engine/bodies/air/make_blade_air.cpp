// Makes the constants of the air on a blade, and sums up its loads.

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/bodies/air/blade_air.h"
#include "models/air/blade_polars.h"

namespace spoke::air {

BladeAir::BladeAir(const spatial::BladeAerodynamics& blade, const spatial::Air& air, int blades,
                   double hub_radius, std::vector<double> stations, Polars polars)
    : places_(std::move(stations)),
      density_(air.density),
      viscosity_(air.viscosity),
      sound_speed_(air.sound_speed),
      radius_(hub_radius + std::max(blade.station.back(), places_.back())),
      blades_(blades),
      inflow_factor_(air.inflow_factor),
      high_thrust_(air.high_thrust),
      mass_flow_(air.mass_flow),
      side_(blade.leads_backward ? -1.0 : 1.0),
      induces_(air.induction == spatial::Induction::momentum),
      lags_inflow_(air.inflow == spatial::Inflow::dynamic),
      lags_attached_(air.attached_flow == spatial::AttachedFlow::unsteady),
      lags_stall_(air.stall == spatial::Stall::dynamic) {
  constexpr double none = std::numeric_limits<double>::infinity();
  assert(polars.size() == places_.size());
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const double at = places_[i];
    const StationPlace place(blade.station, at);
    const double radius = hub_radius + at, twist = place.value(blade.twist);
    const double tip = radius > 0.0 ? 0.5 * blades * (radius_ - radius) / radius : none;
    const double root = hub_radius > 0.0 ? 0.5 * blades * at / hub_radius : none;
    stations_.push_back({.chord = place.value(blade.chord),
                         .center = place.value(blade.center),
                         .sine = std::sin(twist),
                         .cosine = std::cos(twist),
                         .tip = std::max(tip, 0.0),
                         .root = std::max(root, 0.0),
                         .span_ratio = std::clamp(radius / radius_, 0.0, 1.0),
                         .polar = std::move(polars[i])});
  }
}

BladeAir::BladeAir(const spatial::BladeAerodynamics& blade, const spatial::Air& air, int blades,
                   double hub_radius, const std::vector<double>& stations)
    : BladeAir(blade, air, blades, hub_radius, stations, make_polars(blade, air, stations)) {}

// Integrals of what is linear between stations, as the loads are.

double BladeAir::thrust(std::span<const StationAir> seen) const noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < seen.size(); ++i)
    sum += 0.5 * (places_[i + 1] - places_[i]) * (seen[i].axial_force + seen[i + 1].axial_force);
  return sum;
}

double BladeAir::torque(std::span<const StationAir> seen) const noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < seen.size(); ++i) {
    const StationAir &a = seen[i], &b = seen[i + 1];
    const double inner = a.radius * (2.0 * a.tangential_force + b.tangential_force);
    const double outer = b.radius * (a.tangential_force + 2.0 * b.tangential_force);
    const double moment = 3.0 * (a.axial_moment + b.axial_moment);
    sum += (places_[i + 1] - places_[i]) / 6.0 * (inner + outer + moment);
  }
  return sum;
}

}  // namespace spoke::air
