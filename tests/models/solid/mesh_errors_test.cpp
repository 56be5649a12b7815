// Meshes that cannot be used: one located line each.

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "models/error.h"
#include "models/solid/mesh_check.h"
#include "models/solid/parse_mesh.h"
#include "models/solid/solid.h"
#include "tests/message_of.h"
#include "tests/models/exchange.h"

using namespace spoke;
using namespace spoke::test;

namespace {

/// A change of a text, and the message that it gives.
struct Case {
  std::string from, to, message;
};

/// Checks what reading a text says, and that file and line are those of the message.
void check_text(const std::string& text, const std::string& file, const std::string& expected) {
  try {
    solid::check_mesh(*solid::parse_mesh(text, file, 1.0));
    FAIL_CHECK("no error, expected " << expected);
  } catch (const InputError& error) {
    const std::string message = error.what();
    CHECK(message == expected);
    CHECK(error.place().file == file);
    const std::string start = error.place().line > 0
                                  ? file + ':' + std::to_string(error.place().line) + ": "
                                  : file + ": ";
    CHECK(message.starts_with(start));
    CHECK(message.find('\n') == std::string::npos);
  }
}

void check_cases(const std::string& text, const std::string& file, const std::vector<Case>& cases) {
  for (const Case& bad : cases) {
    CAPTURE(bad.to);
    check_text(exchange(text, bad.from, bad.to), file, file + bad.message);
  }
}

// Two tetrahedra at the triangle 1 2 3, and lines 5 to 11.
const std::string kInp =
    "*NODE\n1, 0., 0., 0.\n2, 1., 0., 0.\n3, 0., 1., 0.\n4, 0., 0., 1.\n5, 0., 0., -1.\n"
    "*ELEMENT, TYPE=C3D4, ELSET=ALL\n1, 1, 2, 3, 4\n2, 1, 3, 2, 5\n"
    "*NSET, NSET=ROOT\n1, 2, 3\n*SURFACE, NAME=TOP\n1, S2\n"
    "*MATERIAL, NAME=M\n*ELASTIC\n1.e9, 0.3\n*DENSITY\n1000.\n";
const std::string kMsh22 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 1 \"ROOT\"\n$EndPhysicalNames\n"
    "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n"
    "$Elements\n2\n1 2 2 1 1 1 2 3\n2 4 2 2 1 1 2 3 4\n$EndElements\n";
const std::string kMsh41 =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
    "$Entities\n0 0 0 1\n1 0 0 0 1 1 1 1 7 0\n$EndEntities\n"
    "$Nodes\n1 4 1 4\n3 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n$EndNodes\n"
    "$Elements\n1 1 1 1\n3 1 4 1\n1 1 2 3 4\n$EndElements\n";

}  // namespace

TEST_CASE("the texts that are made wrong are right") {
  for (const std::string& text : {kInp, kMsh22, kMsh41})
    CHECK(message_of([&] { solid::check_mesh(*solid::parse_mesh(text, "m", 1.0)); }) == "no error");
}

