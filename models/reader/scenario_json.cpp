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

Json to_json(const Blade& blade) {
  return {{"length", blade.length},
          {"bodies", blade.bodies},
          {"elements", blade.elements},
          {"density", blade.density},
          {"area", blade.area},
          {"second_moment", blade.second_moment},
          {"youngs_modulus", blade.youngs_modulus},
          {"geometric_stiffening", blade.geometric_stiffening},
          {"reference_frame", name_of(blade.reference_frame)},
          {"azimuth", blade.azimuth}};
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

Json to_json(const Sensor& sensor) {
  Json json = {{"name", sensor.name.empty() ? name_of(sensor.quantity) : sensor.name},
               {"quantity", name_of(sensor.quantity)}};
  if (is_of_blade(sensor.quantity))
    json["blade"] = sensor.blade < 0 ? Json("all") : Json(sensor.blade + 1);
  if (has_position(sensor.quantity) && sensor.position) json["position"] = *sensor.position;
  if (sensor.quantity == SensorQuantity::joint_reaction) json["joint"] = sensor.joint + 1;
  if (frames_of(sensor.quantity).size() > 1) json["frame"] = name_of(frame_of(sensor));
  return json;
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
  Json measured = Json::array();
  for (const Sensor& sensor : sensors) measured.push_back(spoke::to_json(sensor));
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
               {"output", {{"interval", output.interval}}},
               {"sensor", measured}};
  // A title from a file name may hold anything.
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace spoke
