// Writes polars into the scenario, so that it stands alone.

#include "models/reader/spatial/air_json.h"

#include <string>
#include <utility>

#include "models/reader/keys/air_keys.h"
#include "models/reader/row_reader.h"
#include "models/reader/spatial/spatial_fields.h"
#include "models/reader/spatial/wind_json.h"

namespace spoke::spatial {
namespace {

Json to_json(const Polar& polar) {
  Json json;
  if (polar.reynolds > 0.0) json.set("reynolds", polar.reynolds);
  if (polar.mach) json.set("mach", *polar.mach);
  json.set("angle", polar.angle);
  json.set("lift", polar.lift);
  json.set("drag", polar.drag);
  if (!polar.moment.empty()) json.set("moment", polar.moment);
  return json;
}

}  // namespace

Json aerodynamics_to_json(const BladeAerodynamics& aerodynamics) {
  Json json = {{"station", aerodynamics.station}};
  visit_stations(aerodynamics,
                 [&](std::string_view key, const std::vector<double>& values, const Quantity&) {
                   if (!values.empty()) json.set(std::string(key), values);
                 });
  Json names = Json::array();
  for (const std::string& name : aerodynamics.airfoil) names.push_back(name);
  json.set("airfoil", std::move(names));
  json.set("leading_edge", aerodynamics.leads_backward ? "-y" : "+y");
  return json;
}

void add_air(const Air& air, Json& json) {
  Json medium;
  keys::write(keys::kAirRows, &air, medium);
  json.set("air", std::move(medium));
  json.set("wind", wind_to_json(air.wind));
  Json aerodynamics;
  keys::write_words(keys::kAerodynamicsRows, &air, aerodynamics);
  keys::write_numbers(keys::kAerodynamicsRows, &air, aerodynamics);
  json.set("aerodynamics", std::move(aerodynamics));
  for (const Airfoil& airfoil : air.airfoils) {
    Json table = {{"name", airfoil.name}};
    for (const Polar& polar : airfoil.polars) table.append("polar", to_json(polar));
    json.append("airfoil", table);
  }
}

}  // namespace spoke::spatial
