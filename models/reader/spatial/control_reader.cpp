// Reads the keys of a pitch controller, and leaves what they mean to control_faults.cpp.

#include "models/reader/spatial/control_reader.h"

#include "models/reader/curve_reader.h"
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
  if (!section.has("joints"))
    section.fail("joint", "is missing, expected the name of the joint that it moves on each blade");
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

}  // namespace

std::optional<PitchControl> read_pitch_control(const TomlSection& root, const Model& model) {
  if (!root.has("control")) return std::nullopt;
  const TomlSection parent = root.section("control", keys::keys_of(keys::kControlRows));
  if (!parent.has("pitch")) return std::nullopt;  // so an override can take a controller away
  const TomlSection section = parent.section("pitch", keys::keys_of(keys::kPitchControlRows));
  PitchControl control;
  control.joints = read_controlled_joints(section);
  keys::read(section, keys::kPitchControlRows, &control);
  read_schedule(section, control);
  control.initial = section.number("initial", kAngle, control.minimum);
  control.sign = section.integer("sign", Count{-1, 1}, 1);
  if (const Fault fault = find_fault(control, model)) {
    const bool is_of_joint = fault.path == "joints.1" && section.has("joint");
    section.fail_at(is_of_joint ? "joint" : fault.path, fault.text);
  }
  return control;
}

}  // namespace spoke::spatial
