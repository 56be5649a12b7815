// Tables of air in the order of docs/scenario.md.

#include "program/foreign/air_writer.h"

#include <algorithm>

#include "program/foreign/control_writer.h"

namespace spoke::foreign {
namespace {

bool all_zero(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return value == 0.0; });
}

void write_value(const char* key, const Value& value, Toml& toml) {
  if (value.number > 0.0)
    toml.key(key, digits(value.number), value.from);
  else if (!value.from.empty())
    toml.comment(std::string(key) + " is the scenario's default: " + value.from);
}

/// The wind that the files have.
void write_found_wind(const FoundAir& air, const ScenarioPlaces* files, const WindPlace& place,
                      Toml& toml) {
  const FoundWind& wind = *air.wind;
  toml.table("[wind]");
  toml.key("velocity", digits(wind.velocity), wind.velocity_from + " (m/s)");
  const bool has_table = !wind.table.empty();
  if (files && has_table) toml.key("file", quoted(files->wind), wind.from);
  if (files && !wind.file.empty())
    toml.key("file", quoted(path_from(files->folder, wind.file)), wind.from);
  if (air.shear.number > 0.0) toml.key("shear_exponent", digits(air.shear.number), air.shear.from);
  if (wind.vertical_shear != 0.0)
    toml.key("vertical_shear", digits(wind.vertical_shear), "by RefLength (1/m)");
  if (wind.horizontal_shear != 0.0)
    toml.key("horizontal_shear", digits(wind.horizontal_shear), "by RefLength (1/m)");
  if (wind.has_profile)
    toml.key("reference_height", digits(air.reference_height.number), air.reference_height.from);
  if (!place.ground.from.empty())
    toml.key("ground", digits(place.ground.number), place.ground.from);
}

void write_still_air(const FoundAir& air, const WindPlace& place, Toml& toml) {
  if (!place.ground.from.empty()) {
    toml.table("[wind]");
    toml.key("velocity", "[0, 0, 0]",
             "at rest: the files have no wind; " + place.downwind + " is downwind (m/s)");
    toml.key("ground", digits(place.ground.number), place.ground.from);
  } else {
    toml.comment("The air is at rest: the files have no wind. For example:");
    toml.comment("[wind]");
    toml.comment("velocity = " + place.downwind + "   # m/s, downwind");
  }
  if (air.shear.number > 0.0)
    toml.comment("shear_exponent = " + digits(air.shear.number) + "   # " + air.shear.from);
  if (air.reference_height.number > 0.0)
    toml.comment("reference_height = " + digits(air.reference_height.number) + "   # " +
                 air.reference_height.from + "; heights are along z, from the origin");
}

void write_polars(const spatial::Airfoil& airfoil, Toml& toml) {
  for (const spatial::Polar& polar : airfoil.polars) {
    if (airfoil.polars.size() > 1) {
      toml.table("[[airfoil.polar]]");
      toml.key("reynolds", digits(polar.reynolds));
    }
    toml.numbers("angle", polar.angle);
    toml.numbers("lift", polar.lift);
    toml.numbers("drag", polar.drag);
    toml.numbers("moment", polar.moment);
  }
}

}  // namespace

std::string airfoil_path(const std::string& folder, const std::string& name) {
  return folder + '/' + name + ".txt";
}

void write_tower_air(const FoundTowerAir& tower, Toml& toml) {
  toml.table("[support.body.drag]");
  toml.comment("station is " + tower.from);
  toml.numbers("station", tower.station);
  toml.numbers("diameter", tower.diameter);
  toml.numbers("coefficient", tower.coefficient);
  toml.key("potential", quoted(std::string(tower.potential.word)), tower.potential.from);
  toml.key("shadow", quoted(std::string(tower.shadow.word)), tower.shadow.from);
}

void write_blade_air(const FoundAir& air, Toml& toml) {
  toml.table("[blade.aerodynamics]");
  for (const std::string& remark : air.remarks) toml.comment(remark);
  std::vector<std::string> stations, names;
  for (const double x : air.blade.station) stations.push_back(digits(x));
  for (const std::string& name : air.blade.airfoil) names.push_back(quoted(name));
  toml.lines("station", stations, air.station_from);
  toml.numbers("chord", air.blade.chord);
  if (!all_zero(air.blade.twist)) toml.numbers("twist", air.blade.twist);
  if (!all_zero(air.blade.center)) toml.numbers("center", air.blade.center);
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  toml.key("airfoil", '[' + list + ']');
}

void write_air(const FoundAir& air, const ScenarioPlaces* files, const WindPlace& place,
               Toml& toml) {
  toml.table("[air]");
  write_value("density", air.density, toml);
  write_value("viscosity", air.viscosity, toml);
  toml.table("[aerodynamics]");
  const auto write = [&](const char* key, const FoundChoice& choice) {
    toml.key(key, quoted(std::string(choice.word)), choice.from);
  };
  write("induction", air.induction);
  write("inflow", air.inflow);
  write("stall", air.stall);
  if (air.wind)
    write_found_wind(air, files, place, toml);
  else
    write_still_air(air, place, toml);
  for (const FoundAirfoil& found : air.airfoils) {
    toml.table("[[airfoil]]");
    toml.key("name", quoted(found.airfoil.name));
    if (!files)
      write_polars(found.airfoil, toml);
    else
      toml.key("file", quoted(airfoil_path(files->airfoils, found.airfoil.name)), found.from);
  }
}

}  // namespace spoke::foreign
