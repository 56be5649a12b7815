// Writes what loop_reader.cpp reads.

#include "models/reader/loop_json.h"

#include "models/reader/bearing_reader.h"
#include "models/reader/spatial/course_json.h"

namespace spoke {
namespace {

using spatial::place_shape;
using spatial::rotation_shape;

/// Sets what says a place elsewhere.
void add_elsewhere(const LoopPlace& place, Json& json) {
  if (place.subsystem.empty())
    json.set("blade", place.blade);
  else
    json.set("subsystem", place.subsystem);
  if (!place.name.empty()) json.set("body", place.name);
}

Json to_json(const LoopPlace& place, const LoopSurroundings& around) {
  Json json = Json::object();
  std::optional<double> station = place.station;
  switch (place.carrier) {
    case LoopPlace::Carrier::hub:
      json.set("body", around.base_name());
      break;
    case LoopPlace::Carrier::mount:
      json.set("body", "mount");
      break;
    case LoopPlace::Carrier::anchor:
      json.set("anchor", place.name);
      break;
    case LoopPlace::Carrier::body:
      if (!place.name.empty()) json.set("body", place.name);
      // A point alone would say the station.
      if (const LoopBody* body = around.find(place); body != nullptr && !station)
        station = body->length;
      break;
    case LoopPlace::Carrier::elsewhere:
      add_elsewhere(place, json);
      break;
  }
  if (station) json.set("station", *station);
  if (!place.interface.empty()) json.set("interface", place.interface);
  if (!place.point.isZero(0.0))
    json.set("point", spatial::to_json(place.point, place_shape(around.in_plane)));
  if (place.orientation)
    json.set("orientation", spatial::to_json(*place.orientation, rotation_shape(around.in_plane)));
  return json;
}

Json to_json(const Loop& loop, const LoopSurroundings& around) {
  const auto& shape = place_shape(around.in_plane);
  const int axes =
      around.in_plane ? (loop.kind == LoopKind::prismatic ? 1 : 0) : count_axes(loop.kind);
  Json json = {{"name", loop.name},
               {"kind", name_of(loop.kind)},
               {"from", to_json(loop.from, around)},
               {"to", to_json(loop.to, around)}};
  if (axes == 1) json.set("axis", spatial::to_json(loop.axes[0], shape));
  if (axes == 2)
    json.set("axes", Json::array({spatial::to_json(loop.axes[0], shape),
                                  spatial::to_json(loop.axes[1], shape)}));
  if (loop.length) json.set("length", *loop.length);
  if (!loop.stiffness.empty()) json.set("stiffness", loop.stiffness);
  if (!loop.damping.empty()) json.set("damping", loop.damping);
  if (loop.matrices) add_matrices(*loop.matrices, json);
  return json;
}

}  // namespace

void add_loops(const std::vector<Loop>& loops, const LoopSurroundings& around, Json& json) {
  for (const Loop& loop : loops) json.append("loop", to_json(loop, around));
}

Json to_json(const Anchor& anchor, bool in_plane) {
  Json json = {{"name", anchor.name},
               {"frame", name_of(anchor.frame)},
               {"turns_with_hub", anchor.turns_with_hub}};
  if (anchor.frame == Anchor::Frame::body) {
    json.set("frame", anchor.body);
    if (!anchor.subsystem.empty()) json.set("subsystem", anchor.subsystem);
    if (anchor.station) json.set("station", *anchor.station);
    if (!anchor.interface.empty()) json.set("interface", anchor.interface);
  }
  const auto& place = place_shape(in_plane);
  const auto& rotation = rotation_shape(in_plane);
  if (const auto* program = std::get_if<ProgramAnchorMotion>(&anchor.motion)) {
    json.set("motion", {{"by", "program"},
                        {"translation", spatial::to_json(program->translation, place)},
                        {"rotation", spatial::to_json(program->rotation, rotation)}});
    return json;
  }
  const auto& motion = std::get<spatial::MountMotion>(anchor.motion);
  json.set("motion", {{"translation", spatial::to_json(motion.translation, "m", place)},
                      {"rotation", spatial::to_json(motion.rotation, "rad", rotation)}});
  return json;
}

}  // namespace spoke
