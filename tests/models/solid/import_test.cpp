// Matrices of other programs: what was written is read back, in every format.

#include "models/solid/import.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>

#include "tests/approx.h"
#include "tests/models/solid/matrix_files.h"
#include "tests/temporary_folder.h"

using namespace spoke;
using spoke::solid::ImportedMatrices;
using spoke::solid::read_matrices;
using spoke::test::AssembledMatrices;
using spoke::test::TemporaryFolder;
using spoke::test::write_text;
using spoke::testing::approx;

namespace {

using Sparse = Eigen::SparseMatrix<double>;

AssembledMatrices make_bar(spatial::ElementKind kind = spatial::ElementKind::hex20) {
  return test::assemble({.cells = {2, 1, 1}, .lengths = {0.4, 0.1, 0.08}, .kind = kind});
}

double difference(const Sparse& a, const Sparse& b) {
  return Eigen::MatrixXd(a - b).cwiseAbs().maxCoeff() / Eigen::MatrixXd(b).cwiseAbs().maxCoeff();
}

void check_equal(const ImportedMatrices& read, const AssembledMatrices& written) {
  REQUIRE(read.nodes.size() == written.mesh.nodes.size());
  for (std::size_t k = 0; k < read.nodes.size(); ++k)
    CHECK((read.nodes[k] - written.mesh.nodes[k]).norm() == 0.0);
  CHECK(difference(read.m, written.m) == 0.0);
  CHECK(difference(read.K, written.K) == 0.0);
}

/// Writes K and M by `text` and returns what reads them.
template <class Text>
spatial::SolidMatrices write(const TemporaryFolder& folder, const char* format,
                             const AssembledMatrices& bar, bool has_labels, const Text& text) {
  write_text(folder / "k.mtx", text(bar.K));
  write_text(folder / "m.mtx", text(bar.M));
  write_text(folder / "nodes.txt", test::table_text(bar.mesh, has_labels));
  spatial::SolidMatrices files;
  files.format = format;
  files.mass = (folder / "m.mtx").string();
  files.stiffness = (folder / "k.mtx").string();
  files.nodes = (folder / "nodes.txt").string();
  return files;
}

}  // namespace

TEST_CASE("imported matrices: of CalculiX's files") {
  const TemporaryFolder folder;
  const AssembledMatrices bar = make_bar();
  const ImportedMatrices read = read_matrices(test::write_calculix(folder.path(), bar), 1.0);
  check_equal(read, bar);
  CHECK(read.labels == bar.mesh.labels);
  CHECK(!read.has_stresses());
}

TEST_CASE("imported matrices: of CalculiX, coordinates in another order, nodes left over") {
  const TemporaryFolder folder;
  AssembledMatrices bar = make_bar(spatial::ElementKind::hex8);
  spatial::SolidMatrices files = test::write_calculix(folder.path(), bar);
  const int size = static_cast<int>(bar.K.cols());
  // Row k of the file is coordinate size - 1 - k.
  Eigen::PermutationMatrix<Eigen::Dynamic> turned(size);
  for (int k = 0; k < size; ++k) turned.indices()[k] = size - 1 - k;
  write_text(folder / "bar.sti", test::calculix_text(Sparse(turned * bar.K * turned.transpose())));
  write_text(folder / "bar.mas", test::calculix_text(Sparse(turned * bar.M * turned.transpose())));
  std::string dof;
  for (int k = size - 1; k >= 0; --k)
    dof += std::to_string(bar.mesh.labels[static_cast<std::size_t>(k / 3)]) + '.' +
           std::to_string(k % 3 + 1) + '\n';
  write_text(folder / "bar.dof", dof);
  write_text(folder / "nodes.txt",
             "7 9 9 9\n" + test::table_text(bar.mesh, true) + "1000 8, 8, 8\n");
  check_equal(read_matrices(files, 1.0), bar);
}

TEST_CASE("imported matrices: of Abaqus, by nodes and by rows") {
  const TemporaryFolder folder;
  AssembledMatrices bar = make_bar(spatial::ElementKind::tet10);
  const auto by_nodes = [&](const Sparse& matrix) { return test::abaqus_text(matrix, bar.mesh); };
  check_equal(read_matrices(write(folder, "abaqus", bar, true, by_nodes), 1.0), bar);
  check_equal(read_matrices(write(folder, "abaqus", bar, true, test::coordinate_text), 1.0), bar);
  check_equal(read_matrices(write(folder, "abaqus", bar, false, test::coordinate_text), 1.0), bar);
}

