// ElastoDyn's primary file.

#include <cmath>
#include <numbers>
#include <utility>

#include "models/support/quantity.h"
#include "program/foreign/elastodyn_reader.h"

namespace spoke::foreign {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// Returns a - b, which must be positive.
Value subtract(KeyedLines& reader, std::string_view key, std::string_view less) {
  const Value b = reader.number(less), a = reader.number(key);
  if (!(a.number > b.number))
    reader.lines().refuse(std::string(key) + " is " + describe(a.number) + ", expected more than " +
                          std::string(less) + ", " + describe(b.number));
  return {a.number - b.number, std::string(key) + " - " + b.from};
}

void read_rotor(KeyedLines& reader, FoundModel& model) {
  model.blade_count.number = reader.count("NumBl", 1, 1000);
  model.blade_count.from = "NumBl, " + reader.lines().place();
  model.hub_radius = reader.at_least("HubRad", 0.0);
  model.precone = reader.number("PreCone(1)");
  model.precone.number *= kDegree;
  model.speed = reader.number("RotSpeed");
  model.speed.number *= std::numbers::pi / 30.0;
  model.hub_mass = reader.at_least("HubMass", 0.0);
  model.hub_center = reader.has("HubCM") ? reader.number("HubCM").number : 0.0;
  model.hub_inertia = reader.at_least("HubIner", 0.0);
  if (reader.has("Azimuth")) {
    model.azimuth = reader.number("Azimuth");
    model.azimuth.number *= kDegree;
  }
  if (reader.has("BlPitch(1)")) {
    model.pitch = reader.number("BlPitch(1)");
    model.pitch.number = model.pitch.number == 0.0 ? 0.0 : -model.pitch.number * kDegree;
  }
  model.has_rotor = true;
}

/// A shaft that twists puts the generator behind it; on a rigid one it is part of the hub.
void read_train(KeyedLines& reader, FoundModel& model) {
  const Value generator = reader.at_least("GenIner", 0.0), gear = reader.number("GBRatio");
  model.gear_ratio = gear;
  model.holds_speed = reader.is_off("GenDOF");
  if (reader.has("DTTorSpr") && !reader.is_off("DrTrDOF") && generator.number > 0.0) {
    model.train = FoundTrain{reader.positive("DTTorSpr"), {}, gear, generator};
    if (reader.has("DTTorDmp")) model.train->damping = reader.at_least("DTTorDmp", 0.0);
    return;
  }
  model.hub_inertia.number += generator.number * gear.number * gear.number;
  model.hub_inertia.from += ", with that of the generator, GenIner times GBRatio squared";
}

void read_nacelle(KeyedLines& reader, FoundModel& model) {
  Nacelle nacelle;
  nacelle.mass = reader.positive("NacMass");
  const Value x = reader.number("NacCMxn"), y = reader.number("NacCMyn"),
              z = reader.number("NacCMzn");
  nacelle.center = {x.number, y.number, z.number};
  nacelle.center_from = x.from + ", and the next two";
  Value inertia = reader.positive("NacYIner");
  const double steiner = nacelle.mass.number * (x.number * x.number + y.number * y.number);
  if (!(inertia.number > steiner))
    reader.lines().refuse("NacYIner is " + describe(inertia.number) +
                          ", expected more than NacMass times the distance of its centre from the "
                          "yaw axis squared, " +
                          describe(steiner));
  inertia.number -= steiner;
  nacelle.inertia = {0.5 * inertia.number, 0.5 * inertia.number, inertia.number};
  nacelle.inertia_from =
      inertia.from + ", less NacMass times the distance from the yaw axis squared";
  const Value overhang = reader.number("OverHang"), height = reader.number("Twr2Shft"),
              tilt = reader.number("ShftTilt");
  const double angle = tilt.number * kDegree;
  nacelle.hub = {overhang.number * std::cos(angle), 0.0,
                 height.number + overhang.number * std::sin(angle)};
  nacelle.hub_from = overhang.from + ", along the shaft, and " + height.from;
  nacelle.tilt = angle == 0.0 ? 0.0 : -angle;
  nacelle.tilt_from = tilt.from;
  model.nacelle = nacelle;
}

bool is_on(KeyedLines& reader, const char* key) { return reader.has(key) && !reader.is_off(key); }

/// The height of the foot, and how the nacelle is turned.
void read_places(KeyedLines& reader, FoundModel& model) {
  model.ground = reader.number("TowerBsHt");
  if (reader.has("PtfmHeave"))
    if (const Value heave = reader.number("PtfmHeave"); heave.number != 0.0) {
      model.ground.number += heave.number;
      model.ground.from += ", and " + heave.from;
    }
  model.ground.number = model.ground.number == 0.0 ? 0.0 : -model.ground.number;
  model.ground.from += ", below the foot of the tower";
  if (reader.has("NacYaw")) {
    model.yaw.angle = reader.number("NacYaw");
    model.yaw.angle.number *= kDegree;
  }
  model.has_yaw_spring = is_on(reader, "YawDOF");
}

/// Returns the keys of flags that are as asked for, with the file: "FlapDOF1, EdgeDOF".
std::string list_flags(KeyedLines& reader, std::initializer_list<const char*> keys, bool on) {
  std::string all;
  for (const char* key : keys)
    if (on ? is_on(reader, key) : reader.is_off(key))
      all += (all.empty() ? "" : ", ") + std::string(key);
  return all;
}

/// Freedoms that the scenario has otherwise.
void note_freedoms(KeyedLines& reader, FoundModel& model) {
  const std::string& file = reader.lines().file();
  if (const auto keys = list_flags(
          reader, {"PtfmSgDOF", "PtfmSwDOF", "PtfmHvDOF", "PtfmRDOF", "PtfmPDOF", "PtfmYDOF"},
          true);
      !keys.empty())
    model.leave_out(Loss::part,
                    file + ": " + keys + " True: the platform; the foot of the tower is held");
  if (is_on(reader, "TeetDOF") && model.blade_count.number == 2.0)
    model.leave_out(Loss::part, file + ": TeetDOF True: teeter of the hub");
  if (is_on(reader, "Furling"))
    model.leave_out(Loss::part, file + ": Furling True: furling and tail");
  if (const auto keys = list_flags(
          reader,
          {"FlapDOF1", "FlapDOF2", "EdgeDOF", "TwFADOF1", "TwFADOF2", "TwSSDOF1", "TwSSDOF2"},
          false);
      !keys.empty())
    model.leave_out(Loss::theory,
                    file + ": " + keys + " False: beams of the scenario bend all the same");
}

/// What this file has that the scenario does not, where it is not 0, False or none.
void note_unused(KeyedLines& reader, FoundModel& model) {
  constexpr std::pair<const char*, const char*> kUnused[] = {
      {"OoPDefl", "the blades start undeformed"},
      {"IPDefl", "the blades start undeformed"},
      {"TeetDefl", "the hub does not teeter"},
      {"TTDspFA", "the tower starts undeformed"},
      {"TTDspSS", "the tower starts undeformed"},
      {"PtfmSurge", "the foot of the tower is held"},
      {"PtfmSway", "the foot of the tower is held"},
      {"PtfmRoll", "the foot of the tower is held"},
      {"PtfmPitch", "the foot of the tower is held"},
      {"PtfmYaw", "the foot of the tower is held"},
      {"PtfmMass", "the foot of the tower is held, without the platform"},
      {"UndSling", "the hub does not teeter"},
      {"TeetMod", "the hub does not teeter"},
      {"YawFrctMod", "yaw goes without friction"}};
  for (const auto& [key, instead] : kUnused) {
    if (!reader.has(key)) continue;
    const Value value = reader.number(key);
    if (value.number != 0.0)
      model.leave_out(Loss::value,
                      value.from + ", which is " + describe(value.number) + ": " + instead);
  }
  if (!reader.has("GBoxEff")) return;
  if (const Value efficiency = reader.number("GBoxEff"); efficiency.number != 100.0)
    model.leave_out(Loss::value, efficiency.from + ", which is " + describe(efficiency.number) +
                                     ": losses of the gearbox");
}

/// Blades that differ from the first one, which stands for all.
void note_other_blades(KeyedLines& reader, FoundModel& model) {
  for (const char* key : {"BlPitch", "PreCone", "TipMass"}) {
    const auto of_blade = [&](int blade) {
      return std::string(key) + '(' + std::to_string(blade) + ')';
    };
    if (!reader.has(of_blade(1))) continue;
    const double first = reader.number(of_blade(1)).number;
    for (int blade = 2; blade <= model.blade_count.number && reader.has(of_blade(blade)); ++blade)
      if (const Value other = reader.number(of_blade(blade)); other.number != first)
        model.leave_out(Loss::value, other.from + ", which is " + describe(other.number) +
                                         ": all blades have that of blade 1, " + describe(first));
  }
}

}  // namespace

