// Writes what wind_reader.cpp reads.

#include "models/reader/spatial/wind_json.h"

#include <filesystem>

#include "models/air/wind_rules.h"
#include "models/reader/spatial/joint_json.h"

namespace spoke::spatial {
namespace {

/// Writes the numbers that wind_rules.h lists.
template <class Table>
Json numbers_to_json(const Table& table) {
  Json json = Json::object();
  air::visit_fields(table, [&](std::string_view key, const auto& value, const auto&, air::Given) {
    json.set(key, value);
  });
  return json;
}

Json to_json(const WindGust& gust) {
  Json json = numbers_to_json(gust);
  json.set("shape", name_of(gust.shape));
  return json;
}

Json to_json(const WindTurbulence& turbulence) {
  Json json = numbers_to_json(turbulence);
  json.set("spectrum", name_of(turbulence.spectrum));
  json.set("coherence", name_of(turbulence.coherence));
  if (turbulence.length_scale) json.set("length_scale", *turbulence.length_scale);
  const auto& ratios = turbulence.deviation_ratio;
  json.set("deviation_ratio", Json::array({ratios[0], ratios[1], ratios[2]}));
  if (turbulence.height) json.set("height", *turbulence.height);
  json.set("points", Json::array({turbulence.points[0], turbulence.points[1]}));
  return json;
}

}  // namespace

Json wind_to_json(const Wind& wind) {
  if (wind.by_program || wind.field) return {{"by", "program"}};
  Json json = {{"velocity", spatial::to_json(wind.velocity)}};
  if (wind.speed) {
    json.set("time", wind.speed->times());
    json.set("speed", wind.speed->values());
  }
  if (!wind.file.empty()) {
    std::error_code error;
    const std::filesystem::path file = std::filesystem::absolute(wind.file, error);
    json.set("file", error ? wind.file : file.lexically_normal().string());
  }
  json.set("shear_exponent", wind.shear_exponent);
  if (wind.reference_height) json.set("reference_height", *wind.reference_height);
  json.set("up", spatial::to_json(wind.up));
  json.set("ground", wind.ground);
  if (wind.gust) json.set("gust", to_json(*wind.gust));
  if (wind.turbulence) json.set("turbulence", to_json(*wind.turbulence));
  return json;
}

}  // namespace spoke::spatial
