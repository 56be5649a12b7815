// What an .inp file says beside nodes and volumes: honoured, told, or refused by name.

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "models/error.h"
#include "models/hints.h"
#include "models/solid/assembly.h"
#include "models/solid/mesh_check.h"
#include "models/solid/parse_mesh.h"
#include "models/solid/solid.h"
#include "tests/message_of.h"
#include "tests/models/solid/grid_mesh.h"

using doctest::Approx;
using namespace spoke;
using namespace spoke::test;
using spatial::SolidMesh;
using spatial::Vector;

namespace {

// A tetrahedron of 1/6 m^3; what is added begins in line 9.
const std::string kBody =
    "*NODE\n1, 0., 0., 0.\n2, 1., 0., 0.\n3, 0., 1., 0.\n4, 0., 0., 1.\n5, 0., 0., 2.\n"
    "*ELEMENT, TYPE=C3D4, ELSET=ALL\n1, 1, 2, 3, 4\n";
const std::string kSteel = "*MATERIAL, NAME=STEEL\n*DENSITY\n7800.\n*ELASTIC\n2.1E11, 0.3\n";

std::shared_ptr<const SolidMesh> read(const std::string& rest, double scale = 1.0) {
  return solid::parse_mesh(kBody + rest, "m.inp", scale);
}
std::string refusal_of(const std::string& rest, double scale = 1.0) {
  return message_of([&] { solid::check_mesh(*read(rest, scale)); });
}

/// A body of a mesh, held at the nodes of its bottom.
spatial::SolidBody body_of(std::shared_ptr<const SolidMesh> mesh) {
  spatial::SolidBody body;
  body.mesh = std::move(mesh);
  body.material = {2.1e11, 0.3, 7800.0};
  body.interfaces = {{.name = "root", .nodes = spatial::BoxNodes{{0, 0, 0}, {1, 1, 0}}}};
  return body;
}

/// The hints at a model of one solid.
std::vector<std::string> hints_of(spatial::SolidBody body) {
  Scenario scenario;
  scenario.space.emplace();
  spatial::Subsystem& arm = scenario.space->subsystems.emplace_back();
  arm.name = "arm";
  arm.bodies.push_back({"bar", std::move(body)});
  return find_hints(scenario);
}

constexpr const char* kMassElement = "*ELEMENT, TYPE=MASS, ELSET=PM\n2, 4\n";

}  // namespace

TEST_CASE("point masses count in mass, moments and the mass matrix") {
  const auto mesh = read(std::string(kMassElement) + "*MASS, ELSET=PM\n500.\n");
  REQUIRE(mesh->masses.size() == 1);
  const solid::SolidGeometry with = solid::make_geometry(body_of(mesh));
  const solid::SolidGeometry without = solid::make_geometry(body_of(read("")));
  CHECK(without.mass == Approx(1300.0));
  CHECK(with.mass == Approx(1800.0));
  const Vector r = Vector::UnitZ() - with.interfaces[0].point;
  CHECK((with.first_moment - without.first_moment - 500.0 * r).norm() < 1e-9);
  CHECK((with.second_moment - without.second_moment - 500.0 * r * r.transpose()).norm() < 1e-9);
  const solid::NodeMatrices matrices = solid::assemble(*mesh, *body_of(mesh).material);
  CHECK(matrices.m.sum() == Approx(1800.0));
}

TEST_CASE("a bar that is stretched with a mass at its end has the energies of the closed form") {
  // u = x: strain 1 in a bar of E = 8, A = 0.06, L = 2, and 5 kg at the end beside 3 kg/m^3.
  SolidMesh mesh = make_grid_mesh(
      {.cells = {2, 1, 1}, .lengths = {2.0, 0.3, 0.2}, .kind = spatial::ElementKind::hex20});
  for (const auto& set : mesh.sets)
    if (set.name == "X1")
      for (const int node : set.nodes)
        mesh.masses.push_back({node, 5.0 / static_cast<double>(set.nodes.size())});
  solid::check_mesh(mesh);
  const solid::NodeMatrices matrices = solid::assemble(mesh, {8.0, 0.0, 3.0});
  Eigen::VectorXd x(static_cast<Eigen::Index>(mesh.nodes.size()));
  for (Eigen::Index n = 0; n < x.size(); ++n) x[n] = mesh.nodes[static_cast<std::size_t>(n)].x();
  Eigen::VectorXd u = Eigen::VectorXd::Zero(3 * x.size());
  for (Eigen::Index n = 0; n < x.size(); ++n) u[3 * n] = x[n];
  CHECK(u.dot(matrices.K * u) == Approx(8.0 * 0.06 * 2.0));
  CHECK(x.dot(matrices.m * x) == Approx(3.0 * 0.06 * 8.0 / 3.0 + 5.0 * 4.0));
}

