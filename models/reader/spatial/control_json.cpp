// Writes the keys that control_reader.cpp reads.

#include "models/reader/spatial/control_json.h"

#include <filesystem>
#include <string>
#include <system_error>
#include <utility>

#include "models/reader/keys/control_keys.h"
#include "models/reader/keys/turbine_keys.h"
#include "models/reader/row_reader.h"
#include "models/reader/spatial/spatial_fields.h"

namespace spoke::spatial {
namespace {

/// Returns a path that holds wherever the scenario is written.
std::string absolute(const std::string& file) {
  std::error_code error;
  const std::filesystem::path path = std::filesystem::absolute(file, error);
  return error ? file : path.lexically_normal().string();
}

/// Returns the table of one part of a turbine's laws.
template <class Part>
Json part_to_json(keys::Rows rows, const Part& part) {
  Json json = Json::object();
  keys::write(rows, &part, json);
  keys::visit_stations(
      rows, part, [&](std::string_view key, const std::vector<double>& values, const Quantity&) {
        if (!values.empty()) json.set(key, values);
      });
  return json;
}

}  // namespace

Json control_to_json(const PitchControl& control) {
  Json json;
  for (const std::string& name : control.joints) json.append("joints", name);
  keys::write_numbers(keys::kPitchControlRows, &control, json);
  keys::visit_options(
      keys::kPitchControlRows, control,
      [&](std::string_view key, const std::optional<double>& value, const Quantity&) {
        if (value) json.set(key, *value);
      });
  if (control.schedule)
    json.set("schedule",
             {{"angle", control.schedule->times()}, {"factor", control.schedule->values()}});
  json.set("initial", control.initial);
  json.set("sign", static_cast<int>(control.sign));
  return json;
}

Json control_to_json(const OuterControl& control) {
  Json json;
  const auto write = [&](keys::Rows rows) {
    keys::write_numbers(rows, &control, json);
    keys::visit_options(
        rows, control,
        [&](std::string_view key, const std::optional<double>& value, const Quantity&) {
          if (value) json.set(key, *value);
        });
  };
  if (control.is_library()) {
    json.set("file", absolute(control.file));
    if (!control.input.empty()) json.set("input", absolute(control.input));
    json.set("name", control.name);
    json.set("individual_pitch", control.individual_pitch);
    write(keys::kLibraryRows);
    for (const LibraryRecord& record : control.records) {
      Json made;
      made.set("number", record.number);
      made.set("sensor", record.sensor);
      keys::write(keys::kLibraryRecordRows, &record, made);
      json.append("record", std::move(made));
    }
  }
  for (const std::string& name : control.joints) json.append("joints", name);
  write(keys::kOuterControlRows);
  if (control.laws)
    keys::visit_laws(*control.laws, [&](std::string_view key, keys::Rows rows, const auto& part) {
      if (part) json.set(key, part_to_json(rows, *part));
    });
  json.set("sign", static_cast<int>(control.sign));
  if (!control.yaw_joint.empty()) json.set("yaw_joint", control.yaw_joint);
  json.set("direction", static_cast<int>(control.direction));
  return json;
}

}  // namespace spoke::spatial
