// Reads the keys of controllers, and leaves what they mean to control_faults.cpp.

#include "models/reader/spatial/control_reader.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

#include "models/reader/curve_reader.h"
#include "models/reader/keys/turbine_keys.h"
#include "models/reader/row_reader.h"
#include "models/reader/spatial/fault.h"
#include "models/reader/spatial/spatial_fields.h"
#include "models/reader/toml_value.h"

namespace spoke::spatial {
namespace {

/// Reads `joint`, a name, or `joints`, an array of names.
std::vector<std::string> read_controlled_joints(const TomlSection& section) {
  if (section.has("joint") && section.has("joints"))
    section.fail("joints", "given along with joint, expected only one of them");
  if (section.has("joint")) return {section.text("joint", "")};
  if (!section.has("joints")) return {};
  std::vector<std::string> names;
  for (const TomlValue& value : section.values("joints")) {
    if (!value.as_text()) section.fail_expected("joints", "an array of names of joints");
    names.push_back(*value.as_text());
  }
  return names;
}

void read_schedule(const TomlSection& section, PitchControl& control) {
  if (!section.has("schedule")) return;
  if (section.has("half_gain_angle"))
    section.fail("schedule", "given along with half_gain_angle, expected only one of them");
  const TomlSection table = section.section("schedule", keys::keys_of(keys::kScheduleRows));
  control.schedule = read_curve(table, "angle", kAngle, "factor", Quantity::positive(""));
}

/// Throws the fault of a controller at its key: `joint` where that stands in place of `joints`.
void require(const TomlSection& section, const Fault& fault) {
  if (!fault) return;
  const bool is_of_joint = fault.path == "joints.1" && section.has("joint");
  section.fail_at(is_of_joint ? "joint" : fault.path, fault.text);
}

PitchControl read_pitch(const TomlSection& section, const Model& model) {
  PitchControl control;
  control.joints = read_controlled_joints(section);
  if (control.joints.empty())
    section.fail("joint", "is missing, expected the name of the joint that it moves on each blade");
  keys::read(section, keys::kPitchControlRows, &control);
  read_schedule(section, control);
  control.initial = section.number("initial", kAngle, control.minimum);
  control.sign = section.integer("sign", Count{-1, 1}, 1);
  require(section, find_fault(control, model));
  return control;
}

/// Reads the path of a file, which must be there.
std::string read_path(const TomlSection& section, std::string_view key, const std::string& folder,
                      const std::string& expected) {
  const std::string name = section.text(key, "");
  const std::filesystem::path file = std::filesystem::path(folder) / name;
  std::error_code ignored;
  if (name.empty() || !std::filesystem::is_regular_file(file, ignored))
    section.fail(key, "is \"" + name + "\", but there is no file " + file.string() + ", expected " +
                          expected);
  return file.string();
}

void read_library(const TomlSection& section, const std::string& folder, OuterControl& control) {
  constexpr const char* kExpected = "a shared library with the function DISCON";
  if (!section.has("file")) section.fail("file", std::string("is missing, expected ") + kExpected);
  control.file = read_path(section, "file", folder, kExpected);
  if (section.has("input"))
    control.input = read_path(section, "input", folder, "the file that the library reads");
  control.name =
      section.text("name", std::filesystem::path(control.file).replace_extension().string());
  keys::read(section, keys::kLibraryRows, &control);
  for (const TomlSection& of :
       section.sections("record", keys::keys_of(keys::kLibraryRecordRows))) {
    LibraryRecord& record = control.records.emplace_back();
    record.number = of.integer("number", keys::kRecordNumbers);
    keys::read(of, keys::kLibraryRecordRows, &record);
    if (!of.has("sensor")) of.fail("sensor", "is missing, expected the name of a sensor");
    record.sensor = of.text("sensor", "");
  }
}

/// Reads the tables of laws; none: there are none.
std::optional<TurbineLaws> read_laws(const TomlSection& section) {
  TurbineLaws laws;
  bool is_any = false;
  keys::visit_laws(laws, [&](std::string_view key, keys::Rows rows, auto& part) {
    if (!section.has(key)) return;
    const TomlSection table = section.section(key, keys::keys_of(rows));
    auto& made = part.emplace();
    keys::read(table, rows, &made);
    keys::visit_stations(
        rows, made, [&](std::string_view name, std::vector<double>& values, const Quantity& range) {
          if (!table.has(name)) return;
          if (table.is_array(name))
            values = table.numbers(name, range);
          else
            values = {table.number(name, range)};
        });
    is_any = true;
  });
  if (!is_any) return std::nullopt;
  return laws;
}

OuterControl read_outer(const TomlSection& section, const std::string& folder,
                        std::string_view table, const Model& model) {
  OuterControl control;
  if (table == "turbine") control.laws = read_laws(section);
  control.has_controller = table != "turbine" || control.laws;
  if (table == "library") read_library(section, folder, control);
  control.joints = read_controlled_joints(section);
  keys::read(section, keys::kOuterControlRows, &control);
  control.sign = section.integer("sign", Count{-1, 1}, 1);
  control.direction = section.integer("direction", Count{-1, 1}, 1);
  control.yaw_joint = section.text("yaw_joint", "");
  require(section, find_fault(control, model));
  return control;
}

}  // namespace

void read_control(const TomlSection& root, const std::string& folder, Model& model) {
  if (!root.has("control")) return;
  const TomlSection parent = root.section("control", keys::keys_of(keys::kControlRows));
  // An empty table is none, so that an override can take a controller away.
  std::string_view first;
  for (const std::string_view key : {"pitch", "library", "program", "turbine"}) {
    if (!parent.has(key)) continue;
    if (!first.empty())
      parent.fail(key, "given along with " + std::string(first) + ", expected only one of them");
    first = key;
  }
  if (first == "pitch")
    model.pitch_control =
        read_pitch(parent.section("pitch", keys::keys_of(keys::kPitchControlRows)), model);
  if (first == "library")
    model.outer_control = read_outer(
        parent.section("library", keys::keys_of(keys::kLibraryRows, keys::kOuterControlRows)),
        folder, first, model);
  if (first == "program")
    model.outer_control = read_outer(parent.section(first, keys::keys_of(keys::kOuterControlRows)),
                                     folder, first, model);
  if (first == "turbine")
    model.outer_control =
        read_outer(parent.section(first, keys::keys_of(keys::kOuterControlRows, keys::kLawRows)),
                   folder, first, model);
}

}  // namespace spoke::spatial
