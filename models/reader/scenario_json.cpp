// Writes a scenario with all values in force as JSON, in the shape of its file.

#include <nlohmann/json.hpp>

#include "models/scenario.h"

namespace spoke {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Position& p) { return Json::array({p.x(), p.y()}); }

void add_drive(const SpinUp& drive, Json& json) {
  json["speed"] = drive.speed;
  json["ramp"] = drive.ramp;
}

void add_drive(const SpinUpHoldSpinDown& drive, Json& json) {
  json["speed"] = drive.speed;
  json["ramp"] = drive.ramp;
  json["hold"] = drive.hold;
  json["ramp_down"] = drive.ramp_down;
}

void add_drive(const SpeedTable& drive, Json& json) {
  json["time"] = drive.speed.times();
  json["speed"] = drive.speed.values();
}

void add_drive(const TorqueDrive& drive, Json& json) {
  if (drive.torque.times().size() == 1) {
    json["torque"] = drive.torque.values().front();
  } else {
    json["time"] = drive.torque.times();
    json["torque"] = drive.torque.values();
  }
  json["initial_speed"] = drive.initial_speed;
}

void add_drive(const FreeDrive& drive, Json& json) { json["initial_speed"] = drive.initial_speed; }

Json to_json(const Hub& hub) {
  Json drive = {{"kind", name_of(hub.drive)}};
  std::visit([&](const auto& d) { add_drive(d, drive); }, hub.drive);
  return {{"support", name_of(hub.support)},
          {"radius", hub.radius},
          {"inertia", hub.inertia},
          {"mass", hub.mass},
          {"drive", drive}};
}

Json to_json(const BladeSections& sections) {
  return {{"station", sections.station},
          {"mass_per_length", sections.mass_per_length},
          {"axial_stiffness", sections.axial_stiffness},
          {"bending_stiffness", sections.bending_stiffness}};
}

void add_material(const Blade& blade, Json& json) {
  if (!blade.sections.station.empty()) {
    json["sections"] = to_json(blade.sections);
    return;
  }
  json["density"] = blade.density;
  json["area"] = blade.area;
  json["second_moment"] = blade.second_moment;
  json["youngs_modulus"] = blade.youngs_modulus;
}

Json to_json(const Blade& blade) {
  Json json = {{"length", blade.length}, {"bodies", blade.bodies}, {"elements", blade.elements}};
  add_material(blade, json);
  json["geometric_stiffening"] = blade.geometric_stiffening;
  json["reference_frame"] = name_of(blade.reference_frame);
  json["azimuth"] = blade.azimuth;
  for (const PointMass& point : blade.point_masses)
    json["point_mass"].push_back(
        {{"position", point.position}, {"mass", point.mass}, {"inertia", point.inertia}});
  return json;
}

Json to_json(const PointLoad& load) {
  Json json = {{"blade", load.blade < 0 ? Json("all") : Json(load.blade + 1)},
               {"position", load.position},
               {"frame", name_of(load.frame)},
               {"force", to_json(load.force)},
               {"moment", load.moment},
               {"time", load.factor.times()},
               {"factor", load.factor.values()}};
  return json;
}

Json to_json(const Integration& integration) {
  return {{"method", name_of(integration.method)},
          {"step", integration.step},
          {"duration", integration.duration},
          {"spectral_radius", integration.spectral_radius},
          {"tolerance", integration.tolerance},
          {"iterations", integration.iterations},
          {"max_iterations", integration.max_iterations}};
}

Json to_json(const Limits& limits) {
  return {{"deflection", limits.deflection},
          {"energy_growth", limits.energy_growth},
          {"on_energy_growth", name_of(limits.on_energy_growth)}};
}

}  // namespace

std::string Scenario::to_json() const {
  Json blades = Json::array();
  for (const Blade& blade : rotor.blades) blades.push_back(spoke::to_json(blade));
  Json loads = Json::array();
  for (const PointLoad& load : rotor.loads) loads.push_back(spoke::to_json(load));
  Json json = {{"title", title},
               {"hub", spoke::to_json(rotor.hub)},
               {"blades", blades},
               {"gravity", {{"acceleration", spoke::to_json(rotor.gravity)}}},
               {"damping",
                {{"mass_factor", rotor.damping.mass_factor},
                 {"stiffness_factor", rotor.damping.stiffness_factor}}},
               {"load", loads},
               {"integration", spoke::to_json(integration)},
               {"limits", spoke::to_json(limits)},
               {"output", {{"interval", output.interval}}}};
  // A title from a file name may hold anything.
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace spoke