ElastoDynPrimary read_elastodyn_primary(const SourceFile& source, FoundModel& model) {
  KeyedLines reader(source);
  model.title = reader.take_head("a primary file of ElastoDyn");
  if (model.gravity.from.empty() && reader.has("Gravity"))
    model.gravity = reader.at_least("Gravity", 0.0);
  read_rotor(reader, model);
  read_train(reader, model);
  read_nacelle(reader, model);
  ElastoDynPrimary primary;
  primary.blade_length = subtract(reader, "TipRad", "HubRad");
  primary.tower_height = subtract(reader, "TowerHt", "TowerBsHt");
  read_places(reader, model);
  if (reader.has("TipMass(1)")) primary.tip_mass = reader.at_least("TipMass(1)", 0.0);
  if (reader.has("YawBrMass")) primary.yaw_bearing_mass = reader.at_least("YawBrMass", 0.0);
  primary.blade = reader.file("BldFile1", "BldFile(1)");
  primary.tower = reader.file("TwrFile", "TwrFile");
  model.leave_out(
      Loss::value,
      source.name +
          ": inertias of nacelle and hub about other axes are half of those about their "
          "own, the least that a body can have");
  model.leave_out(Loss::detail, source.name + ": outputs");
  note_freedoms(reader, model);
  note_unused(reader, model);
  note_other_blades(reader, model);
  return primary;
}

}  // namespace spoke::foreign
