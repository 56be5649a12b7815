#include "models/solid/memory.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "spoke/error.h"

namespace spoke::solid {
namespace {

constexpr double kNumber = sizeof(double);
/// Of a number in a sparse matrix, with its row.
constexpr double kEntry = kNumber + sizeof(int);

/// Nodes that a node shares elements with, in meshes of many elements.
constexpr double kNeighbours = 30.0;

std::string gigabytes(double bytes) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f GB", bytes / 1e9);
  return text;
}

[[noreturn]] void refuse_memory(double needed, double memory, const std::string& key = "mesh",
                                const std::string& remedy = "use a coarser mesh") {
  throw InputError("needs " + gigabytes(needed) + " of memory, expected at most " +
                       gigabytes(0.8 * memory) + " on this machine: " + remedy,
                   {{}, 0, 0, key});
}

/// Entries of the Cholesky factor: those of a compact body, of which slender ones have a half.
double estimate_factor_entries(double unknowns) { return 30.0 * std::pow(unknowns, 4.0 / 3.0); }

/// Columns of 3 n numbers that are held at once while so many modes and shapes are made.
double estimate_mode_columns(double modes) { return 10.0 * modes + 100.0; }

/// Columns of 3 n numbers that are held at once.
double estimate_columns(const spatial::SolidBody& body) {
  const double interfaces = static_cast<double>(body.interfaces.size());
  if (body.coordinates == spatial::SolidCoordinates::nodal) return 6.0 * (interfaces + 2.0);
  // How many there are up to a frequency is seen when they are found: require_mode_memory().
  return estimate_mode_columns(body.modes.value_or(spatial::kUsualModes) + 6.0 * interfaces);
}

}  // namespace

double estimate_memory(const spatial::SolidBody& body, const SolidGeometry& geometry) {
  const double n = geometry.mesh ? static_cast<double>(geometry.mesh->nodes.size()) : 0.0;
  const bool is_reduced = body.coordinates == spatial::SolidCoordinates::reduced;
  double bytes = kEntry * n * kNeighbours * (1.0 + 3.0 * 9.0 + 18.0);  // m, K and its projections
  if (is_reduced || body.geometric_stiffening)
    bytes += 1.2 * kEntry * estimate_factor_entries(3.0 * n);
  bytes += kNumber * 3.0 * n * estimate_columns(body);
  if (body.geometric_stiffening)
    bytes += kNumber * n * kNeighbours * (9.0 + 6.0 * static_cast<double>(body.interfaces.size()));
  return bytes;
}

void require_factor_memory(double entries, double memory) {
  const double needed = kEntry * entries;
  if (!(needed < 0.8 * memory)) refuse_memory(needed, memory);
}

void require_mode_memory(double modes, double unknowns, double memory) {
  const double needed = kNumber * unknowns * estimate_mode_columns(modes);
  if (!(needed < 0.8 * memory))
    refuse_memory(needed, memory, "up_to", "use a lower frequency, or a coarser mesh");
}

void require_memory(const spatial::SolidBody& body, const SolidGeometry& geometry, double memory) {
  const double needed = estimate_memory(body, geometry);
  if (!(needed < 0.8 * memory)) refuse_memory(needed, memory);
}

}  // namespace spoke::solid
