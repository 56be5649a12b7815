// Makes vertices and faces of boxes and cylinders.

#include "engine/output/scene/solids.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace spoke::scene {
namespace {

constexpr int kSides = 24;          // faces around a cylinder
constexpr double kThinnest = 0.01;  // smallest dimension of a body, by its largest one

/// Returns half the edges of a box, for which J_x = m (b^2 + c^2)/3 with half edges a, b, c.
Vector half_edges(double mass, const Vector& moments) {
  Vector half;
  for (int i = 0; i < 3; ++i)
    half[i] = std::sqrt(std::max(0.0, 1.5 * (moments.sum() - 2.0 * moments[i]) / mass));
  return half.cwiseMax(kThinnest * half.maxCoeff());
}

Solid make_box(const spatial::Tensor& axes, const Vector& half) {
  Solid box;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector sign(corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, corner & 4 ? 1.0 : -1.0);
    box.vertices.emplace_back(axes * half.cwiseProduct(sign));
  }
  box.faces = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  return box;
}

/// Returns which of three moments, in ascending order, differs from the two equal ones; -1 if there
/// is none.
int find_odd(const Vector& moments) {
  const double same = 1e-6 * moments.maxCoeff();
  const bool low = moments[1] - moments[0] <= same, high = moments[2] - moments[1] <= same;
  return low == high ? -1 : low ? 2 : 0;
}

}  // namespace

Solid make_disc(double inertia) {
  constexpr double kSteel = 7850.0;  // [kg/m^3]
  const double radius = std::pow(2.0 * inertia / (kSteel * std::numbers::pi), 0.2);
  return make_cylinder(Vector::UnitZ(), radius, 0.5 * radius);
}

Solid make_body(const Vector& center, double mass, const spatial::Tensor& inertia) {
  const Eigen::SelfAdjointEigenSolver<spatial::Tensor> principal(inertia);
  const Vector& moments = principal.eigenvalues();
  spatial::Tensor axes = principal.eigenvectors();
  if (axes.determinant() < 0.0) axes.col(2) = -axes.col(2);
  Solid solid;
  if (const int odd = find_odd(moments); odd >= 0) {
    // A cylinder has J = m r^2/2 along its axis, m (3 r^2 + h^2)/12 across it.
    const double square = 2.0 * moments[odd] / mass;
    const double height = std::sqrt(std::max(0.0, 12.0 * moments[1] / mass - 3.0 * square));
    const double radius = std::sqrt(square);
    solid = make_cylinder(axes.col(odd), std::max(radius, kThinnest * height),
                          0.5 * std::max(height, kThinnest * radius));
  } else {
    solid = make_box(axes, half_edges(mass, moments));
  }
  place(center, spatial::Tensor::Identity(), solid);
  return solid;
}

Solid make_cylinder(const Vector& axis, double radius, double half_height) {
  const Vector along = axis.normalized();
  const Vector x = along.unitOrthogonal(), y = along.cross(x);
  Solid cylinder;
  std::vector<int> bottom, top;
  for (int k = 0; k < kSides; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kSides;
    const Vector rim = radius * (std::cos(angle) * x + std::sin(angle) * y);
    cylinder.vertices.emplace_back(rim - half_height * along);
    cylinder.vertices.emplace_back(rim + half_height * along);
    const int next = (k + 1) % kSides;
    cylinder.faces.push_back({2 * k, 2 * next, 2 * next + 1, 2 * k + 1});
    top.push_back(2 * k + 1);
    bottom.insert(bottom.begin(), 2 * k);
  }
  cylinder.faces.push_back(bottom);
  cylinder.faces.push_back(top);
  return cylinder;
}

void place(const Vector& p, const spatial::Tensor& R, Solid& solid) {
  for (Vector& vertex : solid.vertices) vertex = p + R * vertex;
}

}  // namespace spoke::scene
