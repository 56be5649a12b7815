// Cuts each cell into six tetrahedra about its diagonal.

#include "bench/box_mesh.h"

#include <algorithm>

namespace spoke::bench {
namespace {

using Point = std::array<int, 3>;  // of the grid of half cells

/// The orders in which a path goes along the axes from one end of a cell's diagonal to the other,
/// even permutations first: the corners of a tetrahedron are the points of a path.
constexpr std::array<Point, 6> kPaths{
    {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
constexpr std::array<std::array<std::size_t, 2>, 6> kEdges{
    {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};

class BoxBuilder {
 public:
  explicit BoxBuilder(const BoxSize& size) : size_(size) {
    std::size_t points = 1;
    for (const int cells : size.cells) points *= static_cast<std::size_t>(2 * cells + 1);
    numbers_.assign(points, -1);
  }

  spatial::SolidMesh make() {
    const auto [nx, ny, nz] = size_.cells;
    for (int i = 0; i < nx; ++i)
      for (int j = 0; j < ny; ++j)
        for (int k = 0; k < nz; ++k)
          for (std::size_t path = 0; path < kPaths.size(); ++path) add({2 * i, 2 * j, 2 * k}, path);
    return std::move(mesh_);
  }

 private:
  void add(const Point& origin, std::size_t path) {
    std::array<Point, 4> corners{origin, origin, origin, origin};
    for (std::size_t step = 0; step < 3; ++step)
      for (std::size_t c = step + 1; c < 4; ++c)
        corners[c][static_cast<std::size_t>(kPaths[path][step])] += 2;
    if (path >= 3) std::swap(corners[1], corners[2]);  // else its volume is negative
    spatial::SolidElement element;
    std::size_t n = 0;
    for (const Point& corner : corners) element.nodes[n++] = number_of(corner);
    for (const auto& [a, b] : kEdges) {
      Point middle = corners[a];
      for (std::size_t axis = 0; axis < 3; ++axis)
        middle[axis] = (corners[a][axis] + corners[b][axis]) / 2;
      element.nodes[n++] = number_of(middle);
    }
    mesh_.elements.push_back(element);
  }

  int number_of(const Point& p) {
    const int ny = 2 * size_.cells[1] + 1, nz = 2 * size_.cells[2] + 1;
    int& number = numbers_[static_cast<std::size_t>((p[0] * ny + p[1]) * nz + p[2])];
    if (number >= 0) return number;
    number = static_cast<int>(mesh_.nodes.size());
    spatial::Vector place;
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      place[axis] = size_.lengths[a] * (0.5 * p[a] / size_.cells[a] - (axis == 0 ? 0.0 : 0.5));
    }
    mesh_.nodes.push_back(place);
    return number;
  }

  const BoxSize& size_;
  spatial::SolidMesh mesh_;
  std::vector<int> numbers_;
};

}  // namespace

spatial::SolidMesh make_box_mesh(const BoxSize& size) { return BoxBuilder(size).make(); }

}  // namespace spoke::bench
