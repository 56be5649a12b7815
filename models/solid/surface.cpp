// Faces of elements, and those that no second element has.

#include "models/solid/surface.h"

#include <algorithm>
#include <cstddef>

#include "models/solid/element_faces.h"

namespace spoke::solid {
namespace {

using spatial::ElementKind;
using spatial::SolidFace;

// Nodes of the faces S1, S2, ... of Abaqus, in the direction that turns about the outward normal:
// the corners, then the mid nodes.
constexpr std::array<std::array<int, 6>, 4> kTetFaces{
    {{0, 2, 1, 6, 5, 4}, {0, 1, 3, 4, 8, 7}, {1, 2, 3, 5, 9, 8}, {2, 0, 3, 6, 7, 9}}};
constexpr std::array<std::array<int, 8>, 6> kHexFaces{{{0, 3, 2, 1, 11, 10, 9, 8},
                                                       {4, 5, 6, 7, 12, 13, 14, 15},
                                                       {0, 1, 5, 4, 8, 17, 12, 16},
                                                       {1, 2, 6, 5, 9, 18, 13, 17},
                                                       {2, 3, 7, 6, 10, 19, 14, 18},
                                                       {3, 0, 4, 7, 11, 16, 15, 19}}};

template <class Places>
SolidFace make_face(const spatial::SolidElement& element, const Places& places, int count) {
  SolidFace face{count, {}};
  for (std::size_t n = 0; n < static_cast<std::size_t>(count); ++n)
    face.nodes[n] = element.nodes[static_cast<std::size_t>(places[n])];
  return face;
}

// Triangles of a face by its number of nodes.
using Triangles = std::vector<std::array<int, 3>>;
const Triangles& triangles_of(int count) {
  static const Triangles kTri3{{0, 1, 2}};
  static const Triangles kTri6{{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};
  static const Triangles kQuad4{{0, 1, 2}, {0, 2, 3}};
  static const Triangles kQuad8{{0, 4, 7}, {4, 1, 5}, {5, 2, 6}, {6, 3, 7}, {4, 5, 6}, {4, 6, 7}};
  return count == 3 ? kTri3 : count == 4 ? kQuad4 : count == 6 ? kTri6 : kQuad8;
}

}  // namespace

std::vector<SolidFace> faces_of(const spatial::SolidElement& element) {
  std::vector<SolidFace> faces;
  faces.reserve(6);
  if (element.kind == ElementKind::tet4 || element.kind == ElementKind::tet10) {
    const int count = element.kind == ElementKind::tet4 ? 3 : 6;
    for (const auto& places : kTetFaces) faces.push_back(make_face(element, places, count));
  } else {
    const int count = element.kind == ElementKind::hex8 ? 4 : 8;
    for (const auto& places : kHexFaces) faces.push_back(make_face(element, places, count));
  }
  return faces;
}

int count_corners(const SolidFace& face) { return face.count % 3 == 0 ? 3 : 4; }

std::vector<ElementFace> sort_faces(const spatial::SolidMesh& mesh) {
  std::vector<ElementFace> faces;
  faces.reserve(6 * mesh.elements.size());
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    int side = 0;
    for (const SolidFace& face : faces_of(mesh.elements[e])) {
      ElementFace made{{-1, -1, -1, -1}, static_cast<int>(e), side++};
      std::copy_n(face.nodes.begin(), count_corners(face), made.corners.begin());
      std::sort(made.corners.begin(), made.corners.end());
      faces.push_back(made);
    }
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

std::vector<SurfaceFace> find_surface(const spatial::SolidMesh& mesh) {
  const std::vector<ElementFace> faces = sort_faces(mesh);
  std::vector<std::array<int, 2>> single;  // element and side
  for (std::size_t k = 0; k < faces.size(); ++k) {
    const bool is_before = k > 0 && faces[k - 1].corners == faces[k].corners;
    const bool is_behind = k + 1 < faces.size() && faces[k + 1].corners == faces[k].corners;
    if (!is_before && !is_behind) single.push_back({faces[k].element, faces[k].side});
  }
  std::sort(single.begin(), single.end());
  std::vector<SurfaceFace> surface;
  surface.reserve(single.size());
  for (const auto& [element, side] : single)
    surface.push_back(
        {faces_of(mesh.elements[static_cast<std::size_t>(element)])[static_cast<std::size_t>(side)],
         element});
  return surface;
}

std::vector<std::array<int, 3>> split_into_triangles(const std::vector<SurfaceFace>& faces) {
  std::vector<std::array<int, 3>> triangles;
  for (const SurfaceFace& face : faces)
    for (const auto& [a, b, c] : triangles_of(face.face.count)) {
      const auto node = [&](int n) { return face.face.nodes[static_cast<std::size_t>(n)]; };
      triangles.push_back({node(a), node(b), node(c)});
    }
  return triangles;
}

std::vector<int> nodes_of(const std::vector<SurfaceFace>& faces) {
  std::vector<int> nodes;
  for (const SurfaceFace& face : faces)
    nodes.insert(nodes.end(), face.face.nodes.begin(), face.face.nodes.begin() + face.face.count);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

}  // namespace spoke::solid
