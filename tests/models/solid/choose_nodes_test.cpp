// Surfaces, areas, weights and interfaces of meshes whose values are known in closed form.

#include "models/solid/choose_nodes.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "models/solid/solid.h"
#include "models/solid/surface.h"
#include "tests/message_of.h"
#include "tests/models/solid/grid_mesh.h"

using namespace spoke;
using namespace spoke::test;
using spatial::ElementKind;
using spatial::SolidBody;
using spatial::SolidMesh;
using spatial::Vector;

namespace {

constexpr auto kKinds = {ElementKind::tet4, ElementKind::tet10, ElementKind::hex8,
                         ElementKind::hex20};

SolidMesh make_box(ElementKind kind) {
  return make_grid_mesh({.cells = {4, 3, 2}, .lengths = {1.0, 0.3, 0.2}, .kind = kind});
}

double calc_error(double value, double expected) { return std::abs(value / expected - 1.0); }

/// A body of this mesh with one interface.
SolidBody make_body(SolidMesh mesh, const spatial::NodeChoice& nodes) {
  SolidBody body;
  body.mesh = std::make_shared<SolidMesh>(std::move(mesh));
  body.material = spatial::SolidMaterial{7e10, 0.33, 2700.0};
  body.interfaces.push_back({.name = "root", .nodes = nodes});
  return body;
}

/// Bends a mesh by y += c x^2, which keeps volumes; quadratic elements hold it exactly.
void bend(SolidMesh& mesh, double c) {
  for (Vector& x : mesh.nodes) x[1] += c * x[0] * x[0];
}

}  // namespace

TEST_CASE("the surface of a box turns about normals that point out of it") {
  for (const ElementKind kind : kKinds) {
    const SolidMesh mesh = make_box(kind);
    const auto surface = solid::find_surface(mesh);
    const bool is_tet = kind == ElementKind::tet4 || kind == ElementKind::tet10;
    CHECK(surface.size() == (is_tet ? 2u : 1u) * 2 * (4 * 3 + 4 * 2 + 3 * 2));
    const auto triangles = solid::split_into_triangles(surface);
    double area = 0.0;
    double volume = 0.0;
    for (const auto& [i, j, k] : triangles) {
      const auto node = [&](int n) { return mesh.nodes[static_cast<std::size_t>(n)]; };
      const Vector a = node(i), b = node(j), c = node(k);
      area += 0.5 * (b - a).cross(c - a).norm();
      volume += a.dot(b.cross(c)) / 6.0;  // by Gauss's theorem: positive if normals point out
    }
    CHECK(calc_error(area, 2.0 * (0.3 + 0.2 + 0.06)) < 1e-13);
    CHECK(calc_error(volume, 0.06) < 1e-13);
    CHECK(solid::nodes_of(surface).size() < mesh.nodes.size());
  }
}

TEST_CASE("faces S1 to S6 are Abaqus's") {
  const SolidMesh hex = make_grid_mesh({.kind = ElementKind::hex8});
  const auto faces = solid::faces_of(hex.elements[0]);
  const std::vector<std::vector<int>> expected{{1, 2, 3, 4}, {5, 8, 7, 6}, {1, 5, 6, 2},
                                               {2, 6, 7, 3}, {3, 7, 8, 4}, {4, 8, 5, 1}};
  REQUIRE(faces.size() == 6);
  for (std::size_t f = 0; f < 6; ++f)
    for (const int corner : expected[f]) {
      const int node = hex.elements[0].nodes[static_cast<std::size_t>(corner - 1)];
      CHECK(std::count(faces[f].nodes.begin(), faces[f].nodes.begin() + 4, node) == 1);
    }
}

