// Writes what wind_reader.cpp reads.

#include "models/reader/spatial/wind_json.h"

#include <filesystem>

#include "models/air/wind_keys.h"
#include "models/reader/row_reader.h"
#include "models/reader/spatial/joint_json.h"

namespace spoke::spatial {
namespace {

Json to_json(const std::vector<WindGust>& gusts) {
  Json json = Json::array();
  for (const WindGust& gust : gusts) {
    Json table = Json::object();
    keys::write(keys::kGustRows, &gust, table);
    json.push_back(std::move(table));
  }
  return json;
}

Json to_json(const WindTurbulence& turbulence) {
  Json json = Json::object();
  keys::write_numbers(keys::kTurbulenceRows, &turbulence, json);
  keys::write_words(keys::kTurbulenceRows, &turbulence, json);
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
  if (wind.vertical_shear != 0.0) json.set("vertical_shear", wind.vertical_shear);
  if (wind.horizontal_shear != 0.0) json.set("horizontal_shear", wind.horizontal_shear);
  if (wind.reference_height) json.set("reference_height", *wind.reference_height);
  json.set("up", spatial::to_json(wind.up));
  json.set("ground", wind.ground);
  if (!wind.gusts.empty()) json.set("gust", to_json(wind.gusts));
  if (wind.turbulence) json.set("turbulence", to_json(*wind.turbulence));
  return json;
}

}  // namespace spoke::spatial
