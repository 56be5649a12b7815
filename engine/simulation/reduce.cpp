// Makes the constants of solids, and shows what is of interest to people.

#include "engine/reduce.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "engine/support/memory.h"
#include "models/reader/scenario_check.h"
#include "models/solid/mesh_check.h"
#include "models/space/solid.h"
#include "models/tree/solid_part.h"

namespace spoke {
namespace {

using spatial::SolidPart;

double bytes_of_matrix(const Eigen::MatrixXd& matrix) {
  return static_cast<double>(matrix.size() * sizeof(double));
}
template <class Matrices>
double bytes_of_matrices(const Matrices& matrices) {
  double bytes = 0.0;
  for (const auto& matrix : matrices) bytes += bytes_of_matrix(matrix);
  return bytes;
}
template <class Matrix>
double bytes_of_sparse(const Matrix& matrix) {
  return static_cast<double>(matrix.nonZeros() * (sizeof(double) + sizeof(int)));
}

double count_bytes(const space::ReducedSolid& solid) {
  double bytes = bytes_of_matrix(solid.shapes) + bytes_of_matrices(solid.m) +
                 bytes_of_matrices(solid.own) + bytes_of_matrices(solid.translation);
  for (const auto& place : solid.places) bytes += bytes_of_matrices(place);
  return bytes;
}

double count_bytes(const space::NodalSolid& solid) {
  double bytes = bytes_of_sparse(solid.m) + bytes_of_sparse(solid.K) + bytes_of_sparse(solid.Xi) +
                 bytes_of_matrices(solid.own) + bytes_of_matrices(solid.translation);
  for (const auto& place : solid.places) bytes += bytes_of_matrices(place);
  return bytes;
}

/// Returns the memory of constants, but for the smallest of them [bytes].
double count_bytes(const space::SolidConstants& constants) {
  const double own =
      std::visit([](const auto& matrices) { return count_bytes(matrices); }, constants.matrices);
  return own + bytes_of_sparse(constants.stress) + bytes_of_matrix(constants.strain_modes) +
         static_cast<double>(constants.nodes.size() * sizeof(space::Position));
}

void describe_rest(const SolidPart& part, SolidReduction& result) {
  const spatial::SolidBody& body = part.body();
  const solid::SolidGeometry& at_rest = part.geometry();
  result.kind = body.coordinates;
  result.file = body.matrices ? body.matrices->stiffness : body.file;
  result.mass = at_rest.mass;
  if (const spatial::SolidMesh* mesh = at_rest.mesh.get()) {
    result.elements = mesh->elements.size();
    result.labels = mesh->labels;
    result.has_locking_elements = solid::has_locking_elements(*mesh);
  }
  for (std::size_t i = 0; i < body.interfaces.size(); ++i) {
    const solid::ChosenNodes& chosen = at_rest.interfaces[i];
    result.interfaces.push_back({body.interfaces[i].name, body.interfaces[i].kind,
                                 chosen.nodes.size(), part.place_of(i), chosen.area});
  }
}

void describe_modes(const space::ReducedSolid& solid, SolidReduction& result) {
  for (Eigen::Index k = 0; k < solid.stiffness.size(); ++k) {
    const double w = std::sqrt(std::max(0.0, solid.stiffness[k]));
    result.frequencies.push_back(w / (2.0 * std::numbers::pi));
    result.damping_ratios.push_back(w > 0.0 ? solid.damping[k] / (2.0 * w) : 0.0);
    std::vector<Eigen::Vector3d>& shape = result.shapes.emplace_back();
    for (Eigen::Index i = 0; i < solid.shapes.rows(); i += 3)
      shape.emplace_back(solid.shapes.col(k).segment<3>(i));
  }
}

SolidReduction describe(const SolidPart& part, const solid::MadeConstants& made) {
  const space::SolidConstants& constants = *made.constants;
  SolidReduction result;
  describe_rest(part, result);
  result.coordinates = constants.coordinates;
  result.vibration_frequencies = constants.frequencies;
  result.nodes.assign(constants.nodes.begin(), constants.nodes.end());
  if (result.labels.empty())
    for (std::size_t i = 0; i < result.nodes.size(); ++i)
      result.labels.push_back(static_cast<int>(i + 1));
  if (const space::ReducedSolid* solid = constants.reduced()) describe_modes(*solid, result);
  result.seconds = made.seconds;
  result.memory_bytes = count_bytes(constants);
  result.was_cached = made.cache.was_read;
  result.cache_file = made.cache.file;
  return result;
}

}  // namespace

std::vector<SolidReduction> reduce(const Scenario& scenario, const ReduceOptions& options) {
  check_scenario(scenario);
  std::vector<SolidReduction> results;
  if (!scenario.space) return results;
  const spatial::SolidParts parts(*scenario.space);
  std::vector<const SolidPart*> made;  // by result
  for (const spatial::Subsystem& subsystem : scenario.space->subsystems)
    for (const spatial::Body& body : subsystem.bodies) {
      const auto* solid = std::get_if<spatial::SolidBody>(&body.shape);
      if (!solid) continue;
      const SolidPart& part = parts.of(*solid);
      const auto first = std::find(made.begin(), made.end(), &part);
      const auto same_as = static_cast<std::size_t>(first - made.begin());
      made.push_back(&part);
      if (same_as < results.size()) {
        results.push_back(results[same_as]);
      } else {
        results.push_back(describe(
            part, find_constants(part, {options.progress, available_memory()}, options.anew)));
      }
      results.back().same_as = same_as;
      results.back().subsystem = subsystem.name;
      results.back().body = body.name;
    }
  return results;
}

}  // namespace spoke