TEST_CASE("weights are integrals of the shape functions over a rectangle") {
  for (const ElementKind kind : kKinds) {
    const SolidMesh mesh = make_box(kind);
    const auto chosen = solid::choose_nodes(mesh, "X1");
    CHECK(calc_error(chosen.area, 0.06) < 1e-13);
    CHECK(std::abs(std::accumulate(chosen.weights.begin(), chosen.weights.end(), 0.0) - 1.0) <
          1e-14);
    CHECK((chosen.point - Vector(1.0, 0.15, 0.1)).norm() < 1e-14);
    if (kind == ElementKind::tet4 || kind == ElementKind::hex8) continue;
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (std::size_t n = 0; n < chosen.nodes.size(); ++n) {
      const Vector r = mesh.nodes[static_cast<std::size_t>(chosen.nodes[n])] - chosen.point;
      spread += chosen.weights[n] * r * r.transpose();
    }
    CHECK(calc_error(spread(1, 1), 0.09 / 12.0) < 1e-12);
    CHECK(calc_error(spread(2, 2), 0.04 / 12.0) < 1e-12);
    CHECK(std::abs(spread(1, 2)) < 1e-15);
  }
  // One face: a sixth and none of the area; a third and a twelfth less.
  const auto tri = solid::choose_nodes(make_grid_mesh({.kind = ElementKind::tet10}), "X1");
  for (std::size_t n = 0; n < tri.nodes.size(); ++n)
    CHECK((std::abs(tri.weights[n]) < 1e-15 || std::abs(tri.weights[n] - 1.0 / 6.0) < 1e-14 ||
           std::abs(tri.weights[n] - 1.0 / 3.0) < 1e-14));
  const auto quad = solid::choose_nodes(make_grid_mesh({.kind = ElementKind::hex20}), "X1");
  for (std::size_t n = 0; n < quad.nodes.size(); ++n)
    CHECK(std::min(std::abs(quad.weights[n] + 1.0 / 12.0), std::abs(quad.weights[n] - 1.0 / 3.0)) <
          1e-14);
}

TEST_CASE("nodes that lie within some hundred-thousandths of a line are no interface") {
  // The scatter across an edge of 0.3 m must exceed 1e-9 of that along it.
  for (const double height : {1e-6, 5e-6, 5e-5}) {
    CAPTURE(height);
    SolidMesh mesh = make_box(ElementKind::hex8);
    std::vector<int> edge;
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
      if (mesh.nodes[i].x() == 0.0 && mesh.nodes[i].z() == 0.0) edge.push_back(static_cast<int>(i));
    REQUIRE(edge.size() == 4);
    for (std::size_t k = 0; k < 4; ++k)
      mesh.nodes[static_cast<std::size_t>(edge[k])].z() += k == 1 || k == 2 ? height : 0.0;
    CHECK(solid::are_on_line(mesh, edge) == (height < 1e-5));
    mesh.sets = {{"EDGE", edge, {}}};
    const auto error = message_of([&] { solid::make_geometry(make_body(mesh, "EDGE")); });
    CHECK((error.find("4 nodes on one line") != std::string::npos) == (height < 1e-5));
  }
}

TEST_CASE("plane, cylinder and box choose nodes of the surface, with the faces that they hold") {
  for (const ElementKind kind : kKinds) {
    SolidMesh mesh = make_box(kind);
    const auto by_name = solid::choose_nodes(mesh, "X1");
    spatial::PlaneNodes plane;
    plane.point = Vector(1.0, 7.0, 7.0);
    plane.normal = Vector(-3.0, 0.0, 0.0);
    const auto by_plane = solid::choose_nodes(mesh, plane);
    const auto by_box =
        solid::choose_nodes(mesh, spatial::BoxNodes{Vector(0.99, -1, -1), Vector(1.01, 1, 1)});
    CHECK(by_plane.nodes == by_name.nodes);
    CHECK(by_box.nodes == by_name.nodes);
    CHECK(calc_error(by_plane.area, 0.06) < 1e-13);
    for (std::size_t n = 0; n < by_name.nodes.size(); ++n)
      CHECK(std::abs(by_plane.weights[n] - by_name.weights[n]) < 1e-14);
    // A plane through the inside: nodes of the sides only, no faces; equal weights.
    plane.point.x() = 0.5;
    const auto inside = solid::choose_nodes(mesh, plane);
    CHECK(inside.area == 0.0);
    for (const double weight : inside.weights)
      CHECK(calc_error(weight, 1.0 / static_cast<double>(inside.nodes.size())) < 1e-14);
    // The faces of a named set without any of its own are found on the surface.
    for (auto& set : mesh.sets) set.faces.clear();
    CHECK(calc_error(solid::choose_nodes(mesh, "X1").area, 0.06) < 1e-13);
  }
}

