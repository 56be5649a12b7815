#include "models/solid/elements.h"

#include <Eigen/LU>
#include <array>
#include <cassert>
#include <limits>

#include "models/solid/element_rules.h"

namespace spoke::solid {
namespace {

using spatial::ElementKind;

bool is_tetrahedron(ElementKind kind) {
  return kind == ElementKind::tet4 || kind == ElementKind::tet10;
}

/// The corners at the ends of each side, in the order of the mid nodes.
constexpr int kTetSides[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
constexpr int kHexSides[12][2] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
                                  {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
constexpr int kHexCorners[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                   {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};

Eigen::Vector3d hex_corner(int node) {
  return {double(kHexCorners[node][0]), double(kHexCorners[node][1]), double(kHexCorners[node][2])};
}

void calc_tet_shapes(const Eigen::Vector3d& place, bool is_quadratic, ShapePoint& point) {
  const double L[4] = {1.0 - place.sum(), place[0], place[1], place[2]};
  Eigen::Matrix<double, 3, 4> dL;
  dL << Eigen::Vector3d::Constant(-1.0), Eigen::Matrix3d::Identity();
  for (int a = 0; a < 4; ++a) {
    point.N[a] = is_quadratic ? L[a] * (2.0 * L[a] - 1.0) : L[a];
    point.dN.col(a) = is_quadratic ? Eigen::Vector3d((4.0 * L[a] - 1.0) * dL.col(a)) : dL.col(a);
  }
  if (!is_quadratic) return;
  for (int side = 0; side < 6; ++side) {
    const int a = kTetSides[side][0], b = kTetSides[side][1];
    point.N[4 + side] = 4.0 * L[a] * L[b];
    point.dN.col(4 + side) = 4.0 * (L[a] * dL.col(b) + L[b] * dL.col(a));
  }
}

void calc_hex8_shapes(const Eigen::Vector3d& s, ShapePoint& point) {
  for (int a = 0; a < 8; ++a) {
    const Eigen::Vector3d c = hex_corner(a), f = Eigen::Vector3d::Ones() + c.cwiseProduct(s);
    point.N[a] = 0.125 * f[0] * f[1] * f[2];
    point.dN.col(a) =
        0.125 * Eigen::Vector3d(c[0] * f[1] * f[2], c[1] * f[0] * f[2], c[2] * f[0] * f[1]);
  }
}

void calc_hex20_shapes(const Eigen::Vector3d& s, ShapePoint& point) {
  for (int a = 0; a < 8; ++a) {
    const Eigen::Vector3d c = hex_corner(a), f = Eigen::Vector3d::Ones() + c.cwiseProduct(s);
    const double product = 0.125 * f[0] * f[1] * f[2], sum = c.dot(s) - 2.0;
    point.N[a] = product * sum;
    const Eigen::Vector3d d(c[0] * f[1] * f[2], c[1] * f[0] * f[2], c[2] * f[0] * f[1]);
    point.dN.col(a) = 0.125 * sum * d + product * c;
  }
  for (int side = 0; side < 12; ++side) {
    const Eigen::Vector3d c =
        0.5 * (hex_corner(kHexSides[side][0]) + hex_corner(kHexSides[side][1]));
    Eigen::Vector3d f, d;  // factors of the three axes and their derivatives
    for (int k = 0; k < 3; ++k) {
      f[k] = c[k] == 0.0 ? 1.0 - s[k] * s[k] : 1.0 + c[k] * s[k];
      d[k] = c[k] == 0.0 ? -2.0 * s[k] : c[k];
    }
    point.N[8 + side] = 0.25 * f[0] * f[1] * f[2];
    point.dN.col(8 + side) =
        0.25 * Eigen::Vector3d(d[0] * f[1] * f[2], f[0] * d[1] * f[2], f[0] * f[1] * d[2]);
  }
}

ShapeRule make_rule(ElementKind kind, const std::vector<ParentPoint>& points) {
  ShapeRule rule;
  for (const ParentPoint& point : points) {
    rule.push_back(calc_shapes(kind, point.place));
    rule.back().weight = point.weight;
  }
  return rule;
}

/// One rule for each kind of element.
using RuleTable = std::array<ShapeRule, 4>;

template <class Points>
RuleTable make_table(Points&& points) {
  RuleTable table;
  for (int k = 0; k < 4; ++k)
    table[static_cast<std::size_t>(k)] =
        make_rule(static_cast<ElementKind>(k), points(static_cast<ElementKind>(k)));
  return table;
}

const ShapeRule& rule_of(const RuleTable& table, ElementKind kind) {
  return table[static_cast<std::size_t>(kind)];
}

}  // namespace

const ShapeRule& stiffness_rule(ElementKind kind) {
  static const RuleTable table = make_table([](ElementKind k) {
    if (is_tetrahedron(k)) return k == ElementKind::tet4 ? tetrahedron_1() : tetrahedron_4();
    return cube_points(k == ElementKind::hex8 ? 2 : 3);
  });
  return rule_of(table, kind);
}

const ShapeRule& mass_rule(ElementKind kind, bool is_curved) {
  static const RuleTable straight = make_table(
      [](ElementKind k) { return is_tetrahedron(k) ? tetrahedron_14() : cube_points(3); });
  // Of a curved tet10 det J is of degree 3: with N_i N_j 7. Of hex20 as Abaqus takes it.
  static const RuleTable curved = make_table([](ElementKind k) {
    if (is_tetrahedron(k)) return k == ElementKind::tet4 ? tetrahedron_14() : tetrahedron_125();
    return cube_points(3);
  });
  return rule_of(is_curved ? curved : straight, kind);
}

const ShapeRule& stress_rule(ElementKind kind) { return mass_rule(kind, false); }

Eigen::Vector3d parent_place(ElementKind kind, int node) {
  assert(node >= 0 && node < spatial::count_nodes(kind));
  if (!is_tetrahedron(kind)) {
    if (node < 8) return hex_corner(node);
    const auto& side = kHexSides[node - 8];
    return 0.5 * (hex_corner(side[0]) + hex_corner(side[1]));
  }
  const auto corner = [](int a) {
    return a == 0 ? Eigen::Vector3d(Eigen::Vector3d::Zero())
                  : Eigen::Vector3d(Eigen::Vector3d::Unit(a - 1));
  };
  if (node < 4) return corner(node);
  return 0.5 * (corner(kTetSides[node - 4][0]) + corner(kTetSides[node - 4][1]));
}

ShapePoint calc_shapes(ElementKind kind, const Eigen::Vector3d& place) {
  const int count = spatial::count_nodes(kind);
  ShapePoint point{0.0, NodeValues(count), NodeColumns(3, count)};
  if (is_tetrahedron(kind))
    calc_tet_shapes(place, kind == ElementKind::tet10, point);
  else if (kind == ElementKind::hex8)
    calc_hex8_shapes(place, point);
  else
    calc_hex20_shapes(place, point);
  return point;
}

NodeColumns places_of(const spatial::SolidMesh& mesh, const spatial::SolidElement& element) {
  const int count = spatial::count_nodes(element.kind);
  NodeColumns x(3, count);
  for (int a = 0; a < count; ++a)
    x.col(a) = mesh.nodes[static_cast<std::size_t>(element.nodes[static_cast<std::size_t>(a)])];
  return x;
}

bool is_curved(ElementKind kind, const NodeColumns& x) {
  const int corners = is_tetrahedron(kind) ? 4 : 8;
  const double size = (x.colwise() - x.col(0)).cwiseAbs().maxCoeff();
  const auto differ = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return (a - b).cwiseAbs().maxCoeff() > 1e-12 * size;
  };
  for (int mid = corners; mid < x.cols(); ++mid) {
    const auto& side = corners == 4 ? kTetSides[mid - 4] : kHexSides[mid - 8];
    if (differ(x.col(mid), 0.5 * (x.col(side[0]) + x.col(side[1])))) return true;
  }
  if (corners == 4) return false;
  const Eigen::Vector3d a = x.col(1) - x.col(0), b = x.col(3) - x.col(0), c = x.col(4) - x.col(0);
  for (int k = 0; k < 8; ++k) {
    const Eigen::Vector3d f = 0.5 * (hex_corner(k) + Eigen::Vector3d::Ones());
    if (differ(x.col(k), x.col(0) + f[0] * a + f[1] * b + f[2] * c)) return true;
  }
  return false;
}

double calc_gradients(const ShapePoint& point, const NodeColumns& x, NodeColumns& gradients) {
  const Eigen::Matrix3d J = x * point.dN.transpose();  // column b: dx by parent coordinate b
  const double ratio = J.determinant();
  gradients.noalias() = J.inverse().transpose() * point.dN;
  return ratio;
}

double least_volume_ratio(ElementKind kind, const NodeColumns& x) {
  double least = std::numeric_limits<double>::infinity();
  const auto visit = [&](const ShapePoint& point) {
    const Eigen::Matrix3d J = x * point.dN.transpose();
    const double ratio = J.determinant();
    least = ratio < least || !(ratio == ratio) ? ratio : least;
  };
  for (const ShapePoint& point : stiffness_rule(kind)) visit(point);
  for (const ShapePoint& point : mass_rule(kind, true)) visit(point);
  return least;
}

NodeVolume least_volume_at_nodes(ElementKind kind, const NodeColumns& x) {
  static const RuleTable table = make_table([](ElementKind k) {
    std::vector<ParentPoint> nodes;
    for (int node = 0; node < spatial::count_nodes(k); ++node)
      nodes.push_back({parent_place(k, node), 0.0});
    return nodes;
  });
  NodeVolume least{0, std::numeric_limits<double>::infinity()};
  const ShapeRule& points = rule_of(table, kind);
  for (std::size_t node = 0; node < points.size(); ++node) {
    const Eigen::Matrix3d J = x * points[node].dN.transpose();
    const double ratio = J.determinant();
    if (ratio < least.ratio) least = {static_cast<int>(node), ratio};
  }
  return least;
}

NodeMatrix calc_mass(ElementKind kind, const NodeColumns& x, double density) {
  const ShapeRule& rule = mass_rule(kind, is_curved(kind, x));
  NodeMatrix m = NodeMatrix::Zero(x.cols(), x.cols());
  for (const ShapePoint& point : rule) {
    const Eigen::Matrix3d J = x * point.dN.transpose();
    m.noalias() += (point.weight * density * J.determinant()) * (point.N * point.N.transpose());
  }
  for (Eigen::Index j = 0; j < m.cols(); ++j)  // symmetric in its bits
    for (Eigen::Index i = 0; i < j; ++i) m(j, i) = m(i, j);
  return m;
}

Lame lame_of(const spatial::SolidMaterial& material) {
  const double E = material.youngs_modulus, nu = material.poissons_ratio;
  return {E * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)), E / (2.0 * (1.0 + nu))};
}

NodeStiffness calc_stiffness(ElementKind kind, const NodeColumns& x, const Lame& material) {
  const Eigen::Index count = x.cols();
  NodeStiffness K = NodeStiffness::Zero(3 * count, 3 * count);
  NodeColumns g(3, count);
  for (const ShapePoint& point : stiffness_rule(kind)) {
    const double W = point.weight * calc_gradients(point, x, g);
    for (Eigen::Index j = 0; j < count; ++j) {
      for (Eigen::Index i = 0; i <= j; ++i) {
        const Eigen::Vector3d a = W * g.col(i), b = g.col(j);
        Eigen::Matrix3d block =
            material.lambda * (a * b.transpose()) + material.mu * (b * a.transpose());
        block.diagonal().array() += material.mu * a.dot(b);
        K.block<3, 3>(3 * i, 3 * j) += block;
      }
    }
  }
  for (Eigen::Index j = 0; j < 3 * count; ++j)
    for (Eigen::Index i = 0; i < j; ++i) K(j, i) = K(i, j);
  return K;
}

Eigen::Matrix3d calc_stress(const NodeColumns& gradients, const NodeColumns& u,
                            const Lame& material) {
  const Eigen::Matrix3d H = u * gradients.transpose();  // du_a by x_b
  Eigen::Matrix3d stress = material.mu * (H + H.transpose());
  stress.diagonal().array() += material.lambda * H.trace();
  return stress;
}

}  // namespace spoke::solid
