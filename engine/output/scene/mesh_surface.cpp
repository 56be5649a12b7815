// Chooses the triangles of a solid that are drawn.

#include "engine/output/scene/mesh_surface.h"

#include <algorithm>
#include <array>

#include "engine/bodies/space/solid_output.h"
#include "engine/output/scene/coarsen.h"
#include "models/solid/surface.h"

namespace spoke::scene {
namespace {

constexpr std::size_t kMostDrawn = 1500;  // nodes of a solid
/// Numbers of the maps of a surface from modal coordinates to displacements and stresses.
constexpr std::size_t kMostOfMaps = 270000;
constexpr std::size_t kFewestDrawn = 100;

/// Returns triangles of the corners of faces.
std::vector<Triangle> split_by_corners(const std::vector<solid::SurfaceFace>& faces) {
  std::vector<Triangle> triangles;
  for (const solid::SurfaceFace& surface : faces) {
    const auto& n = surface.face.nodes;
    triangles.push_back({n[0], n[1], n[2]});
    if (surface.face.count == 4 || surface.face.count == 8) triangles.push_back({n[0], n[2], n[3]});
  }
  return triangles;
}

/// Numbers the points of triangles among themselves; returns the points, ascending.
std::vector<int> number_nodes(std::vector<Triangle>& triangles) {
  std::vector<int> nodes;
  for (const Triangle& triangle : triangles)
    nodes.insert(nodes.end(), triangle.begin(), triangle.end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  for (Triangle& triangle : triangles)
    for (int& corner : triangle)
      corner =
          static_cast<int>(std::lower_bound(nodes.begin(), nodes.end(), corner) - nodes.begin());
  return nodes;
}

std::vector<Triangle> choose_triangles(const spatial::SolidMesh& mesh, std::size_t most) {
  const std::vector<solid::SurfaceFace> faces = solid::find_surface(mesh);
  std::vector<Triangle> all = solid::split_into_triangles(faces);
  return all.size() <= most ? all : coarsen(mesh.nodes, split_by_corners(faces), most);
}

}  // namespace

std::size_t Surface::frame_numbers() const {
  if (!recovery) return 0;
  return recovery->is_reduced() ? static_cast<std::size_t>(recovery->coordinates())
                                : 4 * nodes.size();
}

std::size_t count_drawn_nodes(const space::SolidConstants* solid, std::size_t nodal_solids,
                              std::size_t most_nodes) {
  if (!solid) return kMostDrawn;
  std::size_t most = kMostDrawn;
  if (solid->nodal())
    most = std::min(most, 3 * most_nodes / 4) / std::max<std::size_t>(1, nodal_solids);
  else
    most = std::min(most,
                    kMostOfMaps / (9 * static_cast<std::size_t>(std::max(1, solid->coordinates))));
  return std::max(most, kFewestDrawn);
}

Surface make_surface(const SolidView& solid, std::size_t most_nodes) {
  Surface surface;
  if (!solid.mesh) return surface;
  surface.triangles = choose_triangles(*solid.mesh, 2 * most_nodes);
  surface.nodes = number_nodes(surface.triangles);
  for (const int node : surface.nodes)
    surface.places.emplace_back(solid.mesh->nodes[static_cast<std::size_t>(node)] - solid.origin);
  surface.edges = find_sharp_edges(surface.places, surface.triangles);
  if (solid.constants)
    surface.recovery = std::make_shared<space::NodeRecovery>(*solid.constants, surface.nodes);
  return surface;
}

}  // namespace spoke::scene
