// Matrices of other programs that cannot be used: one line each, with file and line. Damaged files
// are refused or read, nothing else.

#include <doctest/doctest.h>

#include <filesystem>
#include <functional>
#include <random>
#include <sstream>

#include "models/solid/import.h"
#include "spoke/error.h"
#include "tests/file_text.h"
#include "tests/models/solid/matrix_files.h"
#include "tests/temporary_folder.h"

using namespace spoke;
using spoke::solid::read_matrices;
using spoke::test::AssembledMatrices;
using spoke::test::file_text;
using spoke::test::TemporaryFolder;
using spoke::test::write_text;

namespace {

using Sparse = Eigen::SparseMatrix<double>;

AssembledMatrices make_cube() {
  return test::assemble({.lengths = {0.1, 0.2, 0.3}, .kind = spatial::ElementKind::hex8});
}

/// Replaces the first `old` of a file, which must be there.
void edit(const std::filesystem::path& file, const std::string& old, const std::string& now) {
  std::string text = file_text(file);
  const std::size_t at = text.find(old);
  REQUIRE(at != std::string::npos);
  write_text(file, text.replace(at, old.size(), now));
}

/// Replaces a line, from 1.
void edit_line(const std::filesystem::path& file, int number, const std::string& now) {
  std::istringstream lines(file_text(file));
  std::string text, line;
  for (int k = 1; std::getline(lines, line); ++k) text += (k == number ? now : line) + '\n';
  write_text(file, text);
}

/// Returns the message of what is refused, without the folder; empty: it is read.
std::string message_of(const TemporaryFolder& folder, const spatial::SolidMatrices& files,
                       double length_scale = 1.0) {
  try {
    read_matrices(files, length_scale);
  } catch (const InputError& error) {
    std::string message = error.what();
    CHECK(message.find('\n') == std::string::npos);
    CHECK(!error.place().key.empty());
    const std::string path = folder.path().string() + '/';
    for (std::size_t at = 0; (at = message.find(path)) != std::string::npos;)
      message.erase(at, path.size());
    return message;
  }
  return "";
}

void check_start(const std::string& message, const std::string& expected) {
  CHECK(message.substr(0, expected.size()) == expected);
  CHECK(message.find("expected") != std::string::npos);
}

/// Files of a cube by CalculiX, of which one is changed.
struct Cube {
  TemporaryFolder folder;
  AssembledMatrices matrices = make_cube();
  spatial::SolidMatrices files = test::write_calculix(folder.path(), matrices);

  std::string message(double length_scale = 1.0) const {
    return message_of(folder, files, length_scale);
  }
  std::filesystem::path operator/(const char* name) const { return folder / name; }
  void check(const std::string& expected) const { check_start(message(), expected); }
};

/// Files of a cube in one format of text.
struct TextCube {
  TemporaryFolder folder;
  AssembledMatrices matrices = make_cube();
  spatial::SolidMatrices files;

  TextCube(const char* format,
           const std::function<std::string(const TextCube&, const Sparse&)>& text) {
    write_text(folder / "k.mtx", text(*this, matrices.K));
    write_text(folder / "m.mtx", text(*this, matrices.M));
    write_text(folder / "nodes.txt", test::table_text(matrices.mesh, true));
    files.format = format;
    files.mass = (folder / "m.mtx").string();
    files.stiffness = (folder / "k.mtx").string();
    files.nodes = (folder / "nodes.txt").string();
  }
  std::filesystem::path operator/(const char* name) const { return folder / name; }
  void check(const std::string& expected) const {
    check_start(message_of(folder, files), expected);
  }
};

std::string by_nodes(const TextCube& cube, const Sparse& matrix) {
  return test::abaqus_text(matrix, cube.matrices.mesh);
}
std::string by_rows(const TextCube&, const Sparse& matrix) { return test::coordinate_text(matrix); }
std::string by_market(const TextCube&, const Sparse& matrix) {
  return test::market_text(matrix, false, true);
}

}  // namespace

TEST_CASE("imported matrices refused: description") {
  const auto check = [](const std::function<void(Cube&)>& change, const std::string& expected) {
    Cube cube;
    change(cube);
    cube.check(expected);
  };
  check([](Cube& cube) { cube.files.format = "nastran"; }, "is \"nastran\", expected \"calculix\"");
  check([](Cube& cube) { cube.files.mass = ""; }, "is missing, expected a file");
  check([](Cube& cube) { cube.files.stiffness = ""; }, "is missing, expected a file");
  check([](Cube& cube) { cube.files.nodes = ""; }, "is missing, expected a file of their places");
  check([](Cube& cube) { cube.files.own[2] = "k.sti"; },
        "has 1 files of geometric stiffness, expected nine");
}