TEST_CASE("the bore of a tube is chosen by a cylinder, and has its area") {
  constexpr double kPi = 3.14159265358979323846;
  for (const ElementKind kind : {ElementKind::tet10, ElementKind::hex20}) {
    SolidMesh mesh = make_grid_mesh({.cells = {12, 1, 3}, .kind = kind});
    for (Vector& x : mesh.nodes) {  // three quarters of a turn; y is along the radius
      const double angle = 1.5 * kPi * x[0], r = 0.4 + 0.2 * x[1];
      x = Vector(r * std::sin(angle), r * std::cos(angle), 2.0 * x[2]);
    }
    spatial::CylinderNodes bore;
    bore.axis = Vector(0.0, 0.0, 3.0);
    bore.radius = 0.4;
    const auto chosen = solid::choose_nodes(mesh, bore);
    CHECK(calc_error(chosen.area, 1.5 * kPi * 0.4 * 2.0) < 2e-4);
    // The centroid of three quarters of a circle lies at 0.4 sin(3/4 pi) / (3/4 pi) at half the
    // arc.
    const double radius = 0.4 * std::sin(0.75 * kPi) / (0.75 * kPi);
    CHECK((chosen.point - Vector(radius * std::sin(0.75 * kPi), radius * std::cos(0.75 * kPi), 1.0))
              .norm() < 2e-4);
  }
}

TEST_CASE("mass and moments of a box and of a bent box are exact") {
  for (const ElementKind kind : kKinds)
    for (const double c : {0.0, 0.2}) {
      const bool is_linear = kind == ElementKind::tet4 || kind == ElementKind::hex8;
      if (is_linear && c != 0.0) continue;
      SolidMesh mesh = make_box(kind);
      bend(mesh, c);
      const SolidBody body = make_body(std::move(mesh), "X0");
      const auto geometry = solid::make_geometry(body);
      const double mass = 2700.0 * 0.06;
      CHECK(calc_error(geometry.mass, mass) < 1e-13);
      CHECK((geometry.interfaces[0].point - Vector(0.0, 0.15, 0.1)).norm() < 1e-14);
      CHECK((geometry.first_moment - mass * Vector(0.5, c / 3.0, 0.0)).norm() < 1e-12 * mass);
      const Eigen::Matrix3d& J = geometry.second_moment;
      CHECK(calc_error(J(0, 0), mass / 3.0) < 1e-12);
      CHECK(calc_error(J(1, 1), mass * (0.09 / 12.0 + c * c / 5.0)) < 1e-12);
      CHECK(calc_error(J(2, 2), mass * 0.04 / 12.0) < 1e-12);
      CHECK(std::abs(J(0, 1) - mass * c / 4.0) < 1e-12 * mass);
      CHECK((J - J.transpose()).norm() <= 1e-12 * J.norm());
    }
}

TEST_CASE("the area of a bent side is that of the parabola") {
  for (const ElementKind kind : {ElementKind::tet10, ElementKind::hex20}) {
    SolidMesh mesh = make_box(kind);
    bend(mesh, 0.2);
    const double s = 0.4;  // slope at the end
    const double length = (s * std::sqrt(1.0 + s * s) + std::asinh(s)) / (2.0 * s);
    CHECK(calc_error(solid::choose_nodes(mesh, "Y1").area, 0.2 * length) < 1e-8);
    CHECK(calc_error(solid::choose_nodes(mesh, "Z1").area, 0.3) < 1e-12);
  }
}

TEST_CASE("an interface has the point that is given, or the mean of its faces") {
  SolidBody body = make_body(make_box(ElementKind::tet10), "X0");
  body.interfaces[0].point = Vector(-0.5, 0.0, 0.0);
  body.interfaces.push_back(
      {.name = "tip", .nodes = "X1", .kind = spatial::InterfaceKind::average});
  const auto geometry = solid::make_geometry(body);
  CHECK(geometry.interfaces[0].point == Vector(-0.5, 0.0, 0.0));
  CHECK((geometry.interfaces[1].point - Vector(1.0, 0.15, 0.1)).norm() < 1e-14);
  CHECK(geometry.first_moment.x() == doctest::Approx(geometry.mass * 1.0).epsilon(1e-12));
}

TEST_CASE("average interfaces may share nodes, rigid ones may not") {
  using spatial::InterfaceKind;
  for (const auto& [first, second] : {std::pair(InterfaceKind::rigid, InterfaceKind::rigid),
                                      std::pair(InterfaceKind::rigid, InterfaceKind::average),
                                      std::pair(InterfaceKind::average, InterfaceKind::rigid),
                                      std::pair(InterfaceKind::average, InterfaceKind::average)}) {
    SolidBody body = make_body(make_box(ElementKind::hex20), "X0");
    body.interfaces[0].kind = first;
    body.interfaces.push_back({.name = "side", .nodes = "Y0", .kind = second});
    const std::string message = message_of([&] { solid::make_geometry(body); });
    if (first == InterfaceKind::average && second == InterfaceKind::average)
      CHECK(message == "no error");
    else
      CHECK(message ==
            "shares node 1 with interface \"root\", expected nodes of its own (or both interfaces "
            "of kind \"average\")");
  }
}
