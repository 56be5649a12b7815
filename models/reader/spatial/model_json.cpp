// Writes hub, bodies and loads.

#include "models/reader/spatial/model_json.h"

#include <string_view>
#include <utility>

#include "models/reader/damping.h"
#include "models/reader/drive_json.h"
#include "models/reader/loop_json.h"
#include "models/reader/spatial/air_json.h"
#include "models/reader/spatial/control_json.h"
#include "models/reader/spatial/coupling_reader.h"
#include "models/reader/spatial/course_json.h"
#include "models/reader/spatial/drag_reader.h"
#include "models/reader/spatial/event_reader.h"
#include "models/reader/spatial/field_writer.h"
#include "models/reader/spatial/joint_json.h"
#include "models/reader/spatial/solid_json.h"
#include "models/reader/spatial/spatial_fields.h"
#include "models/scenario.h"
#include "models/tree/axle_carrier.h"

namespace spoke::spatial {
namespace {

Json inertia_to_json(const Tensor& t) {
  return Json::array({t(0, 0), t(1, 1), t(2, 2), t(0, 1), t(0, 2), t(1, 2)});
}

Json to_json(const Hub& hub) {
  Json json = {{"support", name_of(hub.support)}};
  const bool is_free = hub.support == HubSupport::free;
  visit_fields(hub, [&](std::string_view key, const auto& value, const auto& range, Presence p) {
    if (is_free || (key != "velocity" && key != "angular_velocity"))
      FieldWriter{json}(key, value, range, p);
  });
  json.set("inertia", inertia_to_json(hub.inertia));
  json.set("drive", drive_to_json(hub.drive));
  if (hub.mount)
    json.set("mount", {{"translation", spatial::to_json(hub.mount->translation, "m")},
                       {"rotation", spatial::to_json(hub.mount->rotation, "rad")}});
  return json;
}

Json to_json(const Sections& sections) {
  Json json = {{"station", sections.station}};
  const auto numbers = [&](std::string_view key, const std::vector<double>& values,
                           const Quantity&) {
    if (!values.empty()) json.set(key, values);
  };
  const auto offsets = [&](const char* key, const std::vector<Offset>& values, const Quantity&) {
    for (const Offset& o : values) json.append(key, Json::array({o.x(), o.y()}));
  };
  const auto matrices = [&](const char* key, const std::vector<SectionMatrix>& values) {
    for (const SectionMatrix& m : values) {
      Json entries = Json::array();
      for (int r = 0; r < 6; ++r)
        for (int c = 0; c < 6; ++c) entries.push_back(m(r, c));
      json.append(key, entries);
    }
  };
  numbers("mass_per_length", sections.mass_per_length, {});
  visit_stiffnesses(sections, numbers);
  visit_shear_stiffnesses(sections, numbers);
  visit_inertias(sections, numbers);
  offsets("mass_center", sections.mass_center, {});
  visit_stiffness_centers(sections, offsets);
  matrices("stiffness_6x6", sections.stiffness_6x6);
  matrices("mass_6x6", sections.mass_6x6);
  visit_shape(sections, numbers);
  return json;
}

void add_beam(const Beam& beam, Json& json) {
  visit_fields(beam, FieldWriter{json});
  json.set("sections", to_json(beam.sections));
  json.set("geometric_stiffening", beam.geometric_stiffening);
  json.set("reference_frame", name_of(beam.reference_frame));
  if (beam.strain != BeamStrain::automatic) json.set("strain", name_of(beam.strain));
  for (const PointMass& point : beam.point_masses) {
    Json mass;
    visit_fields(point, FieldWriter{mass});
    mass.set("inertia", inertia_to_json(point.inertia));
    json.append("point_mass", mass);
  }
}

Json to_json(const Blade& blade, const Model& model) {
  Json json;
  add_beam(blade.beam, json);
  visit_fields(blade, FieldWriter{json});
  for (const BladeJoint& joint : blade.joints) {
    Json table = {{"station", joint.station}};
    add_joint(joint.joint, table);
    json.append("joint", table);
  }
  add_loops(blade.loops, surroundings_of(blade, model), json);
  add_couplings(blade.couplings, json);
  if (blade.aerodynamics) json.set("aerodynamics", aerodynamics_to_json(*blade.aerodynamics));
  return json;
}

Json to_json(const Body& body) {
  Json json = {{"name", body.name}};
  if (const auto* beam = std::get_if<Beam>(&body.shape)) {
    json.set("kind", "beam");
    add_beam(*beam, json);
    if (body.drag) json.set("drag", drag_to_json(*body.drag));
    return json;
  }
  if (const auto* solid = std::get_if<SolidBody>(&body.shape)) {
    json.set("kind", "solid");
    add_solid(*solid, json);
    return json;
  }
  const auto& rigid = std::get<RigidBody>(body.shape);
  json.set("kind", "rigid");
  visit_fields(rigid, FieldWriter{json});
  json.set("inertia", inertia_to_json(rigid.inertia));
  if (body.drag) json.set("drag", drag_to_json(*body.drag));
  return json;
}

void add_tree(const Subsystem& subsystem, const Model& model, Json& json) {
  for (const Body& body : subsystem.bodies) json.append("body", to_json(body));
  for (const SubsystemJoint& joint : subsystem.joints) {
    Json table = {{"parent", joint.parent}, {"child", joint.child}};
    if (joint.station) table.set("station", *joint.station);
    if (!joint.interface.empty()) table.set("interface", joint.interface);
    add_joint(joint.joint, table);
    json.append("joint", table);
  }
  add_loops(subsystem.loops, surroundings_of(subsystem, model), json);
  add_couplings(subsystem.couplings, json);
}

Json to_json(const Subsystem& subsystem, const Model& model) {
  Json json = {{"name", subsystem.name}};
  visit_fields(subsystem, FieldWriter{json});
  add_tree(subsystem, model, json);
  return json;
}

Json to_json(const Axle& axle, SupportBase from) {
  Json json;
  if (const int blade = find_blade_of(axle); blade > 0) {
    json.set("blade", blade);
  } else {
    if (!axle.subsystem.empty()) json.set("subsystem", axle.subsystem);
    json.set("body", axle.body.empty() ? base_name(from) : axle.body);
  }
  if (axle.station) json.set("station", *axle.station);
  if (!axle.interface.empty()) json.set("interface", axle.interface);
  visit_fields(axle, FieldWriter{json});
  if (axle.train) visit_fields(*axle.train, FieldWriter{json});
  return json;
}

Json to_json(const Support& support, const Subsystem& tree, const Model& model) {
  Json json = {{"from", name_of(support.from)}};
  if (support.from == SupportBase::free) {
    visit_fields(support.fuselage, FieldWriter{json});
    json.set("inertia", inertia_to_json(support.fuselage.inertia));
  }
  add_tree(tree, model, json);
  if (model.hub.name.empty()) json.set("axle", to_json(support.axle, support.from));
  return json;
}

/// Returns the table of a rotor.
Json rotor_to_json(const Model& model, int rotor) {
  Json json = {{"name", hub_of(model, rotor).name},
               {"hub", to_json(hub_of(model, rotor))},
               {"axle", to_json(axle_of(model, rotor), model.support->from)}};
  for (const Blade& blade : model.blades)
    if (blade.rotor == rotor) json.append("blades", to_json(blade, model));
  return json;
}

/// Names the rotor of what one of several carries.
void add_rotor_of(int rotor, const Model& model, Json& json) {
  if (!model.hub.name.empty()) json.set("rotor", hub_of(model, rotor).name);
}

void add_place(const LoadPlace& place, Json& json) {
  if (place.subsystem.empty()) {
    json.set("blade", place.blade.is_all() ? Json("all") : Json(place.blade.number()));
    return;
  }
  json.set("subsystem", place.subsystem);
  json.set("body", place.body);
}

template <class Load>
void add_course(const Load& load, Json& json) {
  if (!load.name.empty()) json.set("name", load.name);
  json.set("frame", name_of(load.frame));
  visit_fields(load, FieldWriter{json});
  json.set("time", load.factor.times());
  json.set("factor", load.factor.values());
}

Json to_json(const PointLoad& load) {
  Json json;
  add_place(load.place, json);
  if (load.position) json.set("position", *load.position);
  if (!load.point.isZero(0.0)) json.set("point", spatial::to_json(load.point));
  if (!load.interface.empty()) json.set("interface", load.interface);
  if (load.nodes) json.set("nodes", choice_to_json(*load.nodes));
  if (load.traction) json.set("traction", spatial::to_json(*load.traction));
  add_course(load, json);
  return json;
}

Json to_json(const DistributedLoad& load) {
  Json json;
  add_place(load.place, json);
  json.set("from", load.from);
  if (load.to) json.set("to", *load.to);
  add_course(load, json);
  return json;
}

Json to_json(const HubLoad& load) {
  Json json;
  add_course(load, json);
  return json;
}

template <class Items>
void add_list(const char* key, const Items& items, Json& json) {
  for (const auto& item : items) json.append(key, to_json(item));
}

}  // namespace

void add_model(const Model& model, Json& json) {
  json.set("world", "space");
  if (model.hub.name.empty()) {
    json.set("hub", to_json(model.hub));
    for (const Blade& blade : model.blades) json.append("blades", to_json(blade, model));
  } else {
    for (int r = 0; r < count_rotors(model); ++r) json.append("rotor", rotor_to_json(model, r));
  }
  for (const Subsystem& subsystem : model.subsystems) {
    if (is_support(model, subsystem)) {
      json.set("support", to_json(*model.support, subsystem, model));
      continue;
    }
    Json made = to_json(subsystem, model);
    add_rotor_of(subsystem.rotor, model, made);
    json.append("subsystem", std::move(made));
  }
  for (const Anchor& anchor : model.anchors) {
    Json made = spoke::to_json(anchor, false);
    if (anchor.frame == Anchor::Frame::hub || anchor.frame == Anchor::Frame::axle)
      add_rotor_of(anchor.rotor, model, made);
    json.append("anchor", std::move(made));
  }
  json.set("gravity", {{"acceleration", to_json(model.gravity)}, {"ramp", model.gravity_ramp}});
  json.set("damping", damping_to_json(model.damping));
  add_list("load", model.loads, json);
  add_list("distributed_load", model.distributed_loads, json);
  for (const HubLoad& load : model.hub_loads) {
    Json made = to_json(load);
    add_rotor_of(load.rotor, model, made);
    json.append("hub_load", std::move(made));
  }
  if (model.air) add_air(*model.air, json);
  if (model.outer_control)
    json.set("control", {{model.outer_control->table().substr(std::string_view("control.").size()),
                          control_to_json(*model.outer_control)}});
  if (model.pitch_control) json.set("control", {{"pitch", control_to_json(*model.pitch_control)}});
  for (const Event& event : model.events) json.append("event", event_to_json(event));
}

}  // namespace spoke::spatial