TEST_CASE("imported matrices refused: files") {
  const auto check = [](const std::function<void(Cube&)>& change, const std::string& expected) {
    Cube cube;
    change(cube);
    cube.check(expected);
  };
  check([](Cube& cube) { std::filesystem::remove(cube / "bar.mas"); }, "bar.mas: no such file");
  check([](Cube& cube) { std::filesystem::remove(cube / "bar.dof"); },
        "bar.dof: no such file, expected CalculiX's list of coordinates");
  check([](Cube& cube) { write_text(cube / "bar.sti", std::string(100000, 'x')); },
        "bar.sti:1: is a line of more than 4000 characters");
  check([](Cube& cube) { write_text(cube / "bar.sti", std::string("1 1 \0 2\n", 8)); },
        "bar.sti:1: is no text");
  check([](Cube& cube) { write_text(cube / "nodes.txt", "# none\n"); }, "nodes.txt: has no nodes");
  check([](Cube& cube) { cube.files.nodes = (cube / "bar.frd").string(); },
        "bar.frd: results of CalculiX hold six digits");
}

TEST_CASE("imported matrices refused: tables of nodes") {
  const auto check = [](int line, const std::string& now, const std::string& expected) {
    Cube cube;
    edit_line(cube / "nodes.txt", line, now);
    cube.check("nodes.txt" + expected);
  };
  check(3, "13 0.1 0.2", ":3: has 3 fields, expected \"x y z\"");
  check(2, "0 0", ":2: has 2 fields, expected \"x y z\"");
  check(3, "13 0.1 zero 0.2", ":3: \"zero\" is no number");
  check(3, "13 0.1 nan 0.2", ":3: \"nan\" is not finite");
  check(3, "13 0.1 1e999 0.2", ":3: \"1e999\" is not finite");
  check(3, "1.5 0.1 0 0.2", ":3: \"1.5\" is no whole number");
  check(3, "-4 0.1 0 0.2", ":3: the label -4 is out of range");
  check(3, "3000000000 0.1 0 0.2", ":3: the label 3000000000 is out of range");
  check(3, "10 0.1 0 0.2", ": has two nodes of label 10");
}

TEST_CASE("imported matrices refused: CalculiX") {
  const auto check = [](const char* file, int line, const std::string& now,
                        const std::string& expected) {
    Cube cube;
    edit_line(cube / file, line, now);
    cube.check(expected);
  };
  check("bar.dof", 4, "13", "bar.dof:4: \"13\" is no coordinate");
  check("bar.dof", 4, "13.x", "bar.dof:4: \"13.x\" is no coordinate");
  check("bar.dof", 4, "13.1 2", "bar.dof:4: has 2 fields, expected a coordinate");
  check("bar.dof", 4, "13.4", "bar.dof:4: node 13 has the coordinate 4, expected 1, 2 and 3");
  check("bar.dof", 4, "14.1", "bar.dof:4: node 14 is not in nodes.txt, expected all nodes there");
  check("bar.dof", 4, "10.3", "bar.dof:4: the coordinate 10.3 stands in line 3 already");
  check("bar.sti", 2, "1 2", "bar.sti:2: has 2 fields, expected \"row column value\"");
  check("bar.sti", 2, "1 25 7", "bar.sti:2: the entry (1, 25) is outside, expected rows and");
  check("bar.sti", 2, "0 2 7", "bar.sti:2: the entry (0, 2) is outside");
  check("bar.sti", 2, "1 1000000000000 7", "bar.sti:2: the entry (1, 1000000000000) is outside");
  check("bar.sti", 2, "1 2 nan", "bar.sti:2: \"nan\" is not finite");
  check("bar.sti", 2, "1 2 -inf", "bar.sti:2: \"-inf\" is not finite");
  check("bar.sti", 2, "1 2 1.5x", "bar.sti:2: \"1.5x\" is no number");
  check("bar.sti", 2, "1 1 1e9",
        "bar.sti:2: the entry (node 10, x; node 10, x) stands in line 1 already, expected it once");
  check("bar.sti", 4, "2 1 5",
        "bar.sti:2: the entry (node 10, x; node 10, y) and its mirror image are both in the file");
}

