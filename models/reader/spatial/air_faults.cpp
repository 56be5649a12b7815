// Rules for polars, the aerodynamics of blades, and air.

#include <algorithm>
#include <functional>
#include <string_view>
#include <vector>

#include "models/air/airfoil_check.h"
#include "models/air/section_polar.h"
#include "models/reader/keys/air_keys.h"
#include "models/reader/spatial/fault.h"
#include "models/reader/spatial/wind_reader.h"
#include "models/support/nearest_name.h"

namespace spoke::spatial {
namespace {

std::string count_values(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " value" : " values");
}

/// Finds an array that is not as long as another, `over`.
Fault find_count_fault(std::string_view key, std::size_t count, std::size_t expected,
                       const char* over) {
  if (count == expected) return {};
  return {std::string(key), "has " + count_values(count) + ", expected " +
                                std::to_string(expected) + ", one for each " + over};
}

Fault find_order_fault(const char* key, const std::vector<double>& values) {
  const auto at = std::adjacent_find(values.begin(), values.end(), std::greater_equal<>());
  if (at == values.end()) return {};
  return {key + ('.' + std::to_string(at - values.begin() + 2)),
          "is " + describe(at[1]) + " after " + describe(at[0]) + ", expected a greater number"};
}

/// Finds what only beams of a support do to the wind of blades.
Fault find_tower_fault(const BodyDrag& drag) {
  constexpr const char* kOfSupports = "would be ignored, expected only of a beam of a support";
  if (drag.potential != TowerPotential::none) return {"potential", kOfSupports};
  if (drag.shadow != TowerShadow::none) return {"shadow", kOfSupports};
  return {};
}

/// Finds neighbouring stations between whose aerofoils there is no way: one with polars by Reynolds
/// number, one by Mach number.
Fault find_choice_fault(const BladeAerodynamics& blade, const Air& air) {
  using spoke::air::ChosenBy;
  const auto choice_at = [&](std::size_t k) {
    const auto found =
        std::find_if(air.airfoils.begin(), air.airfoils.end(),
                     [&](const Airfoil& airfoil) { return airfoil.name == blade.airfoil[k]; });
    return found == air.airfoils.end() ? ChosenBy::nothing : spoke::air::find_choice(*found);
  };
  for (std::size_t k = 1; k < blade.airfoil.size(); ++k) {
    const ChosenBy before = choice_at(k - 1), here = choice_at(k);
    if (before == here || before == ChosenBy::nothing || here == ChosenBy::nothing) continue;
    return {"airfoil." + std::to_string(k + 1),
            "is \"" + blade.airfoil[k] + "\" with polars by " +
                (here == ChosenBy::mach ? "Mach" : "Reynolds") +
                " number, expected such as of the station before: between them there is no way"};
  }
  return {};
}

}  // namespace

Fault find_fault(const Airfoil& airfoil) {
  const FirstFault first;
  if (airfoil.name.empty()) first.add({"name", "is missing, expected a name"});
  if (airfoil.polars.empty()) first.add({"polar", "is missing, expected one or more"});
  for (std::size_t k = 0; k < airfoil.polars.size(); ++k) {
    const std::string key = "polar." + std::to_string(k + 1);
    if (const auto fault = spoke::air::find_polar_fault(airfoil.polars[k]))
      first.add(
          {key + '.' + fault->column + (fault->row < 0 ? "" : '.' + std::to_string(fault->row + 1)),
           fault->is});
    if (const std::string fault = spoke::air::find_mach_fault(airfoil.polars, k); !fault.empty())
      first.add({key + ".mach", fault});
    if (airfoil.polars[k].mach) continue;
    if (airfoil.polars.size() > 1 && airfoil.polars[k].reynolds <= 0.0)
      first.add({key + ".reynolds", "is missing, expected one, as there are several polars"});
    if (k > 0 && airfoil.polars[k].reynolds <= airfoil.polars[k - 1].reynolds)
      first.add({key + ".reynolds", "is " + describe(airfoil.polars[k].reynolds) +
                                        ", expected more than that of the polar before"});
  }
  return first.found();
}

Fault find_fault(const BladeAerodynamics& aerodynamics, double length) {
  const FirstFault first;
  const std::vector<double>& station = aerodynamics.station;
  first.numbers("station", station, kStation);
  if (station.size() < 2)
    first.add({"station", "has " + count_values(station.size()) + ", expected 2 or more"});
  first.add(find_order_fault("station", station));
  if (!first.found() && station.back() > length)
    first.add({"station." + std::to_string(station.size()),
               "is " + describe(station.back()) + ", expected at most the blade's length, " +
                   describe(length) + " (m)"});
  if (aerodynamics.chord.empty())
    first.add({"chord", "is missing, expected one number for each station"});
  visit_stations(aerodynamics, [&](std::string_view key, const std::vector<double>& values,
                                   const Quantity& quantity) {
    first.numbers(key, values, quantity);
    if (!values.empty()) first.add(find_count_fault(key, values.size(), station.size(), "station"));
  });
  first.add(find_count_fault("airfoil", aerodynamics.airfoil.size(), station.size(), "station"));
  return first.found();
}

Fault find_fault(const Air& air, const Model& model) {
  const FirstFault first;
  find_range_faults("air.", keys::kAirRows, air, first);
  find_range_faults("aerodynamics.", keys::kAerodynamicsRows, air, first);
  first.add(find_fault(air.wind).within("wind"));
  std::vector<std::string_view> names;
  for (std::size_t k = 0; k < air.airfoils.size(); ++k) {
    const std::string key = "airfoil." + std::to_string(k + 1);
    first.add(find_fault(air.airfoils[k]).within(key));
    if (std::find(names.begin(), names.end(), air.airfoils[k].name) != names.end())
      first.add({key + ".name",
                 "is \"" + air.airfoils[k].name + "\" as another aerofoil's, expected its own"});
    names.push_back(air.airfoils[k].name);
  }
  bool acts = false;
  for (std::size_t i = 0; i < model.blades.size(); ++i) {
    if (!model.blades[i].aerodynamics) continue;
    acts = true;
    const BladeAerodynamics& own = *model.blades[i].aerodynamics;
    const std::string key = "blades." + std::to_string(i + 1) + ".aerodynamics";
    first.add(find_fault(own, model.blades[i].beam.length).within(key));
    first.add(find_choice_fault(own, air).within(key));
    for (std::size_t k = 0; k < own.airfoil.size(); ++k)
      if (std::find(names.begin(), names.end(), own.airfoil[k]) == names.end())
        first.add(
            {key + ".airfoil." + std::to_string(k + 1), describe_unknown(own.airfoil[k], names)});
  }
  for (std::size_t i = 0; i < model.subsystems.size(); ++i)
    for (std::size_t k = 0; k < model.subsystems[i].bodies.size(); ++k)
      if (const auto& drag = model.subsystems[i].bodies[k].drag) {
        acts = true;
        if (model.subsystems[i].name != kSupportName)
          first.add(find_tower_fault(*drag).within("subsystem." + std::to_string(i + 1) + ".body." +
                                                   std::to_string(k + 1) + ".drag"));
      }
  if (!acts)
    first.add({"air",
               "acts on no blade, expected [blade.aerodynamics] of one or more, or drag of a "
               "body"});
  return first.found();
}

}  // namespace spoke::spatial