TEST_CASE("masses that cannot be honoured are refused at their line") {
  const std::string element = kMassElement;
  for (const auto& bad : std::vector<std::pair<std::string, std::string>>{
           {element, "10: element 2 of type MASS has no mass, expected *MASS of its set"},
           {element + "*MASS, ELSET=PM\n-1.\n", "12: is a mass below zero, expected 0 or more"},
           {element + "*MASS, ELSET=PM\n", "11: has no mass, expected one"},
           {element + "*MASS, ELSET=PN\n1.\n",
            "11: *MASS is of the set \"PN\", which the file does not have, expected one of "
            "elements"},
           {element + "*MASS, ELSET=ALL\n1.\n",
            "11: *MASS is of element 1 (line 8), expected elements of type MASS"},
           {element + "*MASS, ELSET=PM, TYPE=ANISOTROPIC\n1., 2., 3.\n",
            "11: has masses of type \"ANISOTROPIC\", expected ISOTROPIC, the same along all axes"},
           {"*ELEMENT, TYPE=MASS, ELSET=PM\n2, 5\n*MASS, ELSET=PM\n1.\n",
            "10: a point mass is at node 5, which no volume element has, expected a node of one "
            "(or "
            "a rigid body on an interface)"},
           {"*ELEMENT, TYPE=ROTARYI, ELSET=RI\n2, 4\n",
            "9: has elements of type \"ROTARYI\", expected C3D4, C3D10, C3D8 or C3D20, or faces "
            "(CPS3, CPS6, CPS4, CPS8)"}}) {
    CAPTURE(bad.first);
    CHECK(refusal_of(bad.first) == "m.inp:" + bad.second);
  }
  CHECK(refusal_of(element + "*MASS, ELSET=PM\n1.\n", 1e-3) ==
        "m.inp:10: a point mass is in a file with scale.length, so that its unit is not known, "
        "expected a file in SI units (or a rigid body on an interface)");
  SolidMesh mesh = *read("");
  mesh.masses = {{4, 1.0}};
  CHECK(message_of([&] { solid::check_mesh(mesh); }) ==
        "m.inp: has a mass at a node of index 4, expected 0 to 3");
  mesh.masses = {{3, -1.0}};
  CHECK(message_of([&] { solid::check_mesh(mesh); }) ==
        "m.inp: has a mass of -1 kg at node 4, expected 0 or more");
}

TEST_CASE("what makes another body of a mesh is refused by name") {
  for (const std::string keyword :
       {"EQUATION", "MPC", "TIE", "RIGID BODY", "COUPLING", "KINEMATIC COUPLING", "CONTACT PAIR",
        "SPRING", "DASHPOT", "SHELL SECTION", "MEMBRANE SECTION", "BEAM SECTION", "ROTARY INERTIA",
        "NONSTRUCTURAL MASS", "EMBEDDED ELEMENT", "CYCLIC SYMMETRY MODEL", "MATRIX ASSEMBLE"}) {
    CAPTURE(keyword);
    CHECK(refusal_of('*' + keyword + ", ELSET=ALL\n1, 2, 3\n")
              .starts_with("m.inp:9: *" + keyword + " is not built, expected a mesh without ("));
  }
  CHECK(refusal_of("*equation\n2\n") ==
        "m.inp:9: *EQUATION is not built, expected a mesh without (interfaces tie nodes, as kind = "
        "\"rigid\" or \"average\")");
  CHECK(refusal_of("*SHELL  SECTION\n0.1\n").starts_with("m.inp:9: *SHELL  SECTION is not built"));
  for (const std::string type : {"SPRINGA", "DASHPOTA", "GAPUNI", "CONN3D2", "DCOUP3D", "US3"})
    CHECK(refusal_of("*ELEMENT, TYPE=" + type + "\n2, 1, 2\n")
              .starts_with("m.inp:9: has elements of type \"" + type + "\", expected C3D4"));
  // Sections make structures of faces and lines, which else name places.
  const std::string truss = "*ELEMENT, TYPE=T3D2, ELSET=BARS\n2, 1, 2\n";
  const std::string faces = "*ELEMENT, TYPE=CPS3, ELSET=SIDE\n2, 1, 2, 3\n";
  CHECK(refusal_of(truss + faces.substr(0, faces.find('\n')) + "\n3, 1, 2, 3\n") == "no error");
  CHECK(refusal_of(truss + "*SOLID SECTION, ELSET=BARS, MATERIAL=M\n0.01\n") ==
        "m.inp:11: *SOLID SECTION is of element 2 (line 10), expected elements of volumes only");
  CHECK(refusal_of(faces + "*SURFACE SECTION, ELSET=SIDE\n") == "no error");
  CHECK(refusal_of(faces + "*SURFACE SECTION, ELSET=SIDE, DENSITY=3.\n") ==
        "m.inp:11: *SURFACE SECTION is not built, expected a mesh without (*MASS at its nodes)");
  CHECK(refusal_of("*ELEMENT, TYPE=S3, ELSET=PLATE\n2, 2, 3, 5\n") ==
        "m.inp:10: a face of the set \"PLATE\" has a node of no volume element, expected places of "
        "the body: shells are not built");
}