TEST_CASE("imported matrices: of Abaqus, rows follow the labels of the nodes") {
  const TemporaryFolder folder;
  const AssembledMatrices bar = make_bar(spatial::ElementKind::hex8);
  const spatial::SolidMatrices files = write(folder, "abaqus", bar, true, test::coordinate_text);
  std::string backwards;
  for (std::size_t k = bar.mesh.nodes.size(); k-- > 0;) {
    spatial::SolidMesh one;
    one.nodes = {bar.mesh.nodes[k]};
    one.labels = {bar.mesh.labels[k]};
    backwards += test::table_text(one, true);
  }
  write_text(folder / "nodes.txt", backwards);
  const ImportedMatrices read = read_matrices(files, 1.0);
  const auto last = static_cast<Eigen::Index>(read.labels.size()) - 1;
  CHECK(read.labels.front() == bar.mesh.labels.back());
  CHECK(read.m.coeff(0, 1) == bar.m.coeff(last, last - 1));
  CHECK(read.K.coeff(0, 4) == bar.K.coeff(3 * last, 3 * (last - 1) + 1));
}

TEST_CASE("imported matrices: of Matrix Market, in each of its forms") {
  const TemporaryFolder folder;
  const AssembledMatrices bar = make_bar(spatial::ElementKind::hex8);
  for (const bool is_array : {false, true}) {
    for (const bool is_symmetric : {false, true}) {
      const auto text = [&](const Sparse& matrix) {
        return test::market_text(matrix, is_array, is_symmetric);
      };
      check_equal(read_matrices(write(folder, "matrix_market", bar, is_array, text), 1.0), bar);
    }
  }
}

TEST_CASE("imported matrices: by hand, two lumps of Abaqus") {
  // Four masses of 2 kg at the corners of a tetrahedron with springs of 1000 N/m along its edges.
  const TemporaryFolder folder;
  const std::array<Eigen::Vector3d, 4> x = {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0),
                                            Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, 0, 1)};
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(12, 12);
  for (int a = 0; a < 4; ++a) {
    for (int b = 0; b < a; ++b) {
      const Eigen::Vector3d n =
          (x[static_cast<std::size_t>(a)] - x[static_cast<std::size_t>(b)]).normalized();
      const Eigen::Matrix3d k = 1000.0 * n * n.transpose();
      K.block<3, 3>(3 * a, 3 * a) += k;
      K.block<3, 3>(3 * b, 3 * b) += k;
      K.block<3, 3>(3 * a, 3 * b) -= k;
      K.block<3, 3>(3 * b, 3 * a) -= k;
    }
  }
  std::string mass, stiffness;
  for (int i = 0; i < 12; ++i) {
    const std::string row = std::to_string(i / 3 + 1) + "," + std::to_string(i % 3 + 1) + ", ";
    mass += row + row + "2.D0\n";
    for (int j = 0; j <= i; ++j)
      if (K(i, j) != 0.0)
        stiffness += row + std::to_string(j / 3 + 1) + "," + std::to_string(j % 3 + 1) + ", " +
                     std::to_string(K(i, j)) + "0000000000\n";
  }
  write_text(folder / "k.mtx", stiffness);
  write_text(folder / "m.mtx", mass);
  write_text(folder / "nodes.txt", "1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n");
  spatial::SolidMatrices files;
  files.format = "abaqus";
  files.mass = (folder / "m.mtx").string();
  files.stiffness = (folder / "k.mtx").string();
  files.nodes = (folder / "nodes.txt").string();
  const ImportedMatrices read = read_matrices(files, 1.0);
  CHECK(difference(read.K, K.sparseView()) < 1e-9);
  spatial::SolidBody body;
  body.geometric_stiffening = false;
  body.interfaces = {{.name = "root", .nodes = spatial::BoxNodes{{-0.1, -0.1, -0.1}, {2, 2, 0.1}}}};
  const solid::SolidGeometry geometry = solid::make_geometry_of_matrices(body, read);
  CHECK(geometry.mass == doctest::Approx(8.0));
  // The mean of the three corners at z = 0 is (1/3, 1/3, 0).
  CHECK(geometry.interfaces.at(0).nodes == std::vector<int>{0, 1, 2});
  CHECK((geometry.first_moment - spatial::Vector(2.0 - 8.0 / 3.0, 2.0 - 8.0 / 3.0, 2.0)).norm() <
        1e-12);
  // int x^2 dm about it: 2 ((2/3)^2 + 3 (1/3)^2) = 14/9; int z^2 dm = 2.
  CHECK(geometry.second_moment(0, 0) == doctest::Approx(14.0 / 9.0));
  CHECK(geometry.second_moment(2, 2) == doctest::Approx(2.0));
}

