// Rules for the hub and for loads.

#include <algorithm>
#include <string_view>

#include "models/reader/names.h"
#include "models/reader/spatial/fault.h"
#include "models/reader/spatial/solid_faults.h"
#include "models/support/nearest_name.h"

namespace spoke::spatial {
namespace {

/// Finds keys that a free hub cannot have, since it has no axle.
Fault find_free_fault(const Hub& hub) {
  if (prescribes_motion(hub.drive))
    return {"drive.kind",
            "is \"" + std::string(name_of(hub.drive)) +
                "\", which prescribes the rotation about an axle; expected, of a free "
                "hub, \"free\", \"torque\" or \"torque_by_speed\""};
  if (calc_initial_speed(hub.drive) != 0.0)
    return {"drive.initial_speed", "belongs to an axle, expected, of a free hub, angular_velocity"};
  if (hub.mount) return {"mount", "belongs to an axle, expected none of a free hub"};
  return {};
}

Fault find_axle_fault(const Hub& hub) {
  if (!hub.velocity.isZero(0.0))
    return {"velocity", "belongs to a free hub, expected [hub.mount] to move an axle"};
  if (!hub.angular_velocity.isZero(0.0))
    return {"angular_velocity",
            "belongs to a free hub, expected initial_speed of a drive, or [hub.mount]"};
  return {};
}

const Subsystem* find_subsystem(const Model& model, const std::string& name) {
  const auto found = std::find_if(model.subsystems.begin(), model.subsystems.end(),
                                  [&](const Subsystem& s) { return s.name == name; });
  return found == model.subsystems.end() ? nullptr : &*found;
}

template <class Items>
std::vector<std::string_view> names_of(const Items& items) {
  std::vector<std::string_view> names;
  for (const auto& item : items) names.push_back(item.name);
  return names;
}

Fault find_blade_fault(const LoadPlace& place, const Model& model) {
  if (!place.body.empty()) return {"body", "would be ignored, expected only along with subsystem"};
  const auto last = static_cast<int>(model.blades.size());
  if (last == 0) return {"", "is on blades, of which there are none; expected subsystem and body"};
  if (place.blade.is_all() || (place.blade.number() >= 1 && place.blade.number() <= last))
    return {};
  return {"blade", "is " + std::to_string(place.blade.number()) +
                       ", expected a whole number from 1 to " + std::to_string(last)};
}

Fault find_fault(const LoadPlace& place, const Model& model) {
  if (place.subsystem.empty()) return find_blade_fault(place, model);
  if (!place.blade.is_all()) return {"blade", "given along with subsystem, expected only one"};
  const Subsystem* subsystem = find_subsystem(model, place.subsystem);
  if (subsystem == nullptr) {
    if (model.subsystems.empty())
      return {"subsystem", "is \"" + place.subsystem + "\", but there is no [[subsystem]]"};
    return {"subsystem", describe_unknown(place.subsystem, names_of(model.subsystems))};
  }
  for (const int r : find_rotors_on(model, place.subsystem))
    if (place.body == prefix_of_rotor(model, r) + "hub")
      return {"body", "is \"" + place.body + "\", expected a body of the " +
                          (is_support(model, *subsystem) ? "support" : "subsystem") +
                          "; [[hub_load]] acts on the hub"};
  const auto& bodies = subsystem->bodies;
  if (std::any_of(bodies.begin(), bodies.end(),
                  [&](const Body& b) { return b.name == place.body; }))
    return {};
  return {"body", describe_unknown(place.body, names_of(bodies))};
}

/// Returns the body of a subsystem at a valid place; null on a blade.
const Body* find_body(const LoadPlace& place, const Model& model) {
  if (place.subsystem.empty()) return nullptr;
  for (const Body& body : find_subsystem(model, place.subsystem)->bodies)
    if (body.name == place.body) return &body;
  return nullptr;
}

/// Returns the length of the shortest beam at a valid place; 0 if the body there is a rigid body.
double length_at(const LoadPlace& place, const Model& model) {
  if (place.subsystem.empty()) {
    double least = 0.0;
    for (std::size_t i = 0; i < model.blades.size(); ++i)
      if (place.blade.holds(i) && (least == 0.0 || model.blades[i].beam.length < least))
        least = model.blades[i].beam.length;
    return least;
  }
  const auto* beam = std::get_if<Beam>(&find_body(place, model)->shape);
  return beam ? beam->length : 0.0;
}

/// Finds keys of loads on solids where the body is none.
Fault find_solid_keys(const PointLoad& load, const std::string& instead) {
  const std::string text = "belongs to solids, expected " + instead;
  if (!load.interface.empty()) return {"interface", text};
  if (load.nodes) return {"nodes", text};
  if (load.traction) return {"traction", "belongs to solids, expected force"};
  return {};
}

template <class Load>
Fault find_common_fault(const Load& load, const Model& model) {
  const FirstFault first;
  visit_fields(load, first);
  first.add(find_curve_fault("factor", load.factor, kFactor));
  first.add({"name", find_load_name_fault(load.name)});
  if (!first.found()) first.add(find_fault(load.place, model));
  return first.found();
}

}  // namespace

Fault find_course_fault(const std::string& key, const VectorCourse& course, std::string_view unit) {
  const FirstFault first;
  if (const auto* harmonic = std::get_if<VectorHarmonic>(&course)) {
    visit_fields(*harmonic, unit, first);
    return first.found().within(key);
  }
  const std::vector<double>* times = nullptr;  // times of the components that are not left out
  for (const Curve& component : std::get<VectorTable>(course).components) {
    first.add(find_curve_fault("value", component, Quantity::any(unit)));
    if (component.times().size() == 1 && component.values()[0] == 0.0) continue;
    if (times == nullptr) times = &component.times();
    if (*times != component.times())
      first.add({"time", "differs between x, y and z, expected one array for all"});
  }
  return first.found().within(key);
}

Fault find_fault(const Hub& hub) {
  const FirstFault first;
  visit_fields(hub, first);
  first.add(find_direction_fault("axis", hub.axis));
  first.add(find_inertia_fault("inertia", hub.inertia, MayBeZero::no));
  first.add(hub.support == HubSupport::free ? find_free_fault(hub) : find_axle_fault(hub));
  if (hub.mount) {
    first.add(find_course_fault("mount.translation", hub.mount->translation, "m"));
    first.add(find_course_fault("mount.rotation", hub.mount->rotation, "rad"));
  }
  return first.found();
}

std::string find_mass_factor_fault(const Model& model) {
  if (model.damping.mass_factor == 0.0) return {};
  const auto is_cut = [](const Beam& beam) { return beam.bodies > 1; };
  bool is_any_cut = false;
  for (const Blade& blade : model.blades)
    is_any_cut = is_any_cut || is_cut(blade.beam) || !blade.joints.empty();
  for (const Subsystem& subsystem : model.subsystems)
    for (const Body& body : subsystem.bodies)
      if (const auto* beam = std::get_if<Beam>(&body.shape))
        is_any_cut = is_any_cut || is_cut(*beam);
  if (!is_any_cut) return {};
  return "damps motion relative to each body's own frame, next to none of a beam of several "
         "bodies; "
         "expected 0, or bodies = 1: stiffness_factor damps any number of bodies alike";
}

Fault find_fault(const PointLoad& load, const Model& model) {
  const FirstFault first;
  first.add(find_common_fault(load, model));
  if (first.found()) return first.found();
  first("point", load.point, kLength, Presence::optional);
  const Body* body = find_body(load.place, model);
  if (const auto* solid = body ? std::get_if<SolidBody>(&body->shape) : nullptr) {
    first.add(find_load_fault(load, *solid));
    return first.found();
  }
  const double length = length_at(load.place, model);
  const bool is_rigid = length == 0.0;
  first.add(find_solid_keys(load, is_rigid ? "point on a rigid body" : "position on a beam"));
  if (is_rigid && load.position)
    first.add({"position", "belongs to beams, expected point on a rigid body"});
  if (is_rigid && load.frame == LoadFrame::section)
    first.add(
        {"frame", "is \"section\", expected \"inertial\", \"hub\" or \"body\" on a rigid body"});
  if (!is_rigid && !load.point.isZero(0.0))
    first.add({"point", "belongs to rigid bodies, expected position on a beam"});
  if (load.position)
    first("position", *load.position, {"m, from root to tip", 0.0, length}, Presence::optional);
  return first.found();
}

Fault find_fault(const DistributedLoad& load, const Model& model) {
  const FirstFault first;
  first.add(find_common_fault(load, model));
  if (first.found()) return first.found();
  const Body* body = find_body(load.place, model);
  if (body && std::holds_alternative<SolidBody>(body->shape))
    return {"body", "is a solid, expected a beam; [[load]] has nodes and traction for solids"};
  const double length = length_at(load.place, model);
  if (length == 0.0) return {"body", "is rigid, expected a beam"};
  first("from", load.from, {"m, from root to tip", 0.0, length});
  if (load.to) first("to", *load.to, {"m, beyond from, up to the tip", load.from, length, false});
  if (load.from >= load.to.value_or(length))
    first.add({"from", "is " + describe(load.from) + ", expected less than the length, " +
                           describe(length) + " (m)"});
  return first.found();
}

Fault find_fault(const HubLoad& load, const Model&) {
  const FirstFault first;
  visit_fields(load, first);
  first.add(find_curve_fault("factor", load.factor, kFactor));
  first.add({"name", find_load_name_fault(load.name)});
  if (load.frame != LoadFrame::hub && load.frame != LoadFrame::inertial)
    first.add({"frame", "is \"" + std::string(name_of(load.frame)) +
                            "\", expected \"hub\" or \"inertial\""});
  return first.found();
}

}  // namespace spoke::spatial