TEST_CASE("bad .inp files are refused at their line") {
  check_cases(
      kInp, "m.inp",
      {{"*NODE", "NODE",
        ":1: begins with \"NODE?1, 0., \", expected a mesh: $MeshFormat (gmsh .msh) or *NODE "
        "(Abaqus .inp)"},
       {"*NODE\n", "*HEADING\n",
        ":11: names node 1, which the file does not have, expected the number of one"},
       {"3, 0., 1., 0.", "3, 0., one, 0.",
        ":4: is \"one\", expected a node's coordinate, a finite number"},
       {"3, 0., 1., 0.", "3, 0., nan, 0.",
        ":4: is \"nan\", expected a node's coordinate, a finite number"},
       {"3, 0., 1., 0.", "3, 0., 1e999, 0.",
        ":4: is \"1e999\", expected a node's coordinate, a finite number"},
       {"3, 0., 1., 0.", "-3, 0., 1., 0.",
        ":4: is \"-3\", expected a node's number, an integer of 1 or more"},
       {"3, 0., 1., 0.", "3", ":4: has 1 item, expected a node's number, x, y, z"},
       {"3, 0., 1., 0.", "2, 0., 1., 0.",
        ":4: node 2 is there a second time, expected each number once"},
       {"3, 0., 1., 0.", "99999999999, 0., 1., 0.",
        ":4: is \"99999999999\", expected a node's number, an integer of 1 or more"},
       {"*NODE", "*NODE, SYSTEM=C", ":1: has nodes in a system of its own, expected x, y and z"},
       {"*NODE", "*INCLUDE, INPUT=nodes.inp\n*NODE",
        ":1: includes another file, expected its text in this place"},
       {"*NODE", "*PART, NAME=A\n*END PART\n*PART, NAME=B\n*NODE",
        ":3: is a second part, expected one"},
       {"*NSET", "*INSTANCE, NAME=I, PART=A\n1., 0., 0.\n*END INSTANCE\n*NSET",
        ":11: moves the instance, expected one where its part is"},
       {"*NSET", "*INSTANCE, NAME=I\n*END INSTANCE\n*INSTANCE, NAME=J\n*NSET",
        ":12: is a second instance of a part, expected one"},
       {"*NSET", "*NGEN\n*NSET",
        ":10: *NGEN is not supported, expected nodes and elements one by one"},
       {"TYPE=C3D4", "TYPE=C3D6",
        ":7: has elements of type \"C3D6\", expected C3D4, C3D10, C3D8 or C3D20, or faces (CPS3, "
        "CPS6, CPS4, CPS8)"},
       {"TYPE=C3D4", "TYPE=C3D27",
        ":7: has elements of type \"C3D27\", expected C3D4, C3D10, C3D8 or C3D20, or faces (CPS3, "
        "CPS6, CPS4, CPS8)"},
       {"TYPE=C3D4", "TYPE=WHAT",
        ":7: has elements of type \"WHAT\", expected C3D4, C3D10, C3D8 or C3D20, or faces (CPS3, "
        "CPS6, CPS4, CPS8)"},
       {"TYPE=C3D4, ", "", ":7: *ELEMENT has no TYPE, expected TYPE = ..."},
       {"TYPE=C3D4", "TYPE=C3D10",
        ":8: element 1 of type \"C3D10\" has 4 nodes, expected 10 (lines that go on end in a "
        "comma)"},
       {"TYPE=C3D4", "TYPE=C3D20R",
        ":8: element 1 of type \"C3D20R\" has 4 nodes, expected 20 (lines that go on end in a "
        "comma)"},
       {"1, 1, 2, 3, 4", "1, 1, 2, 3",
        ":8: element 1 of type \"C3D4\" has 3 nodes, expected 4 (lines that go on end in a comma)"},
       {"1, 1, 2, 3, 4", "1, 1, 2, 3,",
        ":8: element 1 of type \"C3D4\" has 8 nodes, expected 4 (lines that go on end in a comma)"},
       {"1, 1, 2, 3, 4", "1, 1, 2, 3, 4, 5",
        ":8: element 1 of type \"C3D4\" has 5 nodes, expected 4 (lines that go on end in a comma)"},
       {"1, 1, 2, 3, 4", "1, 1, 2, 3, 77",
        ":8: an element names node 77, which the file does not have, expected the number of a "
        "node"},
       {"1, 1, 2, 3, 4", "1, 1, 2, 3, 3",
        ":8: the tet4 (volume element 1) has node 3 twice, expected different nodes"},
       {"1, 1, 2, 3, 4", "1, 2, 1, 3, 4",
        ":8: the tet4 (volume element 1) is inverted at node 2, expected a positive volume "
        "everywhere in it and nodes in the order of the format"},
       {"1, 1, 2, 3, 4", "2, 1, 2, 3, 4",
        ":9: element 2 is there a second time, expected each number once"},
       {"1, 2, 3\n", "1, 2, 33\n",
        ":11: names node 33, which the file does not have, expected the number of one"},
       {"1, 2, 3\n", "1, ELSEWHERE\n",
        ":11: is \"ELSEWHERE\", expected a number or the name of an earlier set"},
       {"*NSET, NSET=ROOT\n1, 2, 3", "*NSET, NSET=ROOT, GENERATE\n3, 1",
        ":11: has its last number before its first, expected it after"},
       {"*NSET, NSET=ROOT\n1, 2, 3", "*NSET, NSET=ROOT, GENERATE\n1",
        ":11: has 1 item, expected the first number, the last and the step"},
       {"*NSET, NSET=ROOT", "*NSET", ":10: *NSET has no NSET, expected NSET = ..."},
       {"1, S2", "1, S5", ":13: names no face of element 1, expected S1 to S4"},
       {"1, S2", "1, SX", ":13: is of face \"SX\", expected S1 to S6"},
       {"1, S2", "1", ":13: names no face of element 1, expected S1 to S4"},
       {"1, S2", "9, S2",
        ":13: names element 9, which the file does not have, expected the number of one"},
       {"1, S2", "NONE, S2", ":13: is \"NONE\", expected a number or the name of a set"},
       {"*MATERIAL, NAME=M\n", "",
        ":14: *ELASTIC belongs to no material, expected *MATERIAL before it"},
       {"1.e9, 0.3", "1.e9", ":16: has 1 item, expected Young's modulus and Poisson's ratio"},
       {"*DENSITY\n1000.\n", "*DENSITY\n", ":17: has no density, expected one"},
       {"4, 0., 0., 1.", "4, 0.3, 0.3, 0.",
        ":8: the tet4 (volume element 1) is degenerate at node 1, expected a positive volume "
        "everywhere in it"},
       {"4, 0., 0., 1.", "4, 0., 0., 1.e5",
        ": extends over 100001 m, expected at most 10000 m (of a file in mm: scale = { length = "
        "1e-3 })"},
       {"4, 0., 0., 1.", "4, 0., 0., -0.5",
        ":8: the tet4 (volume element 1) is inverted at node 1, expected a positive volume "
        "everywhere in it and nodes in the order of the format"}});
}

