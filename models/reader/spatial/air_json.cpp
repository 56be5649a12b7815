// Writes polars into the scenario, so that it stands alone.

#include "models/reader/spatial/air_json.h"

#include <string>
#include <utility>

#include "models/reader/spatial/field_writer.h"
#include "models/reader/spatial/wind_json.h"

namespace spoke::spatial {
namespace {

Json to_json(const Polar& polar) {
  Json json;
  if (polar.reynolds > 0.0) json.set("reynolds", polar.reynolds);
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
  visit_fields(air, FieldWriter{medium});
  json.set("air", std::move(medium));
  json.set("wind", wind_to_json(air.wind));
  Json aerodynamics = {{"induction", name_of(air.induction)},
                       {"inflow", name_of(air.inflow)},
                       {"stall", name_of(air.stall)}};
  visit_inflow(air, FieldWriter{aerodynamics});
  json.set("aerodynamics", std::move(aerodynamics));
  for (const Airfoil& airfoil : air.airfoils) {
    Json table = {{"name", airfoil.name}};
    for (const Polar& polar : airfoil.polars) table.append("polar", to_json(polar));
    json.append("airfoil", table);
  }
}

}  // namespace spoke::spatial
