// Reads blades: keys that a blade's table lacks are taken from the table of all blades.

#include <numbers>

#include "models/reader/loop_reader.h"
#include "models/reader/row_reader.h"
#include "models/reader/spatial/air_reader.h"
#include "models/reader/spatial/body_reader.h"
#include "models/reader/spatial/coupling_faults.h"
#include "models/reader/spatial/coupling_reader.h"
#include "models/reader/spatial/fault.h"
#include "models/reader/spatial/joint_reader.h"
#include "models/reader/spatial/section_reader.h"
#include "models/reader/spatial/spatial_fields.h"
#include "models/tree/axle_carrier.h"

namespace spoke::spatial {
namespace {

/// The table of a blade, and the table of all blades behind it.
class Layers {
 public:
  Layers(const TomlSection& own, const TomlSection& common) : own_(own), common_(common) {}

  /// Returns the table that has the key; the blade's own comes first.
  const TomlSection& of(std::string_view key) const {
    return !own_.has(key) && common_.has(key) ? common_ : own_;
  }

 private:
  const TomlSection& own_;
  const TomlSection& common_;
};

std::vector<BladeJoint> read_joints(const TomlSection& blade) {
  std::vector<BladeJoint> joints;
  for (const TomlSection& table :
       blade.sections("joint", keys::keys_of(keys::kJointRows, keys::kJointStationRows)))
    joints.push_back({table.number("station", kStation), read_joint(table)});
  return joints;
}

/// `rotors`: that it carries.
Blade read_blade(const TomlSection& own, const TomlSection& common, double azimuth, int rotor,
                 const Model& model, const std::vector<int>& rotors) {
  const Layers from(own, common);
  Blade blade;
  blade.rotor = rotor;
  Beam& beam = blade.beam;
  for (const keys::Row& row : keys::kBeamRows) keys::read_row(from.of(row.key), row, &beam);
  beam.sections = read_sections(from.of("sections"), beam.length);
  beam.point_masses = read_point_masses(from.of("point_mass"));
  blade.azimuth = azimuth;
  for (const keys::Row& row : keys::kSpaceBladeRows)
    keys::read_row(row.key == "azimuth" ? own : from.of(row.key), row, &blade);
  blade.joints = read_joints(from.of("joint"));
  if (const TomlSection& table = from.of("aerodynamics"); table.has("aerodynamics"))
    blade.aerodynamics =
        read_aerodynamics(table.section("aerodynamics", aerodynamics_keys()), beam.length);
  if (const Fault fault = find_fault(blade))
    from.of(fault.path.substr(0, fault.path.find('.'))).fail_at(fault.path, fault.text);
  blade.loops = read_loops(from.of("loop"), surroundings_of(blade, model));
  blade.couplings = read_couplings(from.of("coupling"));
  if (const Fault fault = find_fault(blade.couplings, ends_of(blade, rotors, model)))
    from.of("coupling").fail_at(fault.path, fault.text);
  return blade;
}

}  // namespace

std::vector<Blade> read_blades(const TomlSection& root, int rotor, const Model& model) {
  const TomlSection::Keys keys = keys::keys_of(keys::kBeamRows, keys::kSpaceBladeRows);
  const TomlSection::Keys common_keys =
      keys::keys_of(keys::kBeamRows, keys::kSpaceBladeRows, keys::kBladeCountRows);
  const TomlSection common = root.section("blade", common_keys);
  const std::vector<TomlSection> one_by_one = root.sections("blades", keys);
  const double first = common.number("azimuth", kAngle, 0.0);
  std::vector<Blade> blades;
  const auto rotors_on_next = [&model, &blades] {
    return find_rotors_on(model, name_of_blade(model.blades.size() + blades.size() + 1));
  };
  if (one_by_one.empty() && !root.has("blade")) return blades;
  const auto azimuth = [&](std::size_t i, std::size_t count) {
    return first + 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
  };
  if (one_by_one.empty()) {
    const auto count = static_cast<std::size_t>(common.integer("count", {1, kMostOfAKind}));
    // No rotor is on several blades, to which what is given belongs.
    const std::vector<int> rotors = count == 1 ? rotors_on_next() : std::vector<int>{};
    blades.assign(count, read_blade(common, common, first, rotor, model, rotors));
    for (std::size_t i = 0; i < count; ++i) blades[i].azimuth = azimuth(i, count);
    return blades;
  }
  if (common.has("count"))
    common.fail("count", "given along with [[blades]], expected only one of them");
  for (const TomlSection& own : one_by_one)
    blades.push_back(read_blade(own, common, azimuth(blades.size(), one_by_one.size()), rotor,
                                model, rotors_on_next()));
  return blades;
}

}  // namespace spoke::spatial