TEST_CASE("bad .msh files of format 2.2 are refused at their line") {
  check_cases(
      kMsh22, "m.msh",
      {{"2.2 0 8", "1.0 0 8",
        ":2: is of gmsh's format 1.0, expected 2.2 or 4.1 (gmsh -format msh41)"},
       {"2.2 0 8", "4 0 8",
        ":2: is of gmsh's format 4.0, expected 2.2 or 4.1 (gmsh -format msh41)"},
       {"2.2 0 8", "2.2 0 4", ":2: is \"4\", expected the size of a number in bytes, 8"},
       {"2.2 0 8", "2.2 1 8",
        ":3: is binary, of an order of bytes that is not known, expected the integer 1"},
       {"$MeshFormat", "$Nodes",
        ":1: does not begin with $MeshFormat, expected a mesh of gmsh (.msh)"},
       {"$EndMeshFormat\n", "", ":3: is \"$PhysicalNames\", expected $EndMeshFormat"},
       {"2 1 \"ROOT\"", "2 1 ROOT", ":6: has no name in quotes, expected that of a physical group"},
       {"2 1 \"ROOT\"", "2 1 \"ROOT", ":6: has a name that does not end, expected a quote"},
       {"2 1 \"ROOT\"", "4 1 \"ROOT\"",
        ":6: is \"4\", expected a dimension, an integer from 0 to 3"},
       {"$Nodes\n4", "$Nodes\n1000000000",
        ":9: announces 1000000000 nodes, expected at most 13 in the rest of the file"},
       {"$Nodes\n4", "$Nodes\n5",
        ":14: is \"$EndNodes\", expected a node's number, an integer of 1 or more"},
       {"$Nodes\n4", "$Nodes\n-4",
        ":9: is \"-4\", expected the number of nodes, an integer of 0 or more"},
       {"$Nodes\n4", "$Nodes\n3", ":13: is \"4\", expected $EndNodes"},
       {"2 1 0 0\n", "2 1 0\n", ":11: node 2 is not all of one line, expected three coordinates"},
       {"2 1 0 0\n", "2 1 0 inf\n",
        ":11: is \"inf\", expected a node's coordinate, a finite number"},
       {"2 1 0 0\n", "1 1 0 0\n", ":11: node 1 is there a second time, expected each number once"},
       {"$Elements\n2", "$Elements\n1000000000",
        ":16: announces 1000000000 elements, expected at most 7 in the rest of the file"},
       {"2 4 2 2 1 1 2 3 4", "2 6 2 2 1 1 2 3 4 5 6",
        ":18: has a prism of 6 nodes, expected tetrahedra of 4 or 10 nodes, hexahedra of 8 or 20, "
        "and faces, lines and points"},
       {"2 4 2 2 1 1 2 3 4", "2 12 2 2 1 1 2 3 4",
        ":18: has a hexahedron of 27 nodes, expected tetrahedra of 4 or 10 nodes, hexahedra of 8 "
        "or 20, and faces, lines and points"},
       {"2 4 2 2 1 1 2 3 4", "2 140 2 2 1 1 2 3 4",
        ":18: has an element of type 140, expected tetrahedra of 4 or 10 nodes, hexahedra of 8 or "
        "20, and faces, lines and points"},
       {"2 4 2 2 1 1 2 3 4", "2 4 2 2 1 1 2 3",
        ":19: is \"$EndElements\", expected a node's number, an integer of 1 or more"},
       {"2 4 2 2 1 1 2 3 4", "2 4 2 2 1 1 2 3 4 4",
        ":18: element 2, a tetrahedron of 4 nodes, is not all of one line, expected its nodes in "
        "this line"},
       {"2 4 2 2 1 1 2 3 4", "2 4 2 2 1 1 2 3 9",
        ":18: an element names node 9, which the file does not have, expected the number of a "
        "node"},
       {"2 4 2 2 1 1 2 3 4", "2 4 2 2 1 1 3 2 4",
        ":18: the tet4 (volume element 1) is inverted at node 1, expected a positive volume "
        "everywhere in it and nodes in the order of the format"},
       {"2 4 2 2 1 1 2 3 4\n", "",
        ":18: is \"$EndElements\", expected an element's number, an integer of 1 or more"},
       {"2 4 2 2 1 1 2 3 4\n$EndElements\n", "",
        ":18: the file ends here, expected an element's number"},
       {"\n$EndElements", "", ":19: the file ends here, expected $EndElements"},
       {"1 2 2 1 1 1 2 3", "1 2 2 1 1 1 2 8",
        ":17: an element names node 8, which the file does not have, expected the number of a "
        "node"},
       {"$Elements\n2\n", "$Elements\n1\n", ":18: is \"2\", expected $EndElements"}});
}

