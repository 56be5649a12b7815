// Writes nodes, strips, solids and marks, their many numbers in base64.

#include "program/run_report/scene_data.h"

#include <Eigen/Geometry>

#include "program/run_report/base64.h"

namespace spoke::run_report {
namespace {

using scene::Vector;

void append(const Vector& v, std::vector<float>& numbers) {
  for (const double x : v) numbers.push_back(static_cast<float>(x));
}

Json json_of(const Vector& v) { return std::vector<double>{v.x(), v.y(), v.z()}; }

/// Returns the members of a place followed by those of `own`.
Json with_place(const scene::Place& at, Json own) {
  own.set("node", at.node);
  own.set("xi", at.xi);
  own.set("p", json_of(at.p));
  if (at.group > 0) own.set("group", at.group);
  return own;
}

Json describe(const scene::Strip& strip) {
  std::vector<float> rings;
  for (const scene::Ring& ring : strip.rings) {
    rings.push_back(static_cast<float>(ring.at.node));
    rings.push_back(static_cast<float>(ring.at.xi));
    append(ring.at.p, rings);
    append(ring.y, rings);
    append(ring.z, rings);
    rings.push_back(static_cast<float>(ring.half_y));
    rings.push_back(static_cast<float>(ring.half_z));
  }
  return {{"name", strip.name},
          {"tree", strip.subsystem},
          {"first", strip.first},
          {"nodes", strip.nodes},
          {"rings", encode(rings)}};
}

Json describe(const scene::Solid& solid) {
  std::vector<float> vertices;
  for (const Vector& vertex : solid.vertices) append(vertex, vertices);
  Json faces = Json::array();
  for (const std::vector<int>& face : solid.faces) faces.push_back(face);
  return {{"name", solid.name},   {"tree", solid.subsystem},      {"node", solid.node},
          {"group", solid.group}, {"vertices", encode(vertices)}, {"faces", faces}};
}

Json describe(const scene::Link& link) {
  return {{"tree", link.subsystem},
          {"node", link.node},
          {"from", json_of(link.from)},
          {"to", json_of(link.to)}};
}

Json describe(const scene::JointMark& joint) {
  Json axes = Json::array();
  for (const Vector& axis : joint.axes) axes.push_back(json_of(axis));
  return {{"name", joint.name},
          {"kind", joint.kind},
          {"node", joint.node},
          {"axes", axes},
          {"coordinates", joint.coordinates}};
}

Json describe(const scene::LoopMark& loop) {
  Json axes = Json::array();
  for (const Vector& axis : loop.axes) axes.push_back(json_of(axis));
  return {{"name", loop.name},
          {"kind", loop.kind},
          {"tree", loop.subsystem},
          {"from", with_place(loop.from, Json::object())},
          {"to", with_place(loop.to, Json::object())},
          {"axes", axes},
          {"isSprung", loop.is_sprung}};
}

Json describe(const scene::LoadMark& load) {
  return with_place(load.at, {{"frame", load.frame},
                              {"force", json_of(load.force)},
                              {"moment", json_of(load.moment)},
                              {"isDistributed", load.is_distributed}});
}

Json describe(const scene::SensorMark& sensor) {
  return with_place(sensor.at, {{"name", sensor.name}});
}

template <class Part>
Json describe_all(const std::vector<Part>& parts) {
  Json all = Json::array();
  for (const Part& part : parts) all.push_back(describe(part));
  return all;
}

}  // namespace

Json describe_scene(const scene::Scene& scene) {
  std::vector<float> nodes;
  std::vector<std::int16_t> groups;
  for (const scene::Node& node : scene.nodes) {
    append(node.p, nodes);
    groups.push_back(static_cast<std::int16_t>(node.group));
  }
  return {{"isPlanar", scene.is_planar},
          {"axis", json_of(scene.axis)},
          {"gravity", json_of(scene.gravity)},
          {"groups", scene.groups},
          {"trees", scene.subsystems},
          {"tips", scene.tips},
          {"nodes", encode(nodes)},
          {"nodeGroups", encode(groups)},
          {"strips", describe_all(scene.strips)},
          {"solids", describe_all(scene.solids)},
          {"links", describe_all(scene.links)},
          {"joints", describe_all(scene.joints)},
          {"loops", describe_all(scene.loops)},
          {"loads", describe_all(scene.loads)},
          {"sensors", describe_all(scene.sensors)}};
}

void append_pose(const spatial::Placement& pose, std::vector<float>& numbers) {
  append(pose.position, numbers);
  const Eigen::Quaterniond q(pose.rotation);
  for (const double x : {q.w(), q.x(), q.y(), q.z()}) numbers.push_back(static_cast<float>(x));
}

}  // namespace spoke::run_report
