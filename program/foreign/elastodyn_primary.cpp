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
  model.has_rotor = true;
}

/// A shaft that twists puts the generator behind it; on a rigid one it is part of the hub.
void read_train(KeyedLines& reader, FoundModel& model) {
  const Value generator = reader.at_least("GenIner", 0.0), gear = reader.number("GBRatio");
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
  nacelle.inertia = reader.positive("NacYIner");
  const double steiner = nacelle.mass.number * (x.number * x.number + y.number * y.number);
  if (!(nacelle.inertia.number > steiner))
    reader.lines().refuse("NacYIner is " + describe(nacelle.inertia.number) +
                          ", expected more than NacMass times the distance of its centre from the "
                          "yaw axis squared, " +
                          describe(steiner));
  nacelle.inertia.number -= steiner;
  nacelle.inertia.from += ", less NacMass times the distance from the yaw axis squared";
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

/// What this file has that the scenario does not, where it is not 0, False or none.
void note_unused(KeyedLines& reader, FoundModel& model) {
  constexpr std::pair<const char*, const char*> kUnused[] = {
      {"OoPDefl", "the blades start undeformed"},
      {"IPDefl", "the blades start undeformed"},
      {"TeetDefl", "the hub does not teeter"},
      {"Azimuth", "blade 1 starts upright"},
      {"NacYaw", "the nacelle looks along x"},
      {"TTDspFA", "the tower starts undeformed"},
      {"TTDspSS", "the tower starts undeformed"},
      {"PtfmSurge", "the foot of the tower is held"},
      {"PtfmSway", "the foot of the tower is held"},
      {"PtfmHeave", "the foot of the tower is held"},
      {"PtfmRoll", "the foot of the tower is held"},
      {"PtfmPitch", "the foot of the tower is held"},
      {"PtfmYaw", "the foot of the tower is held"},
      {"PtfmMass", "the foot of the tower is held, without the platform"},
      {"UndSling", "the hub does not teeter"},
      {"TeetMod", "the hub does not teeter"}};
  for (const auto& [key, instead] : kUnused) {
    if (!reader.has(key)) continue;
    const Value value = reader.number(key);
    if (value.number != 0.0)
      model.left_out.push_back(value.from + ", which is " + describe(value.number) + ": " +
                               instead);
  }
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
        model.left_out.push_back(other.from + ", which is " + describe(other.number) +
                                 ": all blades have that of blade 1, " + describe(first));
  }
}

}  // namespace

ElastoDynPrimary read_elastodyn_primary(const SourceFile& source, FoundModel& model) {
  KeyedLines reader(source);
  reader.lines().take("the first line of a primary file of ElastoDyn");
  model.title = printable(reader.lines().take("a title"));
  read_rotor(reader, model);
  read_train(reader, model);
  read_nacelle(reader, model);
  ElastoDynPrimary primary;
  primary.blade_length = subtract(reader, "TipRad", "HubRad");
  primary.tower_height = subtract(reader, "TowerHt", "TowerBsHt");
  model.ground = reader.number("TowerBsHt");
  model.ground.number = model.ground.number == 0.0 ? 0.0 : -model.ground.number;
  model.ground.from += ", below the foot of the tower";
  if (reader.has("TipMass(1)")) primary.tip_mass = reader.at_least("TipMass(1)", 0.0);
  if (reader.has("YawBrMass")) primary.yaw_bearing_mass = reader.at_least("YawBrMass", 0.0);
  const bool pitches = model.air && reader.has("BlPitch(1)");
  if (pitches) {
    model.pitch = reader.number("BlPitch(1)");
    model.pitch.number *= -kDegree;
  }
  primary.blade = reader.file("BldFile1", "BldFile(1)");
  primary.tower = reader.file("TwrFile", "TwrFile");
  model.left_out.push_back(
      source.name + ": switches of degrees of freedom, " +
      (pitches ? "initial conditions but speed and pitch, " : "initial conditions, pitch, ") +
      "teeter, furling, platform, yaw (the nacelle is fixed to the tower), " +
      (model.train ? "" : "drivetrain flexibility, ") +
      "losses of the gearbox and outputs; blade 1 stands for all; of the nacelle's inertia that "
      "about the yaw axis is taken for every axis, and the hub's about other axes is half of that "
      "about its own");
  note_unused(reader, model);
  note_other_blades(reader, model);
  return primary;
}

}  // namespace spoke::foreign
