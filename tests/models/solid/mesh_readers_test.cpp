// One mesh from files of all formats.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "models/solid/parse_mesh.h"
#include "models/solid/solid.h"
#include "tests/models/solid/grid_mesh.h"
#include "tests/models/solid/mesh_texts.h"

using namespace spoke;
using namespace spoke::test;
using spatial::ElementKind;
using spatial::SolidMesh;
using spatial::SolidNodeSet;

namespace {

const SolidNodeSet* find_set(const SolidMesh& mesh, const std::string& name) {
  for (const SolidNodeSet& set : mesh.sets)
    if (set.name == name) return &set;
  return nullptr;
}

bool are_equal(const SolidNodeSet& a, const SolidNodeSet& b) {
  if (a.nodes != b.nodes || a.faces.size() != b.faces.size()) return false;
  for (std::size_t f = 0; f < a.faces.size(); ++f)
    if (a.faces[f].count != b.faces[f].count || a.faces[f].nodes != b.faces[f].nodes) return false;
  return true;
}

void check_equal(const SolidMesh& read, const SolidMesh& mesh) {
  REQUIRE(read.nodes.size() == mesh.nodes.size());
  CHECK(read.nodes == mesh.nodes);
  CHECK(read.labels == mesh.labels);
  REQUIRE(read.elements.size() == mesh.elements.size());
  int differ = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    differ += read.elements[e].kind != mesh.elements[e].kind ||
              read.elements[e].nodes != mesh.elements[e].nodes;
  CHECK(differ == 0);
  for (const SolidNodeSet& set : mesh.sets) {
    CAPTURE(set.name);
    const SolidNodeSet* found = find_set(read, set.name);
    REQUIRE(found != nullptr);
    CHECK(are_equal(*found, set));
  }
  const SolidNodeSet* body = find_set(read, "BODY");
  REQUIRE(body != nullptr);
  CHECK(body->nodes.size() == mesh.nodes.size());
  CHECK(body->faces.empty());
}

constexpr auto kKindsRead = {ElementKind::tet4, ElementKind::tet10, ElementKind::hex8,
                             ElementKind::hex20};

}  // namespace

TEST_CASE("a mesh is the same from gmsh's formats and from Abaqus's") {
  for (const ElementKind kind : kKindsRead)
    for (const bool has_gaps : {false, true}) {
      SolidMesh mesh =
          make_grid_mesh({.cells = {3, 2, 2}, .lengths = {1.0, 0.3, 0.2}, .kind = kind});
      number_with_gaps(mesh);
      if (!has_gaps)
        for (std::size_t n = 0; n < mesh.labels.size(); ++n)
          mesh.labels[n] = static_cast<int>(n + 1);
      CAPTURE(std::string(name_of(kind)));
      for (const MshForm form : {MshForm::text, MshForm::binary, MshForm::swapped_binary}) {
        CAPTURE(static_cast<int>(form));
        check_equal(*solid::parse_mesh(write_msh22(mesh, form), "m.msh", 1.0), mesh);
        check_equal(*solid::parse_mesh(write_msh41(mesh, form), "m.msh", 1.0), mesh);
      }
      check_equal(*solid::parse_mesh(write_inp(mesh), "m.inp", 1.0), mesh);
    }
}

TEST_CASE("elements know their lines, the mesh its file and lengths are scaled") {
  const SolidMesh mesh = make_grid_mesh({.cells = {1, 1, 1}, .kind = ElementKind::hex20});
  const std::string text = write_inp(mesh);
  const auto read = solid::parse_mesh(text, "m.inp", 1e-3);
  CHECK(read->file == "m.inp");
  const std::size_t at = text.find("type=C3D20");
  CHECK(read->elements[0].line ==
        std::count(text.begin(), text.begin() + static_cast<long>(at), '\n') + 2);
  CHECK(read->nodes[3][0] == doctest::Approx(1e-3 * mesh.nodes[3][0]).epsilon(1e-15));
  const auto gmsh = solid::parse_mesh(write_msh22(mesh), "m.msh", 1.0);
  CHECK(gmsh->elements[0].line > 30);
}

