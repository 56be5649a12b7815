#include "engine/output/scene/mesh_surface.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>

#include "engine/output/scene/coarsen.h"
#include "tests/engine/output/scene/solid_bars.h"

using namespace spoke;
using namespace spoke::scene;
using namespace spoke::test;

namespace {

/// Returns the volume within a closed surface that looks out.
double volume_of(const std::vector<Vector>& points, const std::vector<Triangle>& triangles) {
  const auto point = [&](int k) { return points[static_cast<std::size_t>(k)]; };
  double volume = 0.0;
  for (const Triangle& t : triangles)
    volume += point(t[0]).dot(point(t[1]).cross(point(t[2]))) / 6.0;
  return volume;
}

/// Whether each edge is passed once in each direction.
bool is_closed(const std::vector<Triangle>& triangles) {
  std::map<std::pair<int, int>, int> passes;
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) ++passes[{t[k], t[(k + 1) % 3]}];
  for (const auto& [edge, count] : passes) {
    const auto back = passes.find({edge.second, edge.first});
    if (count != 1 || back == passes.end()) return false;
  }
  return true;
}

SolidView view_of(const GridMesh& grid) {
  return {std::make_shared<spatial::SolidMesh>(make_grid_mesh(grid)), Vector::Zero(), nullptr};
}

/// An L of two legs, 1 m each and 0.2 m thick.
GridMesh make_angle(int n) {
  GridMesh grid{{5 * n, n, 5 * n}, {1.0, 0.2, 1.0}, spatial::ElementKind::tet10};
  grid.keeps = [n](int i, int, int k) { return i < n || k < n; };
  return grid;
}

}  // namespace

TEST_CASE("the surface of a small mesh has all nodes of its surface, and looks out") {
  for (const auto kind : {spatial::ElementKind::tet10, spatial::ElementKind::hex20}) {
    GridMesh grid{{3, 2, 1}, {3.0, 2.0, 1.0}, kind};
    const Surface surface = make_surface(view_of(grid), 1500);
    CHECK(is_closed(surface.triangles));
    CHECK(volume_of(surface.places, surface.triangles) == doctest::Approx(6.0));
    // Faces of 2 x 2 half cells: all points of the grid, without the middles of hexahedra's faces.
    const std::size_t grid_points = 7 * 5 * 3 - 5 * 3 * 1;
    CHECK(surface.places.size() ==
          (kind == spatial::ElementKind::tet10 ? grid_points : grid_points - 2 * (6 + 3 + 2)));
    double length = 0.0;
    for (const auto& edge : surface.edges)
      length += (surface.places[static_cast<std::size_t>(edge[0])] -
                 surface.places[static_cast<std::size_t>(edge[1])])
                    .norm();
    CHECK(length == doctest::Approx(4.0 * 6.0));
  }
}

TEST_CASE("the surface of a large mesh is coarser, of the same shape") {
  const SolidView angle = view_of(make_angle(5));
  const Surface surface = make_surface(angle, 300);
  CHECK(surface.nodes.size() <= 302);
  CHECK(surface.triangles.size() <= 600);
  CHECK(surface.triangles.size() > 500);
  CHECK(is_closed(surface.triangles));
  CHECK(volume_of(surface.places, surface.triangles) == doctest::Approx(0.2 * 0.36).epsilon(1e-9));
  for (std::size_t k = 0; k < surface.nodes.size(); ++k)
    CHECK((surface.places[k] - angle.mesh->nodes[static_cast<std::size_t>(surface.nodes[k])])
              .norm() == 0.0);
  // Triangles are alike: in a plane none is needed, but colours want some everywhere.
  double longest = 0.0;
  for (const Triangle& t : surface.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(longest, (surface.places[static_cast<std::size_t>(t[k])] -
                                   surface.places[static_cast<std::size_t>(t[(k + 1) % 3])])
                                      .norm());
  CHECK(longest < 0.35);
}

TEST_CASE("a coarse sphere keeps its volume") {
  // A box's surface, blown up.
  GridMesh grid{{12, 12, 12}, {2.0, 2.0, 2.0}, spatial::ElementKind::hex8, {-1.0, -1.0, -1.0}};
  auto mesh = std::make_shared<spatial::SolidMesh>(make_grid_mesh(grid));
  for (Vector& p : mesh->nodes) p *= p.cwiseAbs().maxCoeff() / std::max(1e-12, p.norm());
  const Surface fine = make_surface({mesh, Vector::Zero(), nullptr}, 1500);
  const Surface coarse = make_surface({mesh, Vector::Zero(), nullptr}, 250);
  CHECK(coarse.triangles.size() <= 500);
  CHECK(is_closed(coarse.triangles));
  const double volume = volume_of(fine.places, fine.triangles);
  CHECK(volume_of(coarse.places, coarse.triangles) == doctest::Approx(volume).epsilon(0.02));
  for (const Vector& p : coarse.places) CHECK(p.norm() == doctest::Approx(1.0));
}

TEST_CASE("reduced solids of many modes and many nodal ones draw fewer nodes") {
  space::SolidConstants solid;
  solid.matrices = space::ReducedSolid{};
  solid.coordinates = 20;
  CHECK(count_drawn_nodes(&solid, 0, 2000) == 1500);
  solid.coordinates = 60;
  CHECK(count_drawn_nodes(&solid, 0, 2000) == 500);
  solid.matrices = space::NodalSolid{};
  CHECK(count_drawn_nodes(&solid, 3, 2000) == 500);
  CHECK(count_drawn_nodes(&solid, 3, 400) == 100);
}
