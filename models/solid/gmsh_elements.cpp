// Numbers of gmsh's elements, and where their mid nodes stand.

#include "models/solid/gmsh_elements.h"

#include <cstddef>

namespace spoke::solid {
namespace {

struct Numbered {
  int type;
  GmshElement element;
};
constexpr Numbered kGmshElements[] = {
    {1, {"line of 2 nodes", 1, 2, true}},
    {2, {"triangle of 3 nodes", 2, 3, true}},
    {3, {"quadrilateral of 4 nodes", 2, 4, true}},
    {4, {"tetrahedron of 4 nodes", 3, 4, true}},
    {5, {"hexahedron of 8 nodes", 3, 8, true}},
    {6, {"prism of 6 nodes", 3, 6, false}},
    {7, {"pyramid of 5 nodes", 3, 5, false}},
    {8, {"line of 3 nodes", 1, 3, true}},
    {9, {"triangle of 6 nodes", 2, 6, true}},
    {10, {"quadrilateral of 9 nodes", 2, 9, false}},
    {11, {"tetrahedron of 10 nodes", 3, 10, true}},
    {12, {"hexahedron of 27 nodes", 3, 27, false}},
    {13, {"prism of 18 nodes", 3, 18, false}},
    {14, {"pyramid of 14 nodes", 3, 14, false}},
    {15, {"point", 0, 1, true}},
    {16, {"quadrilateral of 8 nodes", 2, 8, true}},
    {17, {"hexahedron of 20 nodes", 3, 20, true}},
    {18, {"prism of 15 nodes", 3, 15, false}},
    {19, {"pyramid of 13 nodes", 3, 13, false}},
    {20, {"triangle of 9 nodes", 2, 9, false}},
    {21, {"triangle of 10 nodes", 2, 10, false}},
    {26, {"line of 4 nodes", 1, 4, true}},
    {27, {"line of 5 nodes", 1, 5, true}},
    {28, {"line of 6 nodes", 1, 6, true}},
    {29, {"tetrahedron of 20 nodes", 3, 20, false}},
    {30, {"tetrahedron of 35 nodes", 3, 35, false}},
    {31, {"tetrahedron of 56 nodes", 3, 56, false}},
    {92, {"hexahedron of 64 nodes", 3, 64, false}},
    {93, {"hexahedron of 125 nodes", 3, 125, false}},
};

/// By node in Abaqus's order, the node in gmsh's: it walks through the edges in another order.
constexpr std::array<std::size_t, 10> kTet10{0, 1, 2, 3, 4, 5, 6, 7, 9, 8};
constexpr std::array<std::size_t, 20> kHex20{0,  1, 2,  3,  4,  5,  6,  7,  8,  11,
                                             13, 9, 16, 18, 19, 17, 10, 12, 14, 15};

}  // namespace

const GmshElement* find_gmsh_element(int type) {
  for (const Numbered& numbered : kGmshElements)
    if (numbered.type == type) return &numbered.element;
  return nullptr;
}

spatial::ElementKind kind_of_gmsh(int type) {
  switch (type) {
    case 4:
      return spatial::ElementKind::tet4;
    case 5:
      return spatial::ElementKind::hex8;
    case 11:
      return spatial::ElementKind::tet10;
    default:
      return spatial::ElementKind::hex20;
  }
}

std::array<int, 20> in_abaqus_order(spatial::ElementKind kind, const std::array<int, 20>& nodes) {
  std::array<int, 20> ordered = nodes;
  if (kind == spatial::ElementKind::tet10)
    for (std::size_t n = 0; n < kTet10.size(); ++n) ordered[n] = nodes[kTet10[n]];
  if (kind == spatial::ElementKind::hex20)
    for (std::size_t n = 0; n < kHex20.size(); ++n) ordered[n] = nodes[kHex20[n]];
  return ordered;
}

}  // namespace spoke::solid
