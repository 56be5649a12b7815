// Finds the aerofoils of places, and blends them.

#include "models/air/blade_polars.h"

#include <algorithm>
#include <string>

#include "models/air/airfoil_check.h"
#include "models/error.h"

namespace spoke::air {
namespace {

const spatial::Airfoil& find_airfoil(const spatial::Air& air, const std::string& name) {
  const auto found =
      std::find_if(air.airfoils.begin(), air.airfoils.end(),
                   [&](const spatial::Airfoil& airfoil) { return airfoil.name == name; });
  if (found == air.airfoils.end())
    throw InputError("aerofoil \"" + name + "\" is none of those given");
  check_airfoil(*found);
  return *found;
}

}  // namespace

StationPlace::StationPlace(const std::vector<double>& stations, double at) {
  const auto above = static_cast<std::size_t>(
      std::upper_bound(stations.begin(), stations.end(), at) - stations.begin());
  outer = std::clamp<std::size_t>(above, 1, stations.size() - 1);
  inner = outer - 1;
  share = std::clamp((at - stations[inner]) / (stations[outer] - stations[inner]), 0.0, 1.0);
}

std::vector<std::shared_ptr<const SectionPolar>> make_polars(
    const spatial::BladeAerodynamics& blade, const spatial::Air& air,
    std::span<const double> places) {
  std::vector<std::shared_ptr<const SectionPolar>> made;
  for (const double at : places) {
    const StationPlace place(blade.station, at);
    made.push_back(std::make_shared<const SectionPolar>(
        find_airfoil(air, blade.airfoil[place.inner]),
        find_airfoil(air, blade.airfoil[place.outer]), place.share));
  }
  return made;
}

}  // namespace spoke::air