TEST_CASE("an .inp file has sets of every kind, and one material") {
  const std::string text =
      "*HEADING\n*PART, NAME=P\n*NODE, NSET=ALL\n"
      "1, 0., 0., 0.\n2, 1., 0., 0.\n 3, 0., 1., 0.\n4, 0., 0., 1.\n5, 1., 1., 1.\n"
      "*ELEMENT, TYPE=C3D4, ELSET=VOLUME\n1, 1,2,3,4\n2, 2, 3, 4, \n 5\n"
      "*ELEMENT, TYPE=T3D2, ELSET=BARS\n9, 1, 2\n"
      "*NSET, NSET=odd, GENERATE\n1, 5, 2\n"
      "*NSET, NSET=\"More nodes\"\nODD, 2,\n"
      "*ELSET, ELSET=Both\nvolume\n"
      "*SURFACE, NAME=Top, TYPE=ELEMENT\n1, S1\n"
      "*SURFACE, NAME=Sides\nBoth, S2\n"
      "*END PART\n*ASSEMBLY, NAME=A\n*INSTANCE, NAME=I, PART=P\n0., 0., 0.\n*END INSTANCE\n"
      "*NODE\n1, 9., 9., 9.\n*NSET, NSET=REFERENCE\n1\n"
      "*NSET, NSET=root, INSTANCE=I\n1, 2, 3\n*NSET, NSET=dotted\nI.4, I.5\n*END ASSEMBLY\n"
      "*SOLID SECTION, ELSET=VOLUME, MATERIAL=steel\n"
      "*MATERIAL, NAME=other\n*ELASTIC\n1., 0.\n"
      "*MATERIAL, NAME=STEEL\n*ELASTIC, TYPE=ISOTROPIC\n2.1E11, 0.3\n*DENSITY\n7850.\n"
      "*STEP\n*STATIC\n1., 1.\n*END STEP\n";
  std::optional<spatial::SolidMaterial> material;
  const auto mesh = solid::parse_mesh(text, "m.inp", 1.0, &material);
  REQUIRE(mesh->nodes.size() == 5);
  REQUIRE(mesh->elements.size() == 2);
  CHECK(mesh->elements[1].nodes[3] == 4);
  const auto nodes = [&](const char* name) {
    const SolidNodeSet* set = find_set(*mesh, name);
    REQUIRE(set != nullptr);
    return set->nodes;
  };
  using Nodes = std::vector<int>;
  CHECK(nodes("ALL") == Nodes{0, 1, 2, 3, 4});
  CHECK(nodes("odd") == Nodes{0, 2, 4});
  CHECK(nodes("More nodes") == Nodes{0, 1, 2, 4});
  CHECK(nodes("Both") == Nodes{0, 1, 2, 3, 4});
  CHECK(nodes("Top") == Nodes{0, 1, 2});
  CHECK(nodes("Sides") == Nodes{0, 1, 2, 3, 4});  // 1-4-2 and 2-5-3
  CHECK(nodes("REFERENCE").empty());
  CHECK(nodes("root") == Nodes{0, 1, 2});
  CHECK(nodes("dotted") == Nodes{3, 4});
  CHECK(find_set(*mesh, "Sides")->faces.size() == 2);
  REQUIRE(material);
  CHECK(material->youngs_modulus == 2.1e11);
  CHECK(material->poissons_ratio == 0.3);
  CHECK(material->density == 7850.0);
}

TEST_CASE("a material that is not one and constant is not taken") {
  const std::string start =
      "*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n4,0,0,1\n*ELEMENT, TYPE=C3D4\n1,1,2,3,4\n";
  const std::string density = "*DENSITY\n1.\n";
  for (const std::string& rest : std::vector<std::string>{
           std::string(), "*MATERIAL, NAME=A\n*ELASTIC\n1., .3, 20.\n2., .3, 90.\n" + density,
           "*MATERIAL, NAME=A\n*ELASTIC, TYPE=ORTHO\n1.,1.,1.\n" + density,
           "*MATERIAL, NAME=A\n*ELASTIC\n1., .3\n*MATERIAL, NAME=B\n*ELASTIC\n2., .3\n"}) {
    std::optional<spatial::SolidMaterial> material;
    solid::parse_mesh(start + rest, "m.inp", 1.0, &material);
    CHECK_FALSE(material);
  }
}

