// Tables in the order of docs/scenario.md.

#include "program/foreign/scenario_writer.h"

#include <algorithm>
#include <numbers>

#include "program/foreign/air_writer.h"
#include "program/foreign/control_writer.h"
#include "program/foreign/toml_text.h"

namespace spoke::foreign {
namespace {

/// Returns the upper triangle row by row, as scenarios take it.
std::string triangle(const SectionMatrix& matrix) {
  std::vector<double> entries;
  for (int r = 0; r < 6; ++r)
    for (int c = r; c < 6; ++c) entries.push_back(matrix(r, c));
  return digits(entries);
}

void write_matrices(const std::string& key, const std::vector<SectionMatrix>& matrices,
                    const std::vector<std::string>& from, Toml& toml) {
  if (matrices.empty()) return;
  std::vector<std::string> rows;
  for (const SectionMatrix& matrix : matrices) rows.push_back(triangle(matrix));
  toml.lines(key, rows, from);
}

bool is_zero(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return value == 0.0; });
}

void write_sections(const BeamTable& beam, Toml& toml) {
  std::vector<std::string> stations;
  for (const double x : beam.station) stations.push_back(digits(x));
  for (const std::string& remark : beam.remarks) toml.comment(remark);
  toml.lines("station", stations, beam.station_from);
  if (!is_zero(beam.sweep)) toml.numbers("sweep", beam.sweep);
  if (!is_zero(beam.prebend)) toml.numbers("prebend", beam.prebend);
  if (!is_zero(beam.twist)) toml.numbers("twist", beam.twist);
  toml.numbers("mass_per_length", beam.mass_per_length);
  toml.numbers("axial_stiffness", beam.axial_stiffness);
  toml.numbers("flap_stiffness", beam.flap_stiffness);
  toml.numbers("lag_stiffness", beam.lag_stiffness);
  toml.numbers("torsion_stiffness", beam.torsion_stiffness);
  toml.numbers("flap_inertia", beam.flap_inertia);
  toml.numbers("lag_inertia", beam.lag_inertia);
  if (beam.stiffness.empty()) return;
  toml.comment(
      "The axes of the files: x flapwise, y edgewise, z along the blade. Upper triangles.");
  toml.key("matrix_convention", "\"beamdyn\"");
  write_matrices("stiffness_6x6", beam.stiffness, beam.station_from, toml);
  write_matrices("mass_6x6", beam.mass, beam.station_from, toml);
}

void write_tip_mass(const BeamTable& beam, const std::string& head, Toml& toml) {
  if (!(beam.tip_mass.number > 0.0)) return;
  toml.table(head);
  toml.key("position", digits(beam.length.number));
  toml.key("mass", digits(beam.tip_mass.number), beam.tip_mass.from);
}

void write_blade(const FoundModel& model, Toml& toml) {
  const BeamTable& blade = *model.blade;
  toml.table("[blade]");
  toml.key("count", digits(model.blade_count.number),
           model.blade_count.from.empty() ? "the files are of one blade" : model.blade_count.from);
  toml.key("length", digits(blade.length.number), blade.length.from);
  // Blades of turbines are cut as those of the shipped one; single ones finer, for their modes.
  toml.key("bodies", model.tower ? "4" : "10", "not in the files");
  toml.key("elements", "4", "not in the files");
  if (model.precone.number != 0.0)
    toml.key("precone", digits(model.precone.number),
             model.precone.from + ", in rad towards downwind");
  if (model.azimuth.number != 0.0)
    toml.key("azimuth", digits(model.azimuth.number), model.azimuth.from + ", in rad");
  toml.table("[blade.sections]");
  write_sections(blade, toml);
  write_tip_mass(blade, "[[blade.point_mass]]", toml);
  if (model.has_pitch()) write_pitch(model, toml);
  if (model.air) write_blade_air(*model.air, toml);
}

void write_hub(const FoundModel& model, Toml& toml) {
  toml.table("[hub]");
  toml.key("support", "\"axle\"", "not in the files");
  if (model.has_rotor) toml.key("axis", "[1, 0, 0]", "downwind");
  if (!model.hub_radius.from.empty())
    toml.key("radius", digits(model.hub_radius.number), model.hub_radius.from);
  const bool carries = model.tower.has_value();
  if (model.hub_mass.number > 0.0)
    toml.key("mass", digits(model.hub_mass.number), model.hub_mass.from);
  else if (carries)
    toml.key("mass", "1", "not in the files: next to nothing; put rotor and nacelle here");
  if (model.hub_center != 0.0)
    toml.key("center", digits(Eigen::Vector3d(model.hub_center, 0.0, 0.0)), "HubCM");
  if (!model.hub_tensor.empty())
    toml.key("inertia", digits(model.hub_tensor), model.hub_inertia.from);
  else if (const double inertia = model.hub_inertia.number; inertia > 0.0)
    toml.key("inertia", digits(Eigen::Vector3d(inertia, 0.5 * inertia, 0.5 * inertia)),
             model.hub_inertia.from);
  write_drive(model, toml);
}

void write_nacelle(const Nacelle& nacelle, Toml& toml) {
  toml.table("[[support.body]]");
  toml.key("name", "\"nacelle\"");
  toml.key("kind", "\"rigid\"");
  toml.key("mass", digits(nacelle.mass.number), nacelle.mass.from);
  toml.key("center", digits(nacelle.center), nacelle.center_from);
  toml.key("inertia", digits(nacelle.inertia), nacelle.inertia_from);
}

