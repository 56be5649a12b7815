// From the description of a solid to its constants, by way of the cache.

#include "models/solid/cache.h"
#include "models/solid/import.h"
#include "models/solid/memory.h"
#include "models/solid/solid.h"
#include "models/solid/solid_problem.h"
#include "spoke/error.h"

namespace spoke::solid {
namespace {

using space::SolidConstants;
using spatial::SolidBody;

/// A description with its geometry, and the matrices if they are of another program.
struct SolidInput {
  const SolidBody& body;
  SolidGeometry geometry;
  std::optional<ImportedMatrices> imported;
  std::vector<ChosenNodes> sets;
};

SolidInput read_input(const SolidBody& body, const SolidGeometry& at_rest, const LoadedSets& sets) {
  if (body.frame == spatial::SolidFrame::mean_axis &&
      body.coordinates == spatial::SolidCoordinates::nodal)
    throw InputError("is \"mean_axis\", expected \"clamped\" with the coordinates \"nodal\"",
                     {.key = "reference_frame"});
  SolidInput input{body, at_rest, {}, {}};
  if (body.matrices) {
    input.imported = read_matrices(*body.matrices, body.length_scale);
    // Their files are read again, and may not be what they were.
    input.geometry = make_geometry_of_matrices(body, *input.imported);
  }
  for (const spatial::NodeChoice& set : sets)
    input.sets.push_back(choose_nodes(*input.geometry.mesh, set));
  return input;
}

void add_nodes(const ChosenNodes& chosen, CacheKey& key) {
  key.add(chosen.nodes);
  key.add(chosen.weights);
  key.add(chosen.point.data(), 3 * sizeof(double));
  key.add(chosen.area);
}

void add_mesh(const spatial::SolidMesh& mesh, CacheKey& key) {
  key.add(static_cast<std::int64_t>(mesh.nodes.size()));
  for (const spatial::Vector& node : mesh.nodes) key.add(node.data(), 3 * sizeof(double));
  key.add(static_cast<std::int64_t>(mesh.elements.size()));
  for (const spatial::SolidElement& element : mesh.elements) {
    key.add(static_cast<std::int64_t>(element.kind));
    key.add(element.nodes.data(),
            sizeof(int) * static_cast<std::size_t>(spatial::count_nodes(element.kind)));
  }
  for (const auto& [node, mass] : mesh.masses) {
    key.add(std::int64_t{node});
    key.add(mass);
  }
}

/// Returns the hash of all that the constants follow from.
std::uint64_t make_key(const SolidInput& input) {
  CacheKey key;
  const SolidBody& body = input.body;
  add_mesh(*input.geometry.mesh, key);
  if (input.imported) {
    key.add(input.imported->m);
    key.add(input.imported->K);
    for (const Sparse& kg : input.imported->own) key.add(kg);
    for (const Sparse& kg : input.imported->translation) key.add(kg);
  } else {
    const spatial::SolidMaterial& material = input.geometry.material;
    for (const double value : {material.youngs_modulus, material.poissons_ratio, material.density})
      key.add(value);
  }
  key.add(std::int64_t{input.imported.has_value()});
  key.add(static_cast<std::int64_t>(body.coordinates));
  key.add(static_cast<std::int64_t>(body.frame));
  key.add(std::int64_t{body.geometric_stiffening});
  key.add(std::int64_t{body.modes.value_or(-1)});
  key.add(body.up_to.value_or(-1.0));
  for (std::size_t k = 0; k < body.interfaces.size(); ++k) {
    key.add(std::string_view(body.interfaces[k].name));
    key.add(static_cast<std::int64_t>(body.interfaces[k].kind));
    add_nodes(input.geometry.interfaces[k], key);
  }
  for (const ChosenNodes& set : input.sets) add_nodes(set, key);
  return key.value();
}

/// Returns nodes whose point is in B.
ChosenNodes move_to_frame(ChosenNodes chosen, const spatial::Vector& origin) {
  chosen.point -= origin;
  return chosen;
}

SolidProblem make_solid_problem(const SolidInput& input) {
  const SolidBody& body = input.body;
  const SolidGeometry& geometry = input.geometry;
  const spatial::Vector origin = geometry.interfaces.front().point;
  SolidProblem problem;
  for (const spatial::Vector& node : geometry.mesh->nodes)
    problem.nodes.emplace_back(node - origin);
  if (const auto& imported = input.imported) {
    problem.matrices = {imported->m, imported->K};
    if (imported->has_stresses()) {
      StressMatrices& stresses = problem.stresses.emplace();
      const auto take = [&](const auto& matrices, Eigen::MatrixXd& values) {
        values.resize(imported->m.nonZeros(), static_cast<Eigen::Index>(matrices.size()));
        for (std::size_t k = 0; k < matrices.size(); ++k)
          values.col(static_cast<Eigen::Index>(k)) = values_in_places_of(imported->m, matrices[k]);
      };
      take(imported->own, stresses.own);
      take(imported->translation, stresses.translation);
    }
  } else {
    problem.matrices = assemble(*geometry.mesh, geometry.material);
    problem.mesh = geometry.mesh;
    problem.material = geometry.material;
  }
  for (std::size_t k = 0; k < body.interfaces.size(); ++k)
    problem.interfaces.push_back({body.interfaces[k].name, body.interfaces[k].kind,
                                  move_to_frame(geometry.interfaces[k], origin)});
  for (const ChosenNodes& set : input.sets)
    problem.sets.push_back({"", spatial::InterfaceKind::average, move_to_frame(set, origin)});
  problem.coordinates = body.coordinates;
  problem.frame = body.frame;
  problem.modes = body.modes;
  problem.up_to = body.up_to;
  problem.is_stiffened = body.geometric_stiffening;
  return problem;
}

/// Adds what is not in the cache.
void complete(const SolidInput& input, SolidConstants& constants) {
  const SolidGeometry& geometry = input.geometry;
  const spatial::Vector& origin = geometry.interfaces.front().point;
  constants.nodes.clear();
  for (const spatial::Vector& node : geometry.mesh->nodes)
    constants.nodes.emplace_back(node - origin);
  if (!input.imported) {
    constants.mesh = geometry.mesh;
    constants.stress = make_stress_operator(*geometry.mesh, geometry.material);
  }
  constants.interfaces = static_cast<int>(input.body.interfaces.size());
  if (!input.imported) constants.youngs_modulus = geometry.material.youngs_modulus;
  set_damping(input.body.damping, constants);
  set_derived(constants);
}

}  // namespace

std::shared_ptr<const SolidConstants> make_constants(const SolidBody& body, const LoadedSets& sets,
                                                     const Control& control, CacheUse* cache) {
  return make_constants(body, make_geometry(body), sets, control, cache);
}

std::shared_ptr<const SolidConstants> make_constants(const SolidBody& body,
                                                     const SolidGeometry& at_rest,
                                                     const LoadedSets& sets, const Control& control,
                                                     CacheUse* cache) {
  const SolidInput input = read_input(body, at_rest, sets);
  const std::uint64_t key = make_key(input);
  const std::optional<std::filesystem::path> folder = find_cache_folder();
  const std::filesystem::path file = folder ? cache_file(*folder, key) : "";
  std::optional<SolidConstants> constants;
  if (folder && (!cache || cache->reads)) constants = read_constants(file, key);
  const bool was_read = constants.has_value();
  if (!was_read) {
    require_memory(body, input.geometry, control.memory);
    if (control.progress) control.progress("assemble", 0.0);
    constants = calc_constants(make_solid_problem(input), control);
  }
  complete(input, *constants);
  const bool was_written = folder && !was_read && write_constants(file, key, *constants);
  if (cache) {
    cache->was_read = was_read;
    cache->file = was_read || was_written ? file.string() : "";
  }
  return std::make_shared<const SolidConstants>(std::move(*constants));
}

}  // namespace spoke::solid
