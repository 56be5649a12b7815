// Writes a scenario with all values in force as JSON, in the shape of its file.

#include "models/reader/scenario_json.h"

#include "models/reader/damping.h"
#include "models/reader/drive_json.h"
#include "models/reader/loop_json.h"
#include "models/reader/row_reader.h"
#include "models/reader/scenario_fields.h"
#include "models/reader/spatial/model_json.h"

namespace spoke {
namespace {

Json to_json(const Position& p) { return Json::array({p.x(), p.y()}); }

Json to_json(const Hub& hub) {
  Json json = Json::object();
  keys::write(keys::kHubRows, &hub, json);
  json.set("drive", drive_to_json(hub.drive));
  return json;
}

Json to_json(const BladeSections& sections) {
  Json json = {{"station", sections.station}};
  visit_properties(sections, [&](std::string_view key, const std::vector<double>& values,
                                 const Quantity&) { json.set(key, values); });
  return json;
}

void add_material(const Blade& blade, Json& json) {
  if (!blade.sections.station.empty()) {
    json.set("sections", to_json(blade.sections));
    return;
  }
  json.set("density", blade.density);
  json.set("area", blade.area);
  json.set("second_moment", blade.second_moment);
  json.set("youngs_modulus", blade.youngs_modulus);
}

Json to_json(const Blade& blade, const Rotor& rotor) {
  Json json = {{"length", blade.length}, {"bodies", blade.bodies}, {"elements", blade.elements}};
  add_material(blade, json);
  json.set("geometric_stiffening", blade.geometric_stiffening);
  json.set("reference_frame", name_of(blade.reference_frame));
  if (blade.strain != BeamStrain::automatic) json.set("strain", name_of(blade.strain));
  json.set("azimuth", blade.azimuth);
  for (const PointMass& point : blade.point_masses) {
    Json table = {{"position", point.position}};
    keys::write(keys::kPointMassRows, &point, table);
    json.append("point_mass", std::move(table));
  }
  add_loops(blade.loops, surroundings_of(blade, rotor.hub, rotor.anchors), json);
  return json;
}

Json to_json(BladeChoice blade) { return blade.is_all() ? Json("all") : Json(blade.number()); }

/// A ramp of 0 is left out: scenarios without ramps are written as by versions that knew none, so
/// that their checkpoints stay valid.
void add_ramp(double ramp, Json& json) {
  if (ramp > 0.0) json.set("ramp", ramp);
}

/// A load without a name is written as by versions that knew none, too.
template <class Load>
void add_course(const Load& load, Json& json) {
  if (!load.name.empty()) json.set("name", load.name);
  add_ramp(load.ramp, json);
  json.set("time", load.factor.times());
  json.set("factor", load.factor.values());
}

/// Adds the ends of a load per length; without an outer end it ends at each blade's tip.
template <class Load>
void add_ends(const Load& load, Json& json) {
  json.set("from", load.from);
  if (load.to) json.set("to", *load.to);
}

Json to_json(const PointLoad& load) {
  Json json = {{"blade", to_json(load.blade)}};
  if (load.position) json.set("position", *load.position);
  json.set("frame", name_of(load.frame));
  json.set("force", to_json(load.force));
  json.set("moment", load.moment);
  add_course(load, json);
  return json;
}

Json to_json(const DistributedLoad& load) {
  Json json = {{"blade", to_json(load.blade)}};
  add_ends(load, json);
  json.set("frame", name_of(load.frame));
  json.set("force_per_length", to_json(load.force_per_length));
  json.set("moment_per_length", load.moment_per_length);
  add_course(load, json);
  return json;
}

Json to_json(const Drag& drag) {
  Json json = {{"blade", to_json(drag.blade)}, {"relative_to", name_of(drag.relative_to)}};
  if (drag.linear != 0.0 || drag.quadratic != 0.0) {
    if (drag.position) json.set("position", *drag.position);
    json.set("linear", drag.linear);
    json.set("quadratic", drag.quadratic);
  }
  if (drag.linear_per_length != 0.0 || drag.quadratic_per_length != 0.0) {
    add_ends(drag, json);
    json.set("linear_per_length", drag.linear_per_length);
    json.set("quadratic_per_length", drag.quadratic_per_length);
  }
  add_course(drag, json);
  return json;
}

Json to_json(const HubLoad& load) {
  Json json = {{"position", to_json(load.position)},
               {"frame", name_of(load.frame)},
               {"force", to_json(load.force)},
               {"torque", load.torque}};
  add_course(load, json);
  return json;
}

Json to_json(const Sensor& sensor) {
  Json json = {{"name", sensor.name.empty() ? name_of(sensor.quantity) : sensor.name},
               {"quantity", name_of(sensor.quantity)}};
  if (!sensor.subsystem.empty()) json.set("subsystem", sensor.subsystem);
  if (!sensor.body.empty()) json.set("body", sensor.body);
  if (is_of_blade(sensor.quantity) && sensor.subsystem.empty())
    json.set("blade", sensor.blade.is_all() ? Json("all") : Json(sensor.blade.number()));
  if (has_position(sensor.quantity) && sensor.position) json.set("position", *sensor.position);
  if (sensor.quantity == SensorQuantity::joint_reaction && sensor.joint)
    json.set("joint", sensor.joint->number());
  if (is_of_loop(sensor.quantity)) json.set("loop", sensor.loop);
  if (!sensor.coupling.empty()) json.set("coupling", sensor.coupling);
  if (!sensor.interface.empty()) json.set("interface", sensor.interface);
  if (sensor.node) json.set("node", *sensor.node);
  if (frames_of(sensor.quantity).size() > 1) json.set("frame", name_of(frame_of(sensor)));
  return json;
}

template <class Item>
Json to_list(const std::vector<Item>& items) {
  Json list = Json::array();
  for (const Item& item : items) list.push_back(to_json(item));
  return list;
}

/// Adds the loads of a kind; nothing if there are none, for the reason of add_ramp().
template <class Load>
void add_loads(const char* key, const std::vector<Load>& loads, Json& json) {
  if (!loads.empty()) json.set(key, to_list(loads));
}

/// Adds the start; nothing for an undeformed one, for the reason of add_ramp().
void add_initial(const Initial& initial, Json& json) {
  if (initial.state == InitialState::undeformed) return;
  Json start = {{"state", name_of(initial.state)}};
  if (initial.speed) start.set("speed", *initial.speed);
  json.set("initial", std::move(start));
}

Json to_json(const Limits& limits) {
  Json json = Json::object();
  keys::write(keys::kLimitsRows, &limits, json);
  return json;
}

/// Adds the tables of a rotor in the plane.
void add_rotor(const Rotor& rotor, Json& json) {
  Json gravity = {{"acceleration", to_json(rotor.gravity)}};
  add_ramp(rotor.gravity_ramp, gravity);
  json.set("hub", to_json(rotor.hub));
  Json blades = Json::array();
  for (const Blade& blade : rotor.blades) blades.push_back(to_json(blade, rotor));
  json.set("blades", std::move(blades));
  for (const Anchor& anchor : rotor.anchors) json.append("anchor", to_json(anchor, true));
  json.set("gravity", gravity);
  json.set("damping", damping_to_json(rotor.damping));
  json.set("load", to_list(rotor.loads));
  add_loads("distributed_load", rotor.distributed_loads, json);
  add_loads("drag", rotor.drags, json);
  add_loads("hub_load", rotor.hub_loads, json);
}

void add_model(const Scenario& scenario, Json& json) {
  if (scenario.space) {
    spatial::add_model(*scenario.space, json);
  } else {
    add_rotor(scenario.rotor, json);
  }
}

}  // namespace

Json model_to_json(const Scenario& scenario) {
  Json json;
  add_model(scenario, json);
  return json;
}

Json integration_to_json(const Scenario& scenario) {
  const Integration& integration = scenario.integration;
  Json json = {
      {"method", name_of(integration.method)}, {"step", integration.step},
      {"duration", integration.duration},      {"spectral_radius", integration.spectral_radius},
      {"tolerance", integration.tolerance},    {"iterate_to", name_of(goal_of(integration))},
      {"iterations", integration.iterations},  {"max_iterations", integration.max_iterations}};
  // For the reason of add_ramp().
  if (has_loops(scenario)) json.set("loop_redundancy", integration.loop_redundancy);
  return json;
}

Json scenario_to_json(const Scenario& scenario) {
  Json json = {{"title", scenario.title}};
  add_model(scenario, json);
  add_initial(scenario.initial, json);
  json.set("integration", integration_to_json(scenario));
  json.set("limits", to_json(scenario.limits));
  Json output = Json::object();
  keys::write(keys::kOutputRows, &scenario.output, output);
  json.set("output", std::move(output));
  if (!scenario.statistics.exponents.empty()) {  // for the reason of add_ramp()
    Json exponents = Json::object();
    for (const auto& [name, exponent] : scenario.statistics.exponents)
      exponents.set(name, exponent);
    json.set("statistics", {{"exponents", exponents}});
  }
  if (!scenario.space || !scenario.sensors.empty()) json.set("sensor", to_list(scenario.sensors));
  return json;
}

std::string Scenario::to_json() const {
  std::string text = scenario_to_json(*this).dump_lines();
  text.pop_back();  // the line end
  return text;
}

}  // namespace spoke
