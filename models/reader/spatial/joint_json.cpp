// Writes a number where a joint has one coordinate, otherwise an array with one number for each; a
// prescribed coordinate has only its motion; those of bushings are zero where they are held.

#include "models/reader/spatial/joint_json.h"

#include <string_view>
#include <utility>
#include <vector>

#include "models/reader/spatial/spatial_fields.h"

namespace spoke::spatial {
namespace {

std::size_t count_of(const Joint& joint) {
  return static_cast<std::size_t>(count_coordinates(joint.kind));
}

Json to_json(const Motion& motion) {
  if (const auto* azimuth = std::get_if<AzimuthMotion>(&motion))
    return {{"mean", azimuth->mean}, {"cosine", azimuth->cosine}, {"sine", azimuth->sine}};
  if (const auto* program = std::get_if<ProgramMotion>(&motion))
    return {{"by", "program"}, {"initial", program->initial}};
  const Curve& value = std::get<MotionTable>(motion).value;
  if (value.times().size() == 1) return {{"constant", value.values().front()}};
  return {{"time", value.times()}, {"value", value.values()}};
}

/// Of a stop or a relaxation.
template <class Item>
Json to_json(const Item& item) {
  Json json;
  visit_fields(item, kAngleUnits, [&](const char* key, double value, const Quantity&, Presence) {
    json.set(key, value);
  });
  return json;
}

Json to_json(const Friction& friction) {
  Json json{{"force", friction.force}, {"speed", friction.speed}};
  if (friction.static_force) json.set("static", *friction.static_force);
  if (friction.stribeck) json.set("stribeck", *friction.stribeck);
  return json;
}

/// Adds the numbers of all coordinates.
void add_numbers(const Joint& joint, Json& json) {
  const std::size_t count = count_of(joint);
  const bool is_spherical = joint.kind == JointKind::spherical;
  for (std::size_t i = 0; i < count; ++i)
    visit_fields(joint.coordinates[i], kAngleUnits,
                 [&](std::string_view key, double value, const Quantity&) {
                   if (is_spherical && key == "rest") return;
                   if (count == 1 || (is_spherical && (key == "stiffness" || key == "damping"))) {
                     json.set(key, value);
                   } else {
                     json.append(key, value);
                   }
                 });
}

/// Adds the efforts of `count` coordinates from `first` on. Curves from files have equal times;
/// others are taken at the times of the first.
void add_effort(const char* key, const JointCoordinate* first, std::size_t count, Json& json) {
  const std::vector<double>& times = first->effort.times();
  const auto values_at = [&](std::size_t k) {
    if (count == 1) return Json(first->effort.values()[k]);
    Json row = Json::array();
    for (std::size_t i = 0; i < count; ++i) row.push_back(first[i].effort.value(times[k]));
    return row;
  };
  if (times.size() == 1) {
    json.set(key, values_at(0));
    return;
  }
  Json values = Json::array();
  for (std::size_t k = 0; k < times.size(); ++k) values.push_back(values_at(k));
  json.set(key, {{"time", times}, {"value", values}});
}

/// Adds a table for each coordinate, under a key; nothing if none has one.
template <class Item>
void add_tables(const char* key, const Joint& joint, std::optional<Item> JointCoordinate::*member,
                Json& json) {
  std::vector<Json> tables;
  bool is_any = false;
  for (std::size_t i = 0; i < count_of(joint); ++i) {
    const std::optional<Item>& item = joint.coordinates[i].*member;
    tables.push_back(item ? to_json(*item) : Json::object());
    is_any = is_any || item;
  }
  if (!is_any) return;
  if (tables.size() == 1) {
    json.set(key, std::move(tables[0]));
    return;
  }
  for (Json& table : tables) json.append(key, std::move(table));
}

}  // namespace

Json to_json(const Vector& v) { return Json::array({v.x(), v.y(), v.z()}); }

void add_joint(const Joint& joint, Json& json) {
  if (!joint.name.empty()) json.set("name", joint.name);
  json.set("kind", name_of(joint.kind));
  if (count_axes(joint.kind) == 1) json.set("axis", to_json(joint.axes[0]));
  if (count_axes(joint.kind) == 2)
    json.set("axes", Json::array({to_json(joint.axes[0]), to_json(joint.axes[1])}));
  json.set("offset", to_json(joint.offset));
  json.set("orientation", to_json(joint.orientation));
  const std::size_t count = count_of(joint);
  if (count == 0) return;
  add_numbers(joint, json);
  for (std::size_t c = 0; c < count; ++c)
    if (joint.coordinates[c].moves_freely) json.append("free", std::string(kBushingDirections[c]));
  if (joint.hold) json.set("hold", true);
  add_tables("relaxation", joint, &JointCoordinate::relaxation, json);
  if (joint.kind == JointKind::bushing) return;  // its other keys follow from its springs
  const std::size_t ways = slides(joint.kind, static_cast<int>(count) - 1) ? 1 : 0;
  if (count > ways) add_effort("torque", joint.coordinates.data(), count - ways, json);
  if (ways > 0) add_effort("force", joint.coordinates.data() + count - 1, 1, json);
  add_tables("stop", joint, &JointCoordinate::stop, json);
  add_tables("friction", joint, &JointCoordinate::friction, json);
  add_tables("motion", joint, &JointCoordinate::motion, json);
}

}  // namespace spoke::spatial