TEST_CASE("imported matrices refused: CalculiX, a node that is held") {
  Cube cube;
  edit(cube / "bar.dof", "13.2\n", "");
  cube.check("bar.dof: node 13 lacks its coordinate 2 (y), expected all three: export without");
  // All coordinates of four nodes are held: they are not in the file at all.
  const int held = 4;
  std::string dof, stiffness, mass;
  for (const int label : cube.matrices.mesh.labels)
    if (label >= 10 + 3 * held)
      for (const char* axis : {".1\n", ".2\n", ".3\n"}) dof += std::to_string(label) + axis;
  const int left = static_cast<int>(cube.matrices.K.cols()) - 3 * held;
  write_text(cube / "bar.dof", dof);
  write_text(cube / "bar.sti",
             test::calculix_text(Sparse(cube.matrices.K.bottomRightCorner(left, left))));
  write_text(cube / "bar.mas",
             test::calculix_text(Sparse(cube.matrices.M.bottomRightCorner(left, left))));
  const std::string message = cube.message();
  check_start(message, "bar.sti: rigid shifts make forces of 0.");
  CHECK(message.find("six rigid motions missing, exported with constraints") != std::string::npos);
  CHECK(message.find("(the matrices lack 4 of the nodes of nodes.txt, the first is node 10)") !=
        std::string::npos);
}

TEST_CASE("imported matrices refused: Abaqus") {
  const auto check = [](const auto& text, int line, const std::string& now,
                        const std::string& expected) {
    TextCube cube("abaqus", text);
    edit_line(cube / "k.mtx", line, now);
    cube.check("k.mtx:" + std::to_string(line) + ": " + expected);
  };
  check(by_nodes, 3, "10,1, 13, 1, 2, 5", "has 6 fields, expected 5 in all lines");
  check(by_nodes, 3, "1 2 3.0", "has 3 fields, expected 5 in all lines");
  check(by_nodes, 3, "10,4, 10,1, 2", "node 10 has the coordinate 4, expected 1, 2 and 3");
  check(by_nodes, 3, "10,0, 10,1, 2", "node 10 has the coordinate 0, expected 1, 2 and 3");
  check(by_nodes, 3, "-1,1, 10,1, 2", "node -1 is a coordinate inside an element");
  check(by_nodes, 3, "11,1, 10,1, 2", "node 11 is not in nodes.txt");
  check(by_nodes, 3, "10,1, 10,1, 2",
        "the entry (node 10, x; node 10, x) stands in line 2 already");
  check(by_rows, 2, "25 1 3", "the row or column 25 is outside, expected 1 to 24");
  check(by_rows, 2, "2 1 3", "is not symmetric: the entry (node 10, y; node 10, x) differs");
}

TEST_CASE("imported matrices refused: Matrix Market") {
  const auto check = [](int line, const std::string& now, const std::string& expected) {
    TextCube cube("matrix_market", by_market);
    edit_line(cube / "k.mtx", line, now);
    cube.check("k.mtx" + expected);
  };
  check(1, "24 24 300", ":1: is no header, expected \"%%MatrixMarket matrix\"");
  check(1, "%%MatrixMarket matrix coordinate complex symmetric",
        ":1: has numbers that are \"complex\"");
  check(1, "%%MatrixMarket matrix coordinate real hermitian", ":1: is \"hermitian\"");
  check(1, "%%MatrixMarket matrix coordinate real general",
        ": holds one triangle of the matrix only, expected both");
  check(3, "24 23 300", ":3: the matrix is not square: 24 rows, 23 columns");
  check(3, "27 27 300", ":3: the matrix has 27 rows, expected 24, three for each node of nodes");
  check(3, "24 24", ":3: has 2 fields, expected \"rows columns entries\"");
  check(3, "24 24 1000000000", ":3: announces 1000000000 entries, expected 0 to 576");
  check(3, "24 24 576", ": ends after ");
  check(3, "24 24 3", ":7: is one entry too many, expected 3, as line 3 announces");
  check(6, "1 2 3.0",
        ":6: the entry (node 10, x; node 10, y) and its mirror image are both in the");
  TextCube cube("matrix_market", [](const TextCube&, const Sparse& matrix) {
    return test::market_text(matrix, true, true);
  });
  edit_line(cube / "m.mtx", 7, "1 2");
  cube.check("m.mtx:7: has 2 fields, expected one number");
}

