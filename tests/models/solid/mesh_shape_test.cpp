// Elements that are folded over where no point of integration is.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "models/solid/elements.h"
#include "models/solid/mesh_check.h"
#include "models/solid/parse_mesh.h"
#include "tests/message_of.h"
#include "tests/models/solid/grid_mesh.h"

using namespace spoke;
using namespace spoke::test;
using spatial::ElementKind;
using spatial::SolidMesh;
using spatial::Vector;

namespace {

std::string fault_of(const SolidMesh& mesh) {
  return message_of([&] { solid::check_mesh(mesh); });
}

/// One element, a unit cube or a tetrahedron in its corner, its nodes in the element's order.
SolidMesh make_element(ElementKind kind) {
  SolidMesh mesh;
  spatial::SolidElement element{.kind = kind};
  for (int n = 0; n < count_nodes(kind); ++n) {
    element.nodes[static_cast<std::size_t>(n)] = n;
    mesh.nodes.push_back(solid::parent_place(kind, n));
  }
  mesh.elements = {element};
  return mesh;
}

/// Moves the first mid node along its edge, from 0 to 1, to a share of it from corner 0.
SolidMesh with_mid_node_at(ElementKind kind, double share) {
  SolidMesh mesh = make_element(kind);
  const std::size_t mid = kind == ElementKind::tet10 ? 4 : 8;
  mesh.nodes[mid] = mesh.nodes[0] + share * (mesh.nodes[1] - mesh.nodes[0]);
  return mesh;
}

}  // namespace

TEST_CASE("a mid node beyond a quarter of its edge folds the corner, at a quarter it is allowed") {
  // dx by the edge's coordinate, from 0 to 1, is 4 share - 1 of the edge's length at its corner.
  for (const ElementKind kind : {ElementKind::tet10, ElementKind::hex20})
    for (const double share : {0.22, 0.24, 0.25, 0.3, 0.5, 0.75, 0.76}) {
      CAPTURE(std::string(name_of(kind)));
      CAPTURE(share);
      const SolidMesh mesh = with_mid_node_at(kind, share);
      const auto x = solid::places_of(mesh, mesh.elements[0]);
      CHECK(solid::least_volume_ratio(kind, x) > 0.0);
      const bool is_folded = share < 0.25 || share > 0.75;
      const double least = solid::least_volume_at_nodes(kind, x).ratio;
      const double expected = 4.0 * std::min(share, 1.0 - share) - 1.0;
      if (expected < 0.0) CHECK(least == doctest::Approx(expected).epsilon(1e-12));
      const std::string node = share < 0.5 ? "1" : "2";
      CHECK(fault_of(mesh) ==
            (is_folded ? "the " + std::string(name_of(kind)) +
                             " (volume element 1) is inverted near node " + node +
                             ", expected a positive volume everywhere in it: mid nodes within a "
                             "quarter of their edge from its middle, and nodes in the order of the "
                             "format"
                       : "no error"));
    }
}

TEST_CASE("a hex20 with two corners swapped is refused, whichever they are") {
  for (int a = 0; a < 8; ++a)
    for (int b = a + 1; b < 8; ++b) {
      CAPTURE(a);
      CAPTURE(b);
      SolidMesh mesh = make_element(ElementKind::hex20);
      std::swap(mesh.elements[0].nodes[static_cast<std::size_t>(a)],
                mesh.elements[0].nodes[static_cast<std::size_t>(b)]);
      CHECK(fault_of(mesh) != "no error");
    }
}