TEST_CASE("imported matrices: a body is made of files, its interfaces of sets of the .inp file") {
  const TemporaryFolder folder;
  const AssembledMatrices bar = make_bar();
  spatial::SolidBody body;
  body.matrices = test::write_calculix(folder.path(), bar);
  body.matrices->nodes = (folder / "bar.inp").string();
  body.geometric_stiffening = false;
  body.interfaces = {{.name = "root", .nodes = "X0"},
                     {.name = "tip", .nodes = spatial::PlaneNodes{{0.4, 0, 0}, {2, 0, 0}, 1e-6}}};
  std::string inp = test::inp_text(bar.mesh, "");
  // Elements of types that no mesh may have are passed over; a point of reference is left out.
  for (const std::string type : {"C3D20", "C3D20R", "U42"}) {
    std::string text = inp;
    text.replace(text.find("C3D20"), 5, type);
    write_text(folder / "bar.inp", "*NODE, NSET=X0\n5, 1, 1, 1\n" + text);
    const solid::SolidGeometry geometry = solid::make_geometry(body);
    // 2700 kg/m^3 x 0.4 x 0.1 x 0.08 m^3, moments about the middle of the face at x = 0.
    CHECK(geometry.mass == doctest::Approx(8.64));
    CHECK((geometry.first_moment - spatial::Vector(8.64 * 0.2, 0, 0)).norm() < 1e-12);
    CHECK(geometry.second_moment(0, 0) == approx(8.64 * 0.16 / 3.0));
    CHECK(geometry.second_moment(1, 1) == approx(8.64 * 0.01 / 12.0));
    REQUIRE(geometry.interfaces.size() == 2);
    CHECK(geometry.interfaces[0].nodes == bar.mesh.sets.at(0).nodes);
    CHECK(geometry.interfaces[1].nodes == bar.mesh.sets.at(1).nodes);
    CHECK((geometry.interfaces[0].point - spatial::Vector(0, 0.05, 0.04)).norm() < 1e-12);
    CHECK((geometry.interfaces[1].point - spatial::Vector(0.4, 0.05, 0.04)).norm() < 1e-12);
  }
  write_text(folder / "bar.inp",
             inp.substr(0, inp.find("*ELEMENT")) + inp.substr(inp.find("*NSET")));
  CHECK(solid::make_geometry(body).mass == doctest::Approx(8.64));
}

TEST_CASE("imported matrices: files in mm, N and t are those in SI units") {
  const TemporaryFolder folder;
  const AssembledMatrices bar = make_bar(spatial::ElementKind::hex8);
  AssembledMatrices in_mm = bar;
  for (spatial::Vector& x : in_mm.mesh.nodes) x *= 1000.0;
  in_mm.M /= 1000.0;  // t
  in_mm.K /= 1000.0;  // N/mm
  const ImportedMatrices read = read_matrices(test::write_calculix(folder.path(), in_mm), 1e-3);
  CHECK(difference(read.m, bar.m) < 1e-14);
  CHECK(difference(read.K, bar.K) < 1e-14);
  CHECK((read.nodes.back() - bar.mesh.nodes.back()).norm() < 1e-15);
}

TEST_CASE("imported matrices: geometric stiffness") {
  const TemporaryFolder folder;
  AssembledMatrices bar = make_bar(spatial::ElementKind::hex8);
  const AssembledMatrices whole = bar;
  // Lumped masses: the stresses have entries where the mass has none.
  const Eigen::VectorXd lumps = bar.m * Eigen::VectorXd::Ones(bar.m.cols());
  bar.m = Eigen::MatrixXd(lumps.asDiagonal()).sparseView();
  bar.M = test::spread(bar.m);
  spatial::SolidMatrices files = test::write_calculix(folder.path(), bar);
  // Any symmetric scalar matrix does; a matrix of zeros, too.
  const auto scalar = [&](std::size_t k) { return Sparse(static_cast<double>(k) * whole.m); };
  for (std::size_t k = 0; k < 9; ++k) {
    const std::string name = "kg" + std::to_string(k) + ".sti";
    write_text(folder.path() / name, test::calculix_text(test::spread(scalar(k))));
    (k < 6 ? files.own[k] : files.translation[k - 6]) = (folder.path() / name).string();
  }
  for (const double scale : {1.0, 0.5}) {
    const ImportedMatrices read = read_matrices(files, scale);
    CHECK(read.has_stresses());
    CHECK(read.m.nonZeros() == whole.m.nonZeros());
    CHECK(difference(read.m, bar.m / scale) < 1e-15);
    for (std::size_t k = 0; k < 9; ++k) {
      // w^2 kg is a stiffness, N by length; kg by acceleration is divided by length twice.
      const Sparse& kg = k < 6 ? read.own[k] : read.translation[k - 6];
      const Eigen::MatrixXd expected(scalar(k) / (k < 6 ? scale : scale * scale));
      CHECK((Eigen::MatrixXd(kg) - expected).norm() <= 1e-15 * expected.norm());
      Sparse in_places = read.m;
      const Eigen::VectorXd values = solid::values_in_places_of(read.m, kg);
      std::copy(values.begin(), values.end(), in_places.valuePtr());
      CHECK(Eigen::MatrixXd(in_places) == Eigen::MatrixXd(kg));
    }
  }
}
