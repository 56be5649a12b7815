// Solids that cannot be used: interfaces, materials, meshes from arrays.

#include <doctest/doctest.h>

#include <functional>
#include <limits>
#include <memory>
#include <string>

#include "models/error.h"
#include "models/solid/solid.h"
#include "tests/models/solid/grid_mesh.h"

using namespace spoke;
using namespace spoke::test;
using spatial::ElementKind;
using spatial::SolidBody;
using spatial::SolidMesh;
using spatial::Vector;

namespace {

/// Checks what make_geometry() says of a bar with two interfaces that was made wrong.
void check_body(const std::function<void(SolidBody&, SolidMesh&)>& change, const std::string& key,
                const std::string& expected) {
  CAPTURE(expected);
  auto mesh = std::make_shared<SolidMesh>(
      make_grid_mesh({.cells = {2, 1, 1}, .lengths = {0.4, 0.1, 0.1}, .kind = ElementKind::tet10}));
  SolidBody body;
  body.material = spatial::SolidMaterial{7e10, 0.33, 2700.0};
  body.interfaces.push_back({.name = "root", .nodes = "X0"});
  body.interfaces.push_back({.name = "tip", .nodes = "X1"});
  body.mesh = mesh;
  change(body, *mesh);
  try {
    solid::make_geometry(body);
    FAIL_CHECK("no error");
  } catch (const InputError& error) {
    CHECK(std::string(error.what()) == expected);
    CHECK(error.place().key == key);
  }
}

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("bad interfaces and materials are refused at their key") {
  check_body([](SolidBody& body, SolidMesh&) { body.interfaces.clear(); }, "interface",
             "is missing, expected at least one");
  check_body([](SolidBody& body, SolidMesh&) { body.interfaces[1].name = "root"; },
             "interface.2.name", "is \"root\", as of interface 1, expected another name");
  check_body([](SolidBody& body, SolidMesh&) { body.interfaces[1].nodes = "X2"; },
             "interface.2.nodes", "is \"X2\", did you mean \"X0\"?");
  check_body([](SolidBody& body, SolidMesh&) { body.interfaces[1].nodes = "WING"; },
             "interface.2.nodes",
             "is \"WING\", expected \"X0\", \"X1\", \"Y0\", \"Y1\", \"Z0\" or \"Z1\"");
  check_body([](SolidBody&, SolidMesh& mesh) { mesh.sets.clear(); }, "interface.1.nodes",
             "is \"X0\", but the mesh has no sets, expected a plane, a cylinder or a box, or a "
             "mesh with physical groups (gmsh) or *NSET");
  check_body(
      [](SolidBody&, SolidMesh& mesh) { mesh.sets[1].nodes.clear(), mesh.sets[1].faces.clear(); },
      "interface.2.nodes",
      "chooses no nodes: set \"X1\" has none of volume elements, expected nodes of tetrahedra or "
      "hexahedra");
  check_body(
      [](SolidBody&, SolidMesh& mesh) { mesh.sets[1].nodes.resize(1), mesh.sets[1].faces.clear(); },
      "interface.2.nodes", "chooses 1 node, expected three or more that are not on one line");
  check_body(
      [](SolidBody&, SolidMesh& mesh) { mesh.sets[1].nodes.resize(2), mesh.sets[1].faces.clear(); },
      "interface.2.nodes", "chooses 2 nodes, expected three or more that are not on one line");
  check_body(
      [](SolidBody&, SolidMesh& mesh) { mesh.sets[1].nodes.resize(3), mesh.sets[1].faces.clear(); },
      "interface.2.nodes",
      "chooses 3 nodes on one line, expected three or more that are not on one line");
  check_body([](SolidBody& body, SolidMesh&) { body.interfaces[1].nodes = "Y0"; },
             "interface.2.nodes",
             "shares node 1 with interface \"root\", expected nodes of its own (or both interfaces "
             "of kind \"average\")");
  check_body(
      [](SolidBody& body, SolidMesh&) {
        body.interfaces[1].nodes = spatial::PlaneNodes{Vector(9, 0, 0), Vector::UnitX(), 1e-6};
      },
      "interface.2.nodes",
      "chooses no nodes, expected some of the surface, which lies from (0, 0, 0) to (0.4, 0.1, "
      "0.1) m");
  check_body(
      [](SolidBody& body, SolidMesh&) {
        body.interfaces[1].nodes = spatial::PlaneNodes{Vector(0, 0, 0), Vector::Zero(), 1e-6};
      },
      "interface.2.nodes", "has a normal of length zero, expected a direction");
  check_body(
      [](SolidBody& body, SolidMesh&) {
        body.interfaces[1].nodes = spatial::PlaneNodes{Vector(0, 0, 0), Vector::UnitX(), -1.0};
      },
      "interface.2.nodes", "has a tolerance below zero, expected a distance in metres");
  check_body(
      [](SolidBody& body, SolidMesh&) {
        body.interfaces[1].nodes = spatial::CylinderNodes{Vector(0, 0, 0), Vector::UnitX(), -1.0};
      },
      "interface.2.nodes", "has a radius that is not positive, expected one in metres");
  check_body(
      [](SolidBody& body, SolidMesh&) {
        body.interfaces[1].nodes = spatial::CylinderNodes{Vector(kNaN, 0, 0), Vector::UnitX(), 1.0};
      },
      "interface.2.nodes", "has a point that is not finite, expected numbers");
  check_body(
      [](SolidBody& body, SolidMesh&) {
        body.interfaces[1].nodes = spatial::BoxNodes{Vector(1, 0, 0), Vector(0, 0, 0)};
      },
      "interface.2.nodes",
      "has a box that ends before it begins, expected from <= to in x, y and z");
  check_body([](SolidBody& body, SolidMesh&) { body.interfaces[1].point = Vector(kNaN, 0, 0); },
             "interface.2.point", "is not finite, expected a place [m]");
  check_body([](SolidBody& body, SolidMesh&) { body.material.reset(); }, "material",
             "is missing, expected youngs_modulus, poissons_ratio and density (or an .inp file "
             "with one isotropic material)");
  check_body([](SolidBody& body, SolidMesh&) { body.material->youngs_modulus = 0.0; },
             "material.youngs_modulus", "is 0, expected a positive number [Pa]");
  check_body([](SolidBody& body, SolidMesh&) { body.material->poissons_ratio = 0.5; },
             "material.poissons_ratio", "is 0.5, expected above -1 and below 0.5");
  check_body([](SolidBody& body, SolidMesh&) { body.material->density = 2.7e-9; },
             "material.density", "is 2.7e-09, expected 0.001 to 1e12 kg/m^3 (not t/mm^3)");
  check_body([](SolidBody& body, SolidMesh&) { body.material->density = kNaN; }, "material.density",
             "is nan, expected 0.001 to 1e12 kg/m^3 (not t/mm^3)");
  check_body([](SolidBody& body, SolidMesh&) { body.mesh.reset(); }, "mesh",
             "is missing, expected the file of a mesh");
  check_body([](SolidBody& body, SolidMesh&) { body.mesh.reset(), body.file = "no.msh"; }, "mesh",
             "no.msh: no such file, expected a mesh (gmsh .msh or Abaqus .inp)");
  check_body([](SolidBody& body,
                SolidMesh&) { body.mesh.reset(), body.file = "no.msh", body.length_scale = 0.0; },
             "scale.length", "is 0, expected metres by the file's unit of length");
}

TEST_CASE("bad meshes from arrays are refused") {
  check_body([](SolidBody&, SolidMesh& mesh) { mesh.elements.clear(); }, "mesh",
             "has no volume elements, expected tetrahedra or hexahedra (gmsh writes those of "
             "physical volumes, or all by Mesh.SaveAll = 1)");
  check_body([](SolidBody&, SolidMesh& mesh) { mesh.elements[3].nodes[2] = 99; }, "mesh",
             "the tet10 (volume element 4) has a node of index 99, expected 0 to 44");
  check_body([](SolidBody&, SolidMesh& mesh) { mesh.elements[3].nodes[2] = -1; }, "mesh",
             "the tet10 (volume element 4) has a node of index -1, expected 0 to 44");
  check_body(
      [](SolidBody&, SolidMesh& mesh) { mesh.elements[3].nodes[2] = mesh.elements[3].nodes[1]; },
      "mesh", "the tet10 (volume element 4) has node 33 twice, expected different nodes");
  check_body([](SolidBody&, SolidMesh& mesh) { mesh.nodes.push_back(Vector::Zero()); }, "mesh",
             "node 46 belongs to no element, expected nodes of elements only");
  check_body([](SolidBody&, SolidMesh& mesh) { mesh.nodes[4].x() = kNaN; }, "mesh",
             "node 5 has a place that is not finite, expected numbers");
  check_body(
      [](SolidBody&, SolidMesh& mesh) {
        mesh.labels = {1, 2};
      },
      "mesh", "has 2 labels of 45 nodes, expected as many or none");
  check_body(
      [](SolidBody&, SolidMesh& mesh) {
        std::swap(mesh.elements[3].nodes[1], mesh.elements[3].nodes[2]),
            std::swap(mesh.elements[3].nodes[4], mesh.elements[3].nodes[6]),
            std::swap(mesh.elements[3].nodes[8], mesh.elements[3].nodes[9]);
      },
      "mesh",
      "the tet10 (volume element 4) is inverted at node 1, expected a positive volume everywhere "
      "in it and nodes in the order of the format");
  check_body(
      [](SolidBody&, SolidMesh& mesh) {
        std::swap(mesh.elements[3].nodes[8], mesh.elements[3].nodes[9]);
      },
      "mesh",
      "the tet10 (volume element 4) has its mid node 23 far from the middle of its edge, expected "
      "it within 0.45 of the edge's length");
  check_body([](SolidBody&, SolidMesh& mesh) { mesh.elements.push_back(mesh.elements[3]); }, "mesh",
             "the tet10 (volume element 13) does not fit the face of volume element 4 at node 1, "
             "expected elements on both sides of it, with the same mid nodes");
  check_body(
      [](SolidBody&, SolidMesh& mesh) {
        for (Vector& x : mesh.nodes) x.z() = 0.0;
      },
      "mesh",
      "the tet10 (volume element 1) is degenerate at node 1, expected a positive volume everywhere "
      "in it");
  check_body(
      [](SolidBody&, SolidMesh& mesh) {
        for (Vector& x : mesh.nodes) x *= 1e5;
      },
      "mesh",
      "extends over 40000 m, expected at most 10000 m (of a file in mm: scale = { length = 1e-3 "
      "})");
  check_body(
      [](SolidBody&, SolidMesh& mesh) {
        for (Vector& x : mesh.nodes) x *= 1e3;
      },
      "mesh",
      "has a mass of 1.08e+10 kg, expected at most 1e9 kg (of a file in mm: scale = { length = "
      "1e-3 })");
  check_body(
      [](SolidBody&, SolidMesh& mesh) {
        for (Vector& x : mesh.nodes) x *= 1e-5;
      },
      "mesh",
      "extends over 4e-06 m, expected at least 1e-05 m (lengths are metres after scale.length)");
  check_body(
      [](SolidBody&, SolidMesh& mesh) {
        const int n = static_cast<int>(mesh.nodes.size());
        for (int k = 0; k < n; ++k)
          mesh.nodes.push_back(mesh.nodes[static_cast<std::size_t>(k)] + Vector(2, 0, 0));
        const auto elements = mesh.elements;
        for (auto element : elements) {
          for (int& node : element.nodes) node += n;
          mesh.elements.push_back(element);
        }
      },
      "mesh", "is of several parts: node 46 does not hang together with node 1, expected one body");
  check_body([](SolidBody&, SolidMesh& mesh) { mesh.sets[1].nodes[0] = 9999; }, "mesh",
             "has a set \"X1\" with a node of index 9999, expected ascending indices of nodes");
  check_body(
      [](SolidBody&, SolidMesh& mesh) { std::swap(mesh.sets[1].nodes[0], mesh.sets[1].nodes[1]); },
      "mesh", "has a set \"X1\" with a node of index 4, expected ascending indices of nodes");
  check_body([](SolidBody&, SolidMesh& mesh) { mesh.sets[1].faces[0].count = 5; }, "mesh",
             "has a set \"X1\" with a face of 5 nodes, expected 3, 4, 6 or 8");
  check_body([](SolidBody&, SolidMesh& mesh) { mesh.sets[1].faces[0].nodes[0] = 1; }, "mesh",
             "has a set \"X1\" with a face at a node of index 1, expected nodes of the set");
}
