// Writes what solid_reader.cpp reads.

#include "models/reader/spatial/solid_json.h"

#include <filesystem>
#include <string>
#include <variant>

#include "models/reader/spatial/field_writer.h"
#include "models/reader/spatial/joint_json.h"

namespace spoke::spatial {
namespace {

/// Returns a name of a file that leads to it from every folder.
std::string absolute(const std::string& file) {
  std::error_code error;
  const std::filesystem::path path = std::filesystem::absolute(file, error);
  return error ? file : path.lexically_normal().string();
}

template <class Files>
Json to_json(const Files& files) {
  Json json = Json::array();
  for (const std::string& file : files) json.push_back(absolute(file));
  return json;
}

template <class Nodes>
Json nodes_to_json(const char* key, const Nodes& nodes) {
  Json fields = Json::object();
  visit_fields(nodes, FieldWriter{fields});
  return {{key, fields}};
}

void add_matrices(const SolidMatrices& matrices, Json& json) {
  json.set("format", matrices.format);
  json.set("mass", absolute(matrices.mass));
  json.set("stiffness", absolute(matrices.stiffness));
  json.set("nodes", absolute(matrices.nodes));
  if (!matrices.own.front().empty())
    json.set("geometric_stiffness",
             {{"own", to_json(matrices.own)}, {"translation", to_json(matrices.translation)}});
}

}  // namespace

Json choice_to_json(const NodeChoice& choice) {
  if (const auto* name = std::get_if<std::string>(&choice)) return *name;
  if (const auto* plane = std::get_if<PlaneNodes>(&choice)) return nodes_to_json("plane", *plane);
  if (const auto* cylinder = std::get_if<CylinderNodes>(&choice))
    return nodes_to_json("cylinder", *cylinder);
  return nodes_to_json("box", std::get<BoxNodes>(choice));
}

void add_solid(const SolidBody& body, Json& json) {
  if (body.matrices) {
    add_matrices(*body.matrices, json);
  } else {
    // A mesh that was made in code has no file.
    json.set("mesh", body.file.empty() ? std::string() : absolute(body.file));
  }
  if (body.material) {
    Json material;
    visit_fields(*body.material, FieldWriter{material});
    json.set("material", material);
  }
  json.set("scale", {{"length", body.length_scale}});
  json.set("coordinates", name_of(body.coordinates));
  if (body.modes) json.set("modes", *body.modes);
  if (body.up_to) json.set("up_to", *body.up_to);
  json.set("geometric_stiffening", body.geometric_stiffening);
  if (!body.damping.empty()) json.set("damping", body.damping);
  json.set("reference_frame", name_of(body.frame));
  for (const SolidInterface& interface : body.interfaces) {
    Json table = {{"name", interface.name},
                  {"nodes", choice_to_json(interface.nodes)},
                  {"kind", name_of(interface.kind)}};
    if (interface.point) table.set("point", spatial::to_json(*interface.point));
    json.append("interface", table);
  }
}

}  // namespace spoke::spatial