TEST_CASE("bad .msh files of format 4.1 are refused at their line") {
  check_cases(
      kMsh41, "m.msh",
      {{"$Entities\n0 0 0 1", "$Entities\n0 0 1000000000 1",
        ":5: announces 1000000000 entities, expected at most 16 in the rest of the file"},
       {"$EndEntities", "$EndEntity", ":7: is \"$EndEntity\", expected $EndEntities"},
       {"$Entities", "$PartitionedEntities",
        ":4: the mesh is partitioned, expected one in one piece"},
       {"$Entities", "$Rubbish", ":4: \"$Rubbish\" does not end, expected $EndRubbish"},
       {"1 4 1 4\n", "1 1000000000 1 4\n",
        ":9: announces 1000000000 nodes, expected at most 14 in the rest of the file"},
       {"3 1 0 4\n", "3 1 0 400\n",
        ":10: announces 400 nodes, expected at most 12 in the rest of the file"},
       {"3 1 0 4\n", "3 1 2 4\n",
        ":10: is \"2\", expected 0 or 1 (parametric), an integer from 0 to 1"},
       {"0 1 0\n0 0 1", "0 1\n0 0 1",
        ":18: node 3 is not all of one line, expected three coordinates"},
       {"3 1 4 1\n", "3 1 4 1000000000\n",
        ":22: announces 1000000000 elements, expected at most 7 in the rest of the file"},
       {"3 1 4 1\n", "3 1 14 1\n",
        ":22: has a pyramid of 14 nodes, expected tetrahedra of 4 or 10 nodes, hexahedra of 8 or "
        "20, and faces, lines and points"},
       {"1 1 2 3 4\n", "1 1 2 3\n",
        ":24: is \"$EndElements\", expected a node's number, an integer of 1 or more"},
       {"1 1 2 3 4\n", "1 1 2 3 18446744073709551616\n",
        ":23: is \"18446744073709551616\", expected a node's number, an integer of 1 or more"}});
}

TEST_CASE("a file that is no mesh is refused") {
  check_text(
      "\x7f"
      "ELF\x02\x01\x01",
      "m.msh",
      "m.msh:1: begins with \"?ELF???\", expected a mesh: $MeshFormat (gmsh .msh) or *NODE "
      "(Abaqus .inp)");
  namespace fs = std::filesystem;
  const std::string file = (fs::temp_directory_path() / "spoke_no_mesh.msh").string();
  fs::remove(file);
  CHECK(message_of([&] { solid::read_mesh(file, 1.0, nullptr); }) ==
        file + ": no such file, expected a mesh (gmsh .msh or Abaqus .inp)");
  std::ofstream(file).close();
  CHECK(message_of([&] { solid::read_mesh(file, 1.0, nullptr); }) ==
        file + ": is empty, expected a mesh (gmsh .msh or Abaqus .inp)");
  fs::remove(file);
}