TEST_CASE("matrices of another program take nodes from a file with anything in it") {
  namespace fs = std::filesystem;
  const fs::path file = fs::temp_directory_path() / "spoke_any_content.inp";
  std::ofstream(file) << kBody << kMassElement
                      << "*EQUATION\n2\n1, 1, 1., 2, 1, -1.\n*SHELL SECTION, ELSET=X\n1.\n";
  CHECK(solid::read_node_mesh(file.string(), 1.0)->nodes.size() == 5);
  fs::remove(file);
}

TEST_CASE("what a solid has in another way is told, once and with its line") {
  const auto mesh = read("*BOUNDARY\n1, 1, 3\n*BOUNDARY\n2, 1, 3\n*AMPLITUDE, NAME=A\n0., 1.\n" +
                         kSteel + "*PLASTIC\n2.e8, 0.\n*SOMETHING NEW\n1.\n" +
                         "*STEP\n*STATIC\n1., 1.\n*CLOAD\n4, 3, 1.\n*NODE FILE\nU\n*END STEP\n");
  CHECK(mesh->left_out == std::vector<std::string>{"*BOUNDARY (line 9)", "*PLASTIC (line 20)",
                                                   "*SOMETHING NEW (line 22)", "*CLOAD (line 27)"});
  std::vector<std::string> hints = hints_of(body_of(mesh));
  REQUIRE(hints.size() == 2);  // the elements lock
  CHECK(hints[1] ==
        "the mesh of arm / bar leaves out *BOUNDARY (line 9), *PLASTIC (line 20), *SOMETHING NEW "
        "(line 22) and *CLOAD (line 27) of its file: joints hold a solid at its interfaces, "
        "[[load]] tables load it, its material is linear");
  CHECK(hints_of(body_of(read(kSteel))).size() == 1);
}

TEST_CASE("materials of the file that are not those of the body are told or refused") {
  const std::string other = "*MATERIAL, NAME=ALU\n*DENSITY\n2700.\n*ELASTIC\n7.E10, 0.3\n";
  const std::string fibres =
      "*MATERIAL, NAME=CF\n*ELASTIC, TYPE=ENGINEERING CONSTANTS\n1.,1.,1.,0.,0.,0.,1.,1.,\n1.\n";
  const std::string warm = "*MATERIAL, NAME=W\n*ELASTIC\n1.E9, .3, 20.\n2.E9, .3, 90.\n";
  for (const auto& file : std::vector<std::pair<std::string, std::string>>{
           {kSteel, ""},
           {kSteel + other, "has 2 materials, \"STEEL\" (line 9) and \"ALU\" (line 14)"},
           {kSteel + other + "*SOLID SECTION, ELSET=ALL, MATERIAL=alu\n", ""},
           {fibres,
            "has a material, \"CF\", whose *ELASTIC is of type \"ENGINEERING CONSTANTS\" (line "
            "10), not isotropic"},
           {warm, "has a material, \"W\", whose *ELASTIC depends on temperature (line 10)"}}) {
    CAPTURE(file.first);
    const std::string fault = file.second;
    const auto mesh = read(file.first);
    CHECK(mesh->material_fault == fault);
    const std::vector<std::string> hints = hints_of(body_of(mesh));
    REQUIRE(hints.size() == (fault.empty() ? 1 : 2));
    if (fault.empty()) continue;
    CHECK(hints[1] == "the file of the mesh of arm / bar " + fault +
                          "; the scenario's isotropic material is that of all its elements");
    spatial::SolidBody body = body_of(mesh);
    body.material.reset();
    CHECK(message_of([&] { solid::make_geometry(body); }) ==
          "is missing, and the mesh's file " + fault +
              "; expected youngs_modulus, poissons_ratio and density (or an .inp file with one "
              "isotropic material)");
  }
}

TEST_CASE("a modulus in GPa is asked about") {
  spatial::SolidBody body = body_of(read(""));
  body.material->youngs_modulus = 210.0;
  const std::vector<std::string> hints = hints_of(body);
  REQUIRE(hints.size() == 2);
  CHECK(hints[0] ==
        "the material of arm / bar has Young's modulus 210 Pa and density 7800 kg/m^3, in which "
        "waves would run at 0.164083 m/s, slower than in any part: MPa or GPa?");
  body.material = {5e5, 0.49, 1100.0};  // soft silicone
  CHECK(hints_of(body).size() == 1);
}
