// The elements: rules against integrals of monomials, shape functions, rigid motions, patches of
// constant strain, and the volume of curved elements.

#include "models/solid/elements.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "models/solid/element_rules.h"

namespace spoke::solid {
namespace {

using spatial::ElementKind;

constexpr ElementKind kKinds[] = {ElementKind::tet4, ElementKind::tet10, ElementKind::hex8,
                                  ElementKind::hex20};

double factorial(int n) { return std::tgamma(n + 1.0); }

/// The integral of x^a y^b z^c over the parent tetrahedron.
double tetrahedron_integral(int a, int b, int c) {
  return factorial(a) * factorial(b) * factorial(c) / factorial(a + b + c + 3);
}

double cube_integral(int a, int b, int c) {
  const auto line = [](int n) { return n % 2 == 0 ? 2.0 / (n + 1) : 0.0; };
  return line(a) * line(b) * line(c);
}

double sum_of(const std::vector<ParentPoint>& points, int a, int b, int c) {
  double sum = 0.0;
  for (const ParentPoint& point : points)
    sum += point.weight * std::pow(point.place[0], a) * std::pow(point.place[1], b) *
           std::pow(point.place[2], c);
  return sum;
}

/// A tetrahedron or a hexahedron in general position; with `bend`, its mid nodes are moved.
NodeColumns make_element(ElementKind kind, double bend) {
  const int count = spatial::count_nodes(kind);
  Eigen::Matrix3d J;
  J << 1.3, 0.2, -0.1, 0.3, 0.9, 0.4, -0.2, 0.1, 1.1;
  NodeColumns x(3, count);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int a = 0; a < count; ++a) {
    x.col(a) = J * parent_place(kind, a) + Eigen::Vector3d(0.4, -0.7, 0.2);
    if (a >= (kind == ElementKind::tet10 ? 4 : 8))
      x.col(a) += bend * Eigen::Vector3d(any(random), any(random), any(random));
  }
  return x;
}

double volume_of(ElementKind kind, const NodeColumns& x) { return calc_mass(kind, x, 1.0).sum(); }

TEST_CASE("elements: rules are exact to their degree") {
  const auto check = [](const std::vector<ParentPoint>& points, int degree) {
    for (int a = 0; a <= degree; ++a)
      for (int b = 0; a + b <= degree; ++b)
        for (int c = 0; a + b + c <= degree; ++c)
          CHECK(std::abs(sum_of(points, a, b, c) - tetrahedron_integral(a, b, c)) < 1e-16);
  };
  check(tetrahedron_1(), 1);
  check(tetrahedron_4(), 2);
  check(tetrahedron_14(), 5);
  check(tetrahedron_125(), 7);
  for (const int points : {2, 3, 5})
    for (int a = 0; a < 2 * points; ++a)
      for (int b = 0; b < 2 * points; ++b)
        CHECK(std::abs(sum_of(cube_points(points), a, b, 2) - cube_integral(a, b, 2)) < 2e-15);
}

TEST_CASE("elements: shape functions are 1 at their node, sum to 1, and have their derivatives") {
  for (const ElementKind kind : kKinds) {
    const int count = spatial::count_nodes(kind);
    for (int a = 0; a < count; ++a) {
      const ShapePoint at = calc_shapes(kind, parent_place(kind, a));
      CHECK((at.N - Eigen::VectorXd::Unit(count, a)).cwiseAbs().maxCoeff() < 1e-15);
    }
    const Eigen::Vector3d place(0.21, 0.13, 0.34);
    const ShapePoint here = calc_shapes(kind, place);
    CHECK(std::abs(here.N.sum() - 1.0) < 1e-15);
    for (int k = 0; k < 3; ++k) {
      const double h = 1e-5;
      const NodeValues difference = (calc_shapes(kind, place + h * Eigen::Vector3d::Unit(k)).N -
                                     calc_shapes(kind, place - h * Eigen::Vector3d::Unit(k)).N) /
                                    (2.0 * h);
      CHECK((here.dN.row(k).transpose() - difference).cwiseAbs().maxCoeff() < 1e-9);
    }
  }
}

TEST_CASE("elements: rigid motions make no force, curved ones too") {
  const Lame material = lame_of({7e10, 0.33, 2700.0});
  for (const ElementKind kind : kKinds) {
    const NodeColumns x = make_element(kind, 0.05);
    const NodeStiffness K = calc_stiffness(kind, x, material);
    const double scale = K.cwiseAbs().maxCoeff();
    CHECK((K - K.transpose()).cwiseAbs().maxCoeff() == 0.0);
    for (int k = 0; k < 3; ++k) {
      NodeColumns shift = NodeColumns::Zero(3, x.cols()), turn = shift;
      shift.row(k).setOnes();
      for (int a = 0; a < x.cols(); ++a)
        turn.col(a) = Eigen::Vector3d::Unit(k).cross(Eigen::Vector3d(x.col(a)));
      for (const NodeColumns& motion : {shift, turn}) {
        const Eigen::Map<const Eigen::VectorXd> u(motion.data(), motion.size());
        CHECK((K * u).cwiseAbs().maxCoeff() < 1e-14 * scale);
      }
    }
  }
}

TEST_CASE("elements: constant strain has the energy of its volume, of curved elements too") {
  const spatial::SolidMaterial material{7e10, 0.33, 2700.0};
  const Lame lame = lame_of(material);
  Eigen::Matrix3d H;
  H << 1e-3, 2e-4, -3e-4, 5e-4, -2e-3, 1e-4, 4e-4, -6e-4, 7e-4;
  const Eigen::Matrix3d strain = 0.5 * (H + H.transpose());
  const Eigen::Matrix3d stress =
      2.0 * lame.mu * strain + lame.lambda * strain.trace() * Eigen::Matrix3d::Identity();
  const double density = 0.5 * (stress.array() * strain.array()).sum();
  for (const ElementKind kind : kKinds) {
    const NodeColumns x = make_element(kind, 0.05), u = H * x;
    // The volume by the rule of the stiffness, which is not exact for a curved tet10.
    double volume = 0.0;
    NodeColumns g(3, x.cols());
    for (const ShapePoint& point : stiffness_rule(kind)) {
      volume += point.weight * calc_gradients(point, x, g);
      CHECK((calc_stress(g, u, lame) - stress).cwiseAbs().maxCoeff() < 1e-13 * stress.norm());
    }
    const Eigen::Map<const Eigen::VectorXd> v(u.data(), u.size());
    const double energy = 0.5 * v.dot(calc_stiffness(kind, x, lame) * v);
    CHECK(std::abs(energy / (density * volume) - 1.0) < 1e-13);
    CHECK(std::abs(volume / volume_of(kind, x) - 1.0) < (kind == ElementKind::tet10 ? 0.02 : 1e-2));
  }
}

TEST_CASE("elements: volume and mass of straight elements, det J of inverted ones") {
  for (const ElementKind kind : kKinds) {
    const NodeColumns x = make_element(kind, 0.0);
    CHECK_FALSE(is_curved(kind, x));
    Eigen::Matrix3d J;
    J << 1.3, 0.2, -0.1, 0.3, 0.9, 0.4, -0.2, 0.1, 1.1;
    const bool is_tet = kind == ElementKind::tet4 || kind == ElementKind::tet10;
    const double volume = J.determinant() * (is_tet ? 1.0 / 6.0 : 8.0);
    CHECK(std::abs(volume_of(kind, x) / volume - 1.0) < 1e-14);
    CHECK(std::abs(least_volume_ratio(kind, x) / J.determinant() - 1.0) < 1e-13);
    CHECK(least_volume_ratio(kind, -x) < 0.0);
    // Second moments: sum_ij m_ij x_i x_j is the integral of x^2, since x is in the shape
    // functions.
    const NodeMatrix m = calc_mass(kind, x, 1.0);
    double second = 0.0;
    const Eigen::Vector3d c(0.4, -0.7, 0.2);
    for (const ParentPoint& p : is_tet ? tetrahedron_14() : cube_points(3)) {
      const double place = (J * p.place + c)[0];
      second += p.weight * J.determinant() * place * place;
    }
    CHECK(std::abs(x.row(0).dot(m * x.row(0).transpose()) / second - 1.0) < 1e-14);
  }
  for (const ElementKind kind : {ElementKind::tet10, ElementKind::hex20})
    CHECK(is_curved(kind, make_element(kind, 0.01)));
}

TEST_CASE("elements: the mass of a curved tet10 is that of finer rules") {
  // The collapsed cube here has other axes and corners than the rule's.
  const NodeColumns x = make_element(ElementKind::tet10, 0.08);
  double volume = 0.0;
  for (const ParentPoint& p : cube_points(5)) {
    const Eigen::Vector3d s = 0.5 * (p.place + Eigen::Vector3d::Ones());
    const Eigen::Vector3d place((1.0 - s[1]) * (1.0 - s[2]) * s[0], (1.0 - s[2]) * s[1], s[2]);
    const ShapePoint at = calc_shapes(ElementKind::tet10, place);
    const Eigen::Matrix3d J = x * at.dN.transpose();
    volume += 0.125 * p.weight * (1.0 - s[2]) * (1.0 - s[2]) * (1.0 - s[1]) * J.determinant();
  }
  CHECK(std::abs(volume_of(ElementKind::tet10, x) / volume - 1.0) < 1e-14);
}

}  // namespace
}  // namespace spoke::solid
