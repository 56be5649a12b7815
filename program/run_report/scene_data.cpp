// Writes nodes, strips, solids and marks, their many numbers in base64.

#include "program/run_report/scene_data.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

#include "engine/bodies/space/solid_output.h"
#include "program/run_report/base64.h"

namespace spoke::run_report {
namespace {

using scene::Vector;

void append(const Vector& v, std::vector<float>& numbers) {
  for (const double x : v) numbers.push_back(static_cast<float>(x));
}

constexpr double kMostShare = 32767.0;

/// Returns the nearest number of units.
std::int16_t share_of(double value, float unit) {
  return static_cast<std::int16_t>(
      std::clamp(std::round(value / static_cast<double>(unit)), -kMostShare, kMostShare));
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

/// Describes a map from coordinates by 16-bit shares of the largest number of each column.
Json describe(const space::NodeRecovery::Dense& map) {
  std::vector<float> units;
  for (Eigen::Index c = 0; c < map.cols(); ++c) {
    const double largest = map.rows() > 0 ? map.col(c).cwiseAbs().maxCoeff() : 0.0;
    units.push_back(static_cast<float>(largest > 0.0 ? largest / kMostShare : 1.0));
  }
  std::vector<std::int16_t> shares;
  for (Eigen::Index row = 0; row < map.rows(); ++row)
    for (Eigen::Index c = 0; c < map.cols(); ++c)
      shares.push_back(share_of(map(row, c), units[static_cast<std::size_t>(c)]));
  return {{"units", encode(units)}, {"shares", encode(shares)}};
}

Json describe(const scene::Surface& surface) {
  std::vector<float> places;
  for (const Vector& p : surface.places) append(p, places);
  std::vector<std::int16_t> triangles, edges;
  for (const auto& triangle : surface.triangles)
    for (const int corner : triangle) triangles.push_back(static_cast<std::int16_t>(corner));
  for (const auto& edge : surface.edges)
    for (const int end : edge) edges.push_back(static_cast<std::int16_t>(end));
  const space::NodeRecovery* recovery = surface.recovery.get();
  Json described = {{"places", encode(places)},
                    {"triangles", encode(triangles)},
                    {"edges", encode(edges)},
                    {"hasStress", recovery && recovery->has_stress()}};
  if (recovery && recovery->is_reduced()) {
    described.set("shapes", describe(recovery->shapes()));
    if (recovery->has_stress()) described.set("stresses", describe(recovery->stresses()));
  }
  return described;
}

/// Describes a solid; `frame`: the node of its frame.
Json describe(const scene::MeshBody& mesh, const scene::Node& frame) {
  Json interfaces = Json::array(), axes = Json::array();
  for (const scene::InterfaceMark& mark : mesh.interfaces)
    interfaces.push_back({{"name", mark.name}, {"node", mark.node}});
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) axes.push_back(frame.axes(row, column));
  return {{"name", mesh.name},       {"tree", mesh.subsystem}, {"node", mesh.node},
          {"surface", mesh.surface}, {"axes", axes},           {"interfaces", interfaces}};
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

/// Describes the hubs besides the first: each one's node, its group, and those of what it carries.
Json describe_other_hubs(const scene::Scene& scene) {
  Json hubs = Json::array();
  for (std::size_t r = 1; r < scene.hubs.size(); ++r) {
    const scene::HubFrame& hub = scene.hubs[r];
    std::set<int> groups{hub.group};
    for (std::size_t k = 0; k < scene.nodes.size(); ++k)
      if (scene.roots[static_cast<std::size_t>(scene.sources[k].subsystem)] == hub.group)
        groups.insert(scene.nodes[k].group);
    hubs.push_back({{"group", hub.group},
                    {"node", hub.node},
                    {"groups", std::vector<int>(groups.begin(), groups.end())}});
  }
  return hubs;
}

}  // namespace

Json describe_scene(const scene::Scene& scene) {
  std::vector<float> nodes;
  std::vector<std::int16_t> groups;
  for (const scene::Node& node : scene.nodes) {
    append(node.p, nodes);
    groups.push_back(static_cast<std::int16_t>(node.group));
  }
  Json meshes = Json::array();
  for (const scene::MeshBody& mesh : scene.meshes)
    meshes.push_back(describe(mesh, scene.nodes[static_cast<std::size_t>(mesh.node)]));
  Json described = {{"isPlanar", scene.is_planar},
                    {"axis", json_of(scene.axis)},
                    {"gravity", json_of(scene.gravity)},
                    {"groups", scene.groups},
                    {"trees", scene.subsystems},
                    {"tips", scene.tips},
                    {"nodes", encode(nodes)},
                    {"nodeGroups", encode(groups)},
                    {"strips", describe_all(scene.strips)},
                    {"solids", describe_all(scene.solids)},
                    {"surfaces", describe_all(scene.surfaces)},
                    {"meshes", meshes},
                    {"links", describe_all(scene.links)},
                    {"joints", describe_all(scene.joints)},
                    {"loops", describe_all(scene.loops)},
                    {"loads", describe_all(scene.loads)},
                    {"sensors", describe_all(scene.sensors)}};
  if (scene.support >= 0)
    described.set("base", {{"group", scene.base_group},
                           {"hub", scene.hubs.front().node},
                           {"hubs", describe_other_hubs(scene)}});
  return described;
}

void append_numbers(const scene::Surface& surface, const std::vector<double>& coordinates,
                    std::vector<float>& numbers) {
  if (!surface.recovery) return;
  const space::NodeRecovery& recovery = *surface.recovery;
  const double* q = coordinates.data();
  if (recovery.is_reduced()) {
    for (const double value : coordinates) numbers.push_back(static_cast<float>(value));
    return;
  }
  for (int k = 0; k < recovery.size(); ++k) append(recovery.displacement(k, q), numbers);
  for (int k = 0; k < recovery.size(); ++k)
    numbers.push_back(recovery.has_stress() ? static_cast<float>(recovery.von_mises(k, q)) : 0.0F);
}

void append_pose(const spatial::Placement& pose, std::vector<float>& numbers) {
  append(pose.position, numbers);
  const Eigen::Quaterniond q(pose.rotation);
  for (const double x : {q.w(), q.x(), q.y(), q.z()}) numbers.push_back(static_cast<float>(x));
}

}  // namespace spoke::run_report
