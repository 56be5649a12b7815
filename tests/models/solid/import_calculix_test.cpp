// Matrices that CalculiX writes, where it is installed: its stiffness is our own, and its
// frequencies are those of the matrices. Skipped where there is no ccx.

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>
#include <vector>

#include "models/solid/import.h"
#include "tests/contains.h"
#include "tests/message_of.h"
#include "tests/models/solid/matrix_files.h"
#include "tests/temporary_folder.h"

using namespace spoke;
using spoke::solid::ImportedMatrices;
using spoke::test::AssembledMatrices;
using spoke::test::contains;
using spoke::test::TemporaryFolder;
using spoke::test::write_text;

namespace {

spatial::SolidMatrices files_of(const TemporaryFolder& folder, const std::string& nodes) {
  spatial::SolidMatrices files;
  files.format = "calculix";
  files.mass = (folder.path() / "free.mas").string();
  files.stiffness = (folder.path() / "free.sti").string();
  files.nodes = (folder.path() / nodes).string();
  return files;
}

constexpr const char* kStore = "*STEP\n*FREQUENCY, SOLVER=MATRIXSTORAGE\n8\n*END STEP\n";

/// Frequencies of a body whose nodes at x = 0 are held [Hz], ascending.
Eigen::VectorXd clamped_frequencies(const ImportedMatrices& read) {
  std::vector<int> kept;
  for (std::size_t node = 0; node < read.nodes.size(); ++node)
    for (int axis = 0; axis < 3 && read.nodes[node].x() > 1e-9; ++axis)
      kept.push_back(3 * static_cast<int>(node) + axis);
  const Eigen::MatrixXd K(read.K), M(test::spread(read.m));
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(
      K(kept, kept), M(kept, kept), Eigen::EigenvaluesOnly);
  return modes.eigenvalues().cwiseSqrt() / (2.0 * M_PI);
}

}  // namespace

TEST_CASE("imported matrices: CalculiX's stiffness is our own, its frequencies follow") {
  if (!test::has_calculix()) return;
  for (const auto kind : {spatial::ElementKind::hex20, spatial::ElementKind::hex8}) {
    const TemporaryFolder folder;
    const AssembledMatrices bar =
        test::assemble({.cells = {4, 1, 1}, .lengths = {1.0, 0.125, 0.25}, .kind = kind});
    test::run_calculix(folder.path(), "free", test::inp_text(bar.mesh, kStore));
    const ImportedMatrices read = solid::read_matrices(files_of(folder, "free.inp"), 1.0);
    const Eigen::MatrixXd K(read.K), own(bar.K);
    CHECK((K - own).cwiseAbs().maxCoeff() < 1e-12 * own.cwiseAbs().maxCoeff());
    CHECK((Eigen::MatrixXd(read.m) - Eigen::MatrixXd(bar.m)).cwiseAbs().maxCoeff() <
          1e-12 * Eigen::MatrixXd(bar.m).maxCoeff());

    test::run_calculix(
        folder.path(), "held",
        test::inp_text(bar.mesh, "*BOUNDARY\nX0, 1, 3\n*STEP\n*FREQUENCY\n8\n*END STEP\n"));
    const std::vector<double> expected = test::read_frequencies(folder / "held.dat");
    const Eigen::VectorXd frequencies = clamped_frequencies(read);
    REQUIRE(expected.size() >= 8);
    for (int mode = 0; mode < 8; ++mode)
      CHECK(frequencies[mode] ==
            doctest::Approx(expected[static_cast<std::size_t>(mode)]).epsilon(1e-6));
  }
}

TEST_CASE("imported matrices: elements of CalculiX that cannot be used, and a constrained export") {
  if (!test::has_calculix()) return;
  const auto message = [](spatial::ElementKind kind, const std::string& type,
                          const std::string& step) {
    const TemporaryFolder folder;
    const AssembledMatrices bar = test::assemble({.cells = {2, 1, 1}, .kind = kind});
    std::string text = test::inp_text(bar.mesh, step);
    const std::size_t at = text.find("TYPE=") + 5;
    text.replace(at, text.find(',', at) - at, type);
    test::run_calculix(folder.path(), "free", text);
    write_text(folder / "nodes.txt", test::table_text(bar.mesh, true));
    return test::message_of([&] { solid::read_matrices(files_of(folder, "nodes.txt"), 1.0); });
  };
  using spatial::ElementKind;
  CHECK(message(ElementKind::hex20, "C3D20", kStore) == "no error");
  const std::string reduced = message(ElementKind::hex20, "C3D20R", kStore);
  CHECK(contains(reduced, "free.mas: the mass matrix is singular"));
  const std::string incompatible = message(ElementKind::hex8, "C3D8I", kStore);
  CHECK(contains(incompatible, "is not in"));
  CHECK(contains(incompatible, "C3D8I"));
  const std::string held =
      message(ElementKind::hex20, "C3D20", std::string("*BOUNDARY\nX0, 1, 3\n") + kStore);
  CHECK(contains(held, "exported with constraints"));
  CHECK(contains(held, "node 10)"));
  const std::string held_in_part =
      message(ElementKind::hex20, "C3D20", std::string("*BOUNDARY\nX0, 3, 3\n") + kStore);
  CHECK(contains(held_in_part, "node 10 lacks its coordinate 3 (z)"));
}