void write_train(const FoundTrain& train, Toml& toml) {
  const auto write = [&toml](const char* key, const Value& value) {
    if (!value.from.empty()) toml.key(key, digits(value.number), value.from);
  };
  write("stiffness", train.stiffness);
  write("damping", train.damping);
  write("gear_ratio", train.gear_ratio);
  write("generator_inertia", train.generator_inertia);
}

void write_support(const FoundModel& model, Toml& toml) {
  const BeamTable& tower = *model.tower;
  const std::string turn = digits(Eigen::Vector3d(0.0, 0.5 * std::numbers::pi, 0.0));
  toml.table("[support]");
  toml.key("from", "\"ground\"", "at the base of the tower; x downwind, z up");
  toml.table("[[support.body]]");
  toml.key("name", "\"tower\"");
  toml.key("kind", "\"beam\"");
  toml.key("length", digits(tower.length.number), tower.length.from);
  toml.key("bodies", "2", "not in the files");
  toml.key("elements", "6", "not in the files");
  toml.table("[support.body.sections]");
  write_sections(tower, toml);
  write_tip_mass(tower, "[[support.body.point_mass]]", toml);
  if (model.air && model.air->tower) write_tower_air(*model.air->tower, toml);
  if (model.nacelle) write_nacelle(*model.nacelle, toml);
  toml.table("[[support.joint]]");
  toml.key("child", "\"tower\"");
  toml.key("kind", "\"fixed\"");
  toml.key("orientation", digits(Eigen::Vector3d(0.0, -0.5 * std::numbers::pi, 0.0)),
           "x of the beam is up");
  if (model.nacelle) write_yaw(model, turn, toml);
  toml.table("[support.axle]");
  toml.key("body", model.nacelle ? "\"nacelle\"" : "\"tower\"");
  if (model.nacelle) {
    toml.key("offset", digits(model.nacelle->hub), model.nacelle->hub_from);
    toml.key("orientation", digits(Eigen::Vector3d(0.0, model.nacelle->tilt, 0.0)),
             model.nacelle->tilt_from + ", in rad");
    if (model.train) write_train(*model.train, toml);
  } else {
    toml.key("orientation", turn, "back: z is up");
  }
}

/// z is up where there is a tower or a rotor, whose axis is horizontal.
void write_gravity(const FoundModel& model, Toml& toml) {
  if (!model.tower && !model.has_rotor) return;
  constexpr double standard = 9.80665;  // by the third CGPM, 1901 [m/s^2]
  const bool is_found = !model.gravity.from.empty();
  toml.table("[gravity]");
  toml.key("acceleration",
           digits(Eigen::Vector3d(0.0, 0.0, is_found ? -model.gravity.number : -standard)),
           is_found ? model.gravity.from
                    : std::string("not in the files: standard gravity, down ") +
                          (model.tower ? "along the tower" : "across the axis"));
}

void write_damping(const FoundDamping& damping, Toml& toml) {
  if (is_zero(damping.mu) && is_zero(damping.ratios)) return;
  toml.table("[damping]");
  if (!damping.mu.empty())
    toml.key("mu", digits(damping.mu), damping.from);
  else
    toml.key("ratios", digits(damping.ratios), damping.from);
}

/// What is controlled begins bent by its wind: at once it would be a blow, which no controller is
/// for.
void write_start(const FoundModel& model, Toml& toml) {
  if (!model.laws || !model.air) return;
  toml.table("[initial]");
  toml.key("state", "\"equilibrium\"", "not in the files: at the speed and the pitch of the start");
}

void write_course(const FoundModel& model, Toml& toml) {
  const bool ends = model.duration.number > 0.0;
  toml.table("[integration]");
  toml.key("step", "0.01", "not in the files");
  toml.key("duration", ends ? digits(model.duration.number) : "10",
           ends ? model.duration.from : "not in the files");
  if (!(model.interval.number > 0.0)) return;
  toml.table("[output]");
  toml.key("interval", digits(model.interval.number), model.interval.from);
}

}  // namespace

std::string write_scenario(const FoundModel& model, const ScenarioPlaces* places) {
  Toml toml;
  toml.comment("Written by spoke import from");
  for (const std::string& source : model.sources) toml.comment("  " + source);
  toml.comment("Behind each value stands the key and the line that it came from.");
  if (!model.left_out.empty()) toml.comment("Not carried over, worst first:");
  for (const LeftOut& left_out : model.left_out) toml.comment("  - " + left_out.text);
  toml.table("title = " + quoted(model.title));
  toml.key("world", "\"space\"");
  write_hub(model, toml);
  write_control(model, places ? places->folder : "", !places, toml);
  if (model.tower) write_support(model, toml);
  if (model.blade) write_blade(model, toml);
  write_gravity(model, toml);
  if (model.air)
    write_air(*model.air, places, {model.has_rotor ? "[8, 0, 0]" : "[0, 0, 8]", model.ground},
              toml);
  write_damping(model.damping, toml);
  write_start(model, toml);
  write_course(model, toml);
  return toml.take();
}

}  // namespace spoke::foreign
