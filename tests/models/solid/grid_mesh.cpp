// Meshes of boxes: points of the grid of half cells, elements by cells, sets by places.

#include "tests/models/solid/grid_mesh.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace spoke::test {
namespace {

using spatial::ElementKind;
using spatial::SolidElement;
using spatial::SolidFace;
using spatial::SolidMesh;

using Point = std::array<int, 3>;  // of the grid of half cells

/// Corners of a cell in Abaqus's order, and the ends of its edges in the order of their mid nodes.
constexpr std::array<Point, 8> kCorners{
    {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}}};
constexpr std::array<std::array<int, 2>, 12> kHexEdges{{{0, 1},
                                                        {1, 2},
                                                        {2, 3},
                                                        {3, 0},
                                                        {4, 5},
                                                        {5, 6},
                                                        {6, 7},
                                                        {7, 4},
                                                        {0, 4},
                                                        {1, 5},
                                                        {2, 6},
                                                        {3, 7}}};
constexpr std::array<std::array<int, 2>, 6> kTetEdges{
    {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
constexpr std::array<std::array<int, 3>, 6> kPaths{
    {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};

// Faces of elements: corners, then the mid nodes between them.
constexpr std::array<std::array<int, 6>, 4> kTetFaces{
    {{0, 2, 1, 6, 5, 4}, {0, 1, 3, 4, 8, 7}, {1, 2, 3, 5, 9, 8}, {2, 0, 3, 6, 7, 9}}};
constexpr std::array<std::array<int, 8>, 6> kHexFaces{{{0, 3, 2, 1, 11, 10, 9, 8},
                                                       {4, 5, 6, 7, 12, 13, 14, 15},
                                                       {0, 1, 5, 4, 8, 17, 12, 16},
                                                       {1, 2, 6, 5, 9, 18, 13, 17},
                                                       {2, 3, 7, 6, 10, 19, 14, 18},
                                                       {3, 0, 4, 7, 11, 16, 15, 19}}};

Point middle(const Point& a, const Point& b) {
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

class Builder {
 public:
  explicit Builder(const GridMesh& grid) : grid_(grid) {
    for (std::size_t a = 0; a < 3; ++a) points_[a] = 2 * grid.cells[a] + 1;
    number_.assign(static_cast<std::size_t>(points_[0]) * static_cast<std::size_t>(points_[1]) *
                       static_cast<std::size_t>(points_[2]),
                   -1);
  }

  SolidMesh make() {
    for (int k = 0; k < grid_.cells[2]; ++k)
      for (int j = 0; j < grid_.cells[1]; ++j)
        for (int i = 0; i < grid_.cells[0]; ++i)
          if (!grid_.keeps || grid_.keeps(i, j, k)) add_cell({2 * i, 2 * j, 2 * k});
    add_nodes();
    for (SolidElement& element : mesh_.elements)
      for (int n = 0; n < count_nodes(grid_.kind); ++n) {
        int& node = element.nodes[static_cast<std::size_t>(n)];
        node = number_[static_cast<std::size_t>(node)];
      }
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const bool end : {false, true}) add_set(axis, end);
    return std::move(mesh_);
  }

 private:
  int key(const Point& p) const { return p[0] + points_[0] * (p[1] + points_[1] * p[2]); }

  /// Appends an element from its corners and edges.
  template <std::size_t Edges>
  void add(const std::vector<Point>& corners, const std::array<std::array<int, 2>, Edges>& edges) {
    SolidElement element{grid_.kind, {}, 0};
    std::size_t n = 0;
    for (const Point& corner : corners) element.nodes[n++] = key(corner);
    const auto count = static_cast<std::size_t>(count_nodes(grid_.kind));
    for (const auto& [a, b] : edges)
      if (n < count)
        element.nodes[n++] =
            key(middle(corners[static_cast<std::size_t>(a)], corners[static_cast<std::size_t>(b)]));
    for (n = 0; n < count; ++n) number_[static_cast<std::size_t>(element.nodes[n])] = 0;
    mesh_.elements.push_back(element);
  }

  void add_cell(const Point& o) {
    std::vector<Point> corners;
    if (grid_.kind == ElementKind::hex8 || grid_.kind == ElementKind::hex20) {
      for (const Point& c : kCorners) corners.push_back({o[0] + c[0], o[1] + c[1], o[2] + c[2]});
      add(corners, kHexEdges);
      return;
    }
    for (std::size_t t = 0; t < kPaths.size(); ++t) {
      corners.assign(1, o);
      for (const int axis : kPaths[t]) {
        Point next = corners.back();
        next[static_cast<std::size_t>(axis)] += 2;
        corners.push_back(next);
      }
      if (t >= 3) std::swap(corners[1], corners[2]);
      add(corners, kTetEdges);
    }
  }

  void add_nodes() {
    int count = 0;
    for (int k = 0; k < points_[2]; ++k)
      for (int j = 0; j < points_[1]; ++j)
        for (int i = 0; i < points_[0]; ++i) {
          int& number = number_[static_cast<std::size_t>(key({i, j, k}))];
          if (number < 0) continue;
          number = count++;
          where_.push_back({i, j, k});
          spatial::Vector place;
          for (std::size_t a = 0; a < 3; ++a)
            place[static_cast<Eigen::Index>(a)] =
                grid_.lengths[a] * where_.back()[a] / (2.0 * grid_.cells[a]) + grid_.shift[a];
          mesh_.nodes.push_back(place);
        }
  }

  bool lies_on(int node, std::size_t axis, bool end) const {
    return where_[static_cast<std::size_t>(node)][axis] == (end ? points_[axis] - 1 : 0);
  }

  void add_set(std::size_t axis, bool end) {
    spatial::SolidNodeSet set;
    set.name = std::string(1, "XYZ"[axis]) + (end ? '1' : '0');
    for (int node = 0; node < static_cast<int>(where_.size()); ++node)
      if (lies_on(node, axis, end)) set.nodes.push_back(node);
    const bool is_tet = grid_.kind == ElementKind::tet4 || grid_.kind == ElementKind::tet10;
    const bool is_linear = grid_.kind == ElementKind::tet4 || grid_.kind == ElementKind::hex8;
    const auto add_face = [&](const SolidElement& element, const auto& places) {
      SolidFace face;
      face.count = static_cast<int>(is_linear ? places.size() / 2 : places.size());
      for (std::size_t n = 0; n < static_cast<std::size_t>(face.count); ++n) {
        face.nodes[n] = element.nodes[static_cast<std::size_t>(places[n])];
        if (!lies_on(face.nodes[n], axis, end)) return;
      }
      set.faces.push_back(face);
    };
    for (const SolidElement& element : mesh_.elements) {
      if (is_tet)
        for (const auto& places : kTetFaces) add_face(element, places);
      else
        for (const auto& places : kHexFaces) add_face(element, places);
    }
    mesh_.sets.push_back(std::move(set));
  }

  const GridMesh& grid_;
  Point points_{};
  std::vector<int> number_;   // by point: -1: not used; its node
  std::vector<Point> where_;  // by node
  SolidMesh mesh_;
};

}  // namespace

spatial::SolidMesh make_grid_mesh(const GridMesh& grid) { return Builder(grid).make(); }

}  // namespace spoke::test