TEST_CASE("types of elements of Abaqus that are read as one mesh") {
  const std::string nodes = "*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n4,0,0,1\n";
  for (const char* type : {"C3D4", "C3D4H", "c3d4"})
    CHECK(solid::parse_mesh(nodes + "*ELEMENT, TYPE=" + type + "\n1,1,2,3,4\n", "m.inp", 1.0)
              ->elements.size() == 1);
  for (const char* type :
       {"CPS3", "S3", "S3R", "STRI3", "M3D3", "SFM3D3", "R3D3", "CPE3", "CPS3"}) {
    CAPTURE(type);
    const auto mesh = solid::parse_mesh(
        nodes + "*ELEMENT, TYPE=C3D4\n1,1,2,3,4\n*ELEMENT, TYPE=" + type + ", ELSET=F\n2,1,2,3\n",
        "m.inp", 1.0);
    REQUIRE(find_set(*mesh, "F") != nullptr);
    CHECK(find_set(*mesh, "F")->faces.size() == 1);
  }
}

TEST_CASE("nodes that no element uses are dropped, from sets too") {
  const auto mesh = solid::parse_mesh(
      "*NODE\n30,0,0,0\n2,9,9,9\n20,1,0,0\n40,0,1,0\n10,0,0,1\n*NSET, NSET=S\n2, 10, 40\n"
      "*NSET, NSET=LOST\n2\n*ELEMENT, TYPE=C3D4\n1,30,20,40,10\n",
      "m.inp", 1.0);
  CHECK(mesh->labels == std::vector<int>{10, 20, 30, 40});
  CHECK(find_set(*mesh, "S")->nodes == std::vector<int>{0, 3});
  CHECK(find_set(*mesh, "LOST")->nodes.empty());
  CHECK(mesh->elements[0].nodes[0] == 2);
}

TEST_CASE(
    "groups of gmsh without a name have their number and elements of two volumes count once") {
  const std::string head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
  const std::string nodes = "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n";
  const auto mesh = solid::parse_mesh(
      head + nodes +
          "$Elements\n5\n1 2 2 7 1 1 3 2\n2 4 2 8 1 1 2 3 4\n3 4 2 9 1 1 2 3 4\n4 15 2 5 1 4\n"
          "5 1 2 6 1 1 2\n$EndElements\n$NodeData\nanything\n$EndNodeData\n",
      "m.msh", 1.0);
  CHECK(mesh->elements.size() == 1);
  REQUIRE(find_set(*mesh, "7") != nullptr);
  CHECK(find_set(*mesh, "7")->faces.size() == 1);
  CHECK(find_set(*mesh, "5")->nodes == std::vector<int>{3});
  CHECK(find_set(*mesh, "6")->nodes == std::vector<int>{0, 1});
  CHECK(find_set(*mesh, "9")->nodes.size() == 4);
}

TEST_CASE("gmsh writes the same mesh in all formats, where it is installed" *
          doctest::skip(std::system("gmsh --version >/dev/null 2>&1") != 0)) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / ("spoke_gmsh_" + std::to_string(std::rand()));
  fs::create_directory(folder);
  for (const std::string geometry : {"bracket", "blade"}) {
    CAPTURE(geometry);
    const auto shipped = solid::read_mesh(
        std::string(SPOKE_MODELS_DIR) + "/meshes/" + geometry + ".msh", 1.0, nullptr);
    for (const std::string form : {"-format msh22", "-format msh41", "-format msh22 -bin",
                                   "-format msh41 -bin", "-format inp"}) {
      CAPTURE(form);
      const std::string file = (folder / (form == "-format inp" ? "m.inp" : "m.msh")).string();
      REQUIRE(std::system(("gmsh " + std::string(SPOKE_MODELS_DIR) + "/meshes/" + geometry +
                           ".msh -save -v 0 " + form + " -o " + file + " >/dev/null")
                              .c_str()) == 0);
      const auto read = solid::read_mesh(file, 1.0, nullptr);
      REQUIRE(read->nodes.size() == shipped->nodes.size());
      REQUIRE(read->elements.size() == shipped->elements.size());
      double far = 0.0;
      for (std::size_t n = 0; n < read->nodes.size(); ++n)
        far = std::max(far, (read->nodes[n] - shipped->nodes[n]).norm());
      CHECK(far < 1e-9);
      int differ = 0;
      for (std::size_t e = 0; e < read->elements.size(); ++e)
        differ += read->elements[e].nodes != shipped->elements[e].nodes;
      CHECK(differ == 0);
      for (const SolidNodeSet& set : shipped->sets) {
        REQUIRE(find_set(*read, set.name) != nullptr);
        CHECK(are_equal(*find_set(*read, set.name), set));
      }
    }
  }
  fs::remove_all(folder);
}