TEST_CASE("imported matrices refused: what no body has") {
  const auto check = [](const std::function<void(Cube&, Sparse & K, Sparse & M)>& change,
                        const std::string& expected) {
    Cube cube;
    change(cube, cube.matrices.K, cube.matrices.M);
    write_text(cube / "bar.sti", test::calculix_text(cube.matrices.K));
    write_text(cube / "bar.mas", test::calculix_text(cube.matrices.M));
    cube.check(expected);
  };
  // One of three directions lacks a little mass, as rotational coordinates and lumping leave it.
  check([](Cube&, Sparse&, Sparse& M) { M.coeffRef(4, 4) *= 1.0 + 1e-9; },
        "bar.mas: is not of the structure m (x) 1_3, equal in three directions and without "
        "coupling of these: the entry (node 13, y; node 13, y) is off by 1");
  check([](Cube&, Sparse&, Sparse& M) { M.coeffRef(1, 0) = M.coeffRef(0, 1) = 0.01; },
        "bar.mas: is not of the structure m (x) 1_3, equal in three directions and without "
        "coupling of these: the entry (node 10, y; node 10, x) is off by");
  check(
      [](Cube& cube, Sparse&, Sparse& M) {
        // One point of quadrature: of rank 1.
        const Eigen::Index n = cube.matrices.m.cols();
        M = test::spread(Sparse(Eigen::MatrixXd::Constant(n, n, 0.25).sparseView()));
      },
      "bar.mas: the mass matrix is singular or not positive definite");
  check([](Cube&, Sparse&, Sparse& M) { M = -M; }, "bar.mas: the mass of node 10 is -");
  check([](Cube&, Sparse&, Sparse& M) { M *= 1e-9; }, "bar.mas: a mass of ");
  check([](Cube&, Sparse&, Sparse& M) { M *= 1e4; }, "bar.mas: a mass of ");
  check([](Cube&, Sparse& K, Sparse&) { K.coeffRef(3, 3) *= 1.0 + 1e-6; },
        "bar.sti: rigid shifts make forces of ");
  check([](Cube&, Sparse& K, Sparse&) { K *= 0.0; }, "bar.sti: has no entries but 0");
  check(
      [](Cube& cube, Sparse&, Sparse&) {
        std::swap(cube.matrices.mesh.nodes[0], cube.matrices.mesh.nodes[1]);
        write_text(cube / "nodes.txt", test::table_text(cube.matrices.mesh, true));
      },
      "bar.sti: rigid rotations make forces of ");
}

TEST_CASE("imported matrices refused: masses of another model") {
  TextCube cube("abaqus", by_nodes);
  std::istringstream lines(file_text(cube / "m.mtx"));
  std::string mass;
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with("31,")) mass += line + '\n';
  write_text(cube / "m.mtx", mass);
  cube.check("m.mtx: the mass of node 31 is 0, expected a positive one");
}

TEST_CASE("imported matrices refused: stresses that are not there") {
  spatial::SolidBody body;
  Cube whole;
  CHECK_THROWS_WITH_AS(
      solid::make_geometry_of_matrices(body, read_matrices(whole.files, 1.0)),
      "needs the stresses, which matrices of other programs do not hold, expected false, files of "
      "geometric stiffness matrices, or the mesh in place of the matrices",
      InputError);
  for (std::string& file : whole.files.own) file = whole.files.mass;
  for (std::string& file : whole.files.translation) file = whole.files.mass;
  const auto box = spatial::BoxNodes{{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}};
  body.interfaces = {{.name = "root", .nodes = box}};
  CHECK_NOTHROW(solid::make_geometry_of_matrices(body, read_matrices(whole.files, 1.0)));
  body.interfaces.push_back({.name = "tip", .nodes = box});
  CHECK_THROWS_WITH_AS(
      solid::make_geometry_of_matrices(body, read_matrices(whole.files, 1.0)),
      "needs the stresses under wrenches on \"tip\", which the files do not hold, expected false, "
      "one interface, or the mesh in place of the matrices",
      InputError);
}

TEST_CASE("imported matrices: damaged files are read or refused in one line") {
  std::mt19937 random(5);
  const auto any = [&](std::size_t below) { return random() % below; };
  const auto damage = [&](std::string text) {
    for (std::size_t k = any(3) + 1; k > 0 && !text.empty(); --k) {
      const std::size_t at = any(text.size());
      switch (any(5)) {
        case 0:
          text[at] = static_cast<char>(any(256));
          break;
        case 1:
          text.erase(at, any(40));
          break;
        case 2:
          text.insert(at, text.substr(any(text.size()), any(40)));
          break;
        case 3:
          text.insert(at, 1, "0123456789.,-+eE \n%*"[any(20)]);
          break;
        default:
          text.resize(at);
          break;
      }
    }
    return text;
  };
  const auto check = [&](const TemporaryFolder& folder, const spatial::SolidMatrices& files,
                         const char* name) {
    const std::string whole = file_text(folder / name);
    for (int k = 0; k < 60; ++k) {
      write_text(folder / name, damage(whole));
      message_of(folder, files);
    }
    write_text(folder / name, whole);
  };
  {
    const Cube cube;
    for (const char* name : {"bar.sti", "bar.mas", "bar.dof", "nodes.txt"})
      check(cube.folder, cube.files, name);
  }
  using Format = std::pair<const char*, std::string (*)(const TextCube&, const Sparse&)>;
  for (const auto& [format, text] :
       {Format{"abaqus", by_nodes}, {"abaqus", by_rows}, {"matrix_market", by_market}}) {
    const TextCube cube(format, text);
    for (const char* name : {"k.mtx", "m.mtx", "nodes.txt"}) check(cube.folder, cube.files, name);
  }
}
