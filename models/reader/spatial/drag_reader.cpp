// Drag of a beam by stations, of a rigid body by areas.

#include "models/reader/spatial/drag_reader.h"

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <variant>

#include "models/reader/keys/air_keys.h"
#include "models/reader/row_reader.h"
#include "models/reader/spatial/air_reader.h"
#include "models/reader/spatial/joint_json.h"
#include "models/reader/spatial/vector_reader.h"

namespace spoke::spatial {
namespace {

constexpr std::string_view kOfBeams[] = {"station", "diameter", "coefficient", "potential",
                                         "shadow"};
constexpr std::string_view kOfRigidBodies[] = {"area", "point"};

void visit_drag_stations(auto& drag, const auto& visit) {
  keys::visit_stations(keys::kBodyDragRows, drag, visit);
}

/// Refuses keys of the other kind of body.
void refuse(const TomlSection& section, const auto& keys, const char* kind) {
  for (const std::string_view key : keys)
    if (section.has(key))
      section.fail(key, std::string("would be ignored, expected only of a ") + kind);
}

Fault find_beam_fault(const BodyDrag& drag, double length) {
  const FirstFault first;
  const std::vector<double>& station = drag.station;
  first.numbers("station", station, {"m, from root to tip", 0.0, length});
  if (station.size() < 2)
    first.add({"station", "has " + std::to_string(station.size()) + ", expected 2 or more"});
  const auto at = std::adjacent_find(station.begin(), station.end(), std::greater_equal<>());
  if (at != station.end())
    first.add(
        {"station." + std::to_string(at - station.begin() + 2),
         "is " + describe(at[1]) + " after " + describe(at[0]) + ", expected a greater number"});
  visit_drag_stations(drag, [&](std::string_view key, const std::vector<double>& values,
                                const Quantity& quantity) {
    first.numbers(key, values, quantity);
    if (values.size() != station.size())
      first.add({std::string(key), "has " + std::to_string(values.size()) +
                                       (values.size() == 1 ? " value" : " values") + ", expected " +
                                       std::to_string(station.size()) + ", one for each station"});
  });
  if (drag.area != Vector::Zero() || drag.point != Vector::Zero())
    first.add({"area", "would be ignored, expected only of a rigid body"});
  return first.found();
}

Fault find_rigid_fault(const BodyDrag& drag) {
  const FirstFault first;
  first("area", drag.area, Quantity::not_negative("m^2"), Presence::required);
  first("point", drag.point, kLength, Presence::optional);
  if (!drag.station.empty() || !drag.diameter.empty() || !drag.coefficient.empty())
    first.add({"diameter", "would be ignored, expected only of a beam"});
  if (drag.potential != TowerPotential::none)
    first.add({"potential", "would be ignored, expected only of a beam"});
  if (drag.shadow != TowerShadow::none)
    first.add({"shadow", "would be ignored, expected only of a beam"});
  return first.found();
}

}  // namespace

BodyDrag read_drag(const TomlSection& body, const Body& of) {
  const TomlSection section = body.section("drag", keys::keys_of(keys::kBodyDragRows));
  BodyDrag drag;
  if (const auto* beam = std::get_if<Beam>(&of.shape)) {
    refuse(section, kOfRigidBodies, "rigid body");
    drag.station = section.has("station") ? section.increasing_numbers("station", kStation)
                                          : std::vector<double>{0.0, beam->length};
    if (!section.has("diameter"))
      section.fail("diameter", "is missing, expected a number, or one for each station");
    drag.coefficient.assign(drag.station.size(), 1.0);
    visit_drag_stations(
        drag, [&](std::string_view key, std::vector<double>& values, const Quantity& quantity) {
          read_stations(section, key, quantity, drag.station.size(), values);
        });
    for (const keys::Row& row : keys::kBodyDragRows)
      if (row.kind == keys::Row::Kind::choice) keys::read_row(section, row, &drag);
  } else {
    refuse(section, kOfBeams, "beam");
    if (!section.has("area")) section.fail("area", "is missing, expected an array of 3 numbers");
    keys::read(section, keys::kBodyDragRows, &drag);
  }
  Body checked = of;
  checked.drag = drag;
  if (const Fault fault = find_drag_fault(checked)) section.fail_at(fault.path, fault.text);
  return drag;
}

Fault find_drag_fault(const Body& body) {
  if (!body.drag) return {};
  if (const auto* beam = std::get_if<Beam>(&body.shape))
    return find_beam_fault(*body.drag, beam->length);
  if (std::holds_alternative<RigidBody>(body.shape)) return find_rigid_fault(*body.drag);
  return {"", "does not belong to kind \"solid\", expected a beam or a rigid body"};
}

Json drag_to_json(const BodyDrag& drag) {
  Json json;
  if (drag.station.empty()) {
    json.set("area", to_json(drag.area));
    json.set("point", to_json(drag.point));
    return json;
  }
  json.set("station", drag.station);
  visit_drag_stations(drag, [&](std::string_view key, const std::vector<double>& values,
                                const Quantity&) { json.set(std::string(key), values); });
  if (drag.potential != TowerPotential::none || drag.shadow != TowerShadow::none)
    keys::write_words(keys::kBodyDragRows, &drag, json);
  return json;
}

}  // namespace spoke::spatial
