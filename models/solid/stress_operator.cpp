// Stresses of nodes from displacements.

#include <Eigen/LU>

#include "models/solid/assembly.h"
#include "models/solid/element_rules.h"
#include "models/solid/elements.h"

namespace spoke::solid {
namespace {

using spatial::ElementKind;

/// The points whose stresses are extrapolated, and how: a row per node of the element.
struct StressPoints {
  ShapeRule points;
  Eigen::MatrixXd weights;
};

std::vector<ParentPoint> stress_places(ElementKind kind) {
  if (kind == ElementKind::tet4) return tetrahedron_1();
  return kind == ElementKind::tet10 ? tetrahedron_4() : cube_points(2);
}

/// The polynomials that as many points determine: 1; linear; linear in each coordinate.
Eigen::RowVectorXd monomials(std::size_t count, const Eigen::Vector3d& s) {
  Eigen::RowVectorXd all(8);
  all << 1.0, s[0], s[1], s[2], s[0] * s[1], s[1] * s[2], s[2] * s[0], s[0] * s[1] * s[2];
  return all.head(static_cast<Eigen::Index>(count));
}

StressPoints make_stress_points(ElementKind kind) {
  const std::vector<ParentPoint> places = stress_places(kind);
  const auto count = static_cast<Eigen::Index>(places.size());
  const int nodes = spatial::count_nodes(kind);
  Eigen::MatrixXd at_points(count, count), at_nodes(nodes, count);
  StressPoints result;
  for (Eigen::Index p = 0; p < count; ++p) {
    const Eigen::Vector3d& place = places[static_cast<std::size_t>(p)].place;
    at_points.row(p) = monomials(places.size(), place);
    result.points.push_back(calc_shapes(kind, place));
  }
  for (int a = 0; a < nodes; ++a) at_nodes.row(a) = monomials(places.size(), parent_place(kind, a));
  result.weights = at_nodes * at_points.inverse();
  return result;
}

const StressPoints& stress_points(ElementKind kind) {
  static const std::array<StressPoints, 4> table{
      make_stress_points(ElementKind::tet4), make_stress_points(ElementKind::tet10),
      make_stress_points(ElementKind::hex8), make_stress_points(ElementKind::hex20)};
  return table[static_cast<std::size_t>(kind)];
}

/// Returns the 6 x 3 map from a node's displacement to the stress at a point.
Eigen::Matrix<double, 6, 3> stress_of_node(const Eigen::Vector3d& g, const Lame& material) {
  Eigen::Matrix<double, 6, 3> map = Eigen::Matrix<double, 6, 3>::Zero();
  for (int a = 0; a < 3; ++a) {
    map.row(a) = material.lambda * g.transpose();
    map(a, a) += 2.0 * material.mu * g[a];
    const int b = (a + 1) % 3, c = (a + 2) % 3;  // row 3 + a: stress bc
    map(3 + a, b) = material.mu * g[c];
    map(3 + a, c) = material.mu * g[b];
  }
  return map;
}

}  // namespace

Eigen::SparseMatrix<double, Eigen::RowMajor> make_stress_operator(
    const spatial::SolidMesh& mesh, const spatial::SolidMaterial& material) {
  const auto n = static_cast<Eigen::Index>(mesh.nodes.size());
  const Lame lame = lame_of(material);
  std::vector<double> shares(mesh.nodes.size(), 0.0);
  for (const spatial::SolidElement& element : mesh.elements)
    for (int a = 0; a < spatial::count_nodes(element.kind); ++a)
      shares[static_cast<std::size_t>(element.nodes[static_cast<std::size_t>(a)])] += 1.0;

  std::vector<Eigen::Triplet<double>> entries;
  for (const spatial::SolidElement& element : mesh.elements) {
    const NodeColumns x = places_of(mesh, element);
    const StressPoints& rule = stress_points(element.kind);
    std::vector<NodeColumns> gradients;
    for (const ShapePoint& point : rule.points) {
      gradients.emplace_back(3, x.cols());
      calc_gradients(point, x, gradients.back());
    }
    for (int a = 0; a < x.cols(); ++a) {
      const int node = element.nodes[static_cast<std::size_t>(a)];
      for (int b = 0; b < x.cols(); ++b) {
        Eigen::Vector3d g = Eigen::Vector3d::Zero();
        for (std::size_t p = 0; p < gradients.size(); ++p)
          g += rule.weights(a, static_cast<Eigen::Index>(p)) * gradients[p].col(b);
        const Eigen::Matrix<double, 6, 3> map =
            stress_of_node(g / shares[static_cast<std::size_t>(node)], lame);
        for (int row = 0; row < 6; ++row)
          for (int c = 0; c < 3; ++c)
            if (map(row, c) != 0.0)
              entries.emplace_back(6 * node + row,
                                   3 * element.nodes[static_cast<std::size_t>(b)] + c, map(row, c));
      }
    }
  }
  Eigen::SparseMatrix<double, Eigen::RowMajor> result(6 * n, 3 * n);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace spoke::solid
