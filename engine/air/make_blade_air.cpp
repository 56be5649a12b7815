// Makes the constants of the air on a blade, and sums up its loads.

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/air/blade_air.h"
#include "models/air/airfoil_check.h"
#include "models/error.h"

namespace spoke::air {
namespace {

using spatial::Air;
using spatial::Airfoil;
using spatial::BladeAerodynamics;

const Airfoil& find_airfoil(const Air& air, const std::string& name) {
  const auto found = std::find_if(air.airfoils.begin(), air.airfoils.end(),
                                  [&](const Airfoil& airfoil) { return airfoil.name == name; });
  if (found == air.airfoils.end())
    throw InputError("aerofoil \"" + name + "\" is none of those given");
  check_airfoil(*found);
  return *found;
}

/// A place between two stations of the aerodynamics.
struct Place {
  std::size_t inner, outer;
  double share;  // of the outer one

  Place(const std::vector<double>& stations, double at) {
    const auto above = static_cast<std::size_t>(
        std::upper_bound(stations.begin(), stations.end(), at) - stations.begin());
    outer = std::clamp<std::size_t>(above, 1, stations.size() - 1);
    inner = outer - 1;
    share = std::clamp((at - stations[inner]) / (stations[outer] - stations[inner]), 0.0, 1.0);
  }
  double value(const std::vector<double>& column) const {
    return column.empty() ? 0.0 : column[inner] + share * (column[outer] - column[inner]);
  }
};

}  // namespace

BladeAir::BladeAir(const BladeAerodynamics& blade, const Air& air, int blades, double hub_radius,
                   std::vector<double> stations)
    : places_(std::move(stations)),
      density_(air.density),
      viscosity_(air.viscosity),
      radius_(hub_radius + std::max(blade.station.back(), places_.back())),
      blades_(blades),
      inflow_factor_(air.inflow_factor),
      side_(blade.leads_backward ? -1.0 : 1.0),
      induces_(air.induction == spatial::Induction::momentum),
      lags_inflow_(air.inflow == spatial::Inflow::dynamic),
      lags_stall_(air.stall == spatial::Stall::dynamic) {
  constexpr double none = std::numeric_limits<double>::infinity();
  for (const double at : places_) {
    const Place place(blade.station, at);
    const double radius = hub_radius + at, twist = place.value(blade.twist);
    const double tip = radius > 0.0 ? 0.5 * blades * (radius_ - radius) / radius : none;
    const double root = hub_radius > 0.0 ? 0.5 * blades * at / hub_radius : none;
    stations_.push_back(
        {.chord = place.value(blade.chord),
         .center = place.value(blade.center),
         .sine = std::sin(twist),
         .cosine = std::cos(twist),
         .tip = std::max(tip, 0.0),
         .root = std::max(root, 0.0),
         .span_ratio = std::clamp(radius / radius_, 0.0, 1.0),
         .polar = SectionPolar(find_airfoil(air, blade.airfoil[place.inner]),
                               find_airfoil(air, blade.airfoil[place.outer]), place.share)});
  }
}

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
