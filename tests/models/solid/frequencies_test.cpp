// Frequencies of solids against those of an independent assembly with a dense eigensolver, and of
// CalculiX 2.20.

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "models/solid/element_rules.h"
#include "models/solid/elements.h"
#include "spoke/error.h"
#include "tests/models/solid/matrix_files.h"
#include "tests/models/solid/solids.h"
#include "tests/temporary_folder.h"

namespace spoke {
namespace {

using spatial::ElementKind;

/// A problem of aluminium without geometric stiffness, held at a set of nodes.
solid::SolidProblem make_held(const spatial::SolidMesh& mesh, const std::string& root) {
  solid::SolidProblem problem =
      test::make_problem(mesh, test::aluminium(), spatial::Vector::Zero());
  problem.is_stiffened = false;
  test::add_interface(problem, root);
  return problem;
}

/// What an independent assembly says of a mesh.
struct Reference {
  const char* name;
  spatial::SolidMesh mesh;
  const char* root;  ///< the set that is held
  std::size_t nodes, elements, fixed;
  double mass, trace;
  std::vector<double> clamped, free;
};

std::vector<Reference> references() {
  const std::array<double, 3> lengths{1.0, 0.1, 0.1};
  return {
      {"tet10 8x1x1",
       test::make_bar({8, 1, 1}, lengths, ElementKind::tet10),
       "X0",
       153,
       48,
       9,
       27.0,
       3797349845200.0,
       {83.448437, 83.752558, 502.23584, 506.6111, 781.10424, 1281.8851, 1332.3594, 1355.8859,
        2358.0356, 2446.927},
       {507.87123, 509.75945, 1336.4443, 1352.5281, 1565.7976, 2476.0839, 2528.9552, 2543.6508}},
      {"hex20 8x1x1",
       test::make_bar({8, 1, 1}, lengths, ElementKind::hex20),
       "X0",
       104,
       8,
       8,
       27.0,
       2164672858600.0,
       {83.263118, 83.263118, 501.54803, 501.54803, 780.48898, 1281.753, 1329.2675, 1329.2675,
        2341.6568, 2437.3301},
       {507.1939, 507.1939, 1330.8582, 1330.8582, 1561.0019, 2459.4797, 2459.4797, 2543.6402}},
      {"tet4 16x2x2",
       test::make_bar({16, 2, 2}, lengths, ElementKind::tet4),
       "X0",
       153,
       384,
       9,
       27.0,
       3302043343700.0,
       {112.70973, 133.55513, 665.0037, 771.46289, 1167.6273, 1288.7245, 1724.1114, 1952.916,
        3091.7869, 3418.8592},
       {690.83905, 816.37369, 1782.3987, 2055.539, 2335.2428, 2553.6636, 3225.6969, 3627.3788}},
      {"bracket",
       test::make_bracket(),
       "Z1",
       135,
       42,
       9,
       18.9,
       3020619195000.0,
       {218.06893, 228.03289, 537.20314, 665.76249, 1882.4146, 2359.386, 2674.3244, 2982.8428,
        3251.0301, 4355.1893},
       {899.01613, 1942.0544, 2016.938, 2670.3382, 3027.6972, 3502.0716, 4014.4176, 6029.3363}},
      {"tet10 4x1x1",
       test::make_bar({4, 1, 1}, lengths, ElementKind::tet10),
       "X0",
       81,
       24,
       9,
       27.0,
       3106922600600.0,
       {85.227321, 85.861149, 526.09313, 536.72827, 783.82047, 1289.0591, 1469.4239, 1530.2911,
        2431.297, 2975.8807},
       {517.57081, 521.18202, 1431.9631, 1464.5975, 1587.1825, 2544.1617, 2923.2806, 3072.5645}}};
}

void check_frequencies(const std::vector<double>& found, const std::vector<double>& expected,
                       double tolerance) {
  REQUIRE(found.size() >= expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    CAPTURE(k);
    CHECK(std::abs(found[k] / expected[k] - 1.0) < tolerance);
  }
}

TEST_CASE("solid frequencies: clamped and free bodies have those of an independent assembly") {
  for (const Reference& reference : references()) {
    CAPTURE(reference.name);
    solid::SolidProblem problem = make_held(reference.mesh, reference.root);
    CHECK(problem.nodes.size() == reference.nodes);
    CHECK(problem.mesh->elements.size() == reference.elements);
    CHECK(std::abs(problem.matrices.K.diagonal().sum() / reference.trace - 1.0) < 1e-10);
    CHECK(problem.interfaces[0].chosen.nodes.size() == reference.fixed);
    const space::SolidConstants held = solid::calc_constants(problem, {});
    CHECK(std::abs(held.mass / reference.mass - 1.0) < 1e-13);
    CHECK(held.coordinates == 20);
    check_frequencies(held.frequencies, reference.clamped, 1e-7);

    problem.frame = spatial::SolidFrame::mean_axis;
    problem.interfaces[0].kind = spatial::InterfaceKind::average;
    const space::SolidConstants flying = solid::calc_constants(problem, {});
    CHECK(flying.coordinates == 26);  // and six shapes of its interface
    check_frequencies(flying.frequencies, reference.free, 1e-7);
  }
}

/// Mass by the four points that CalculiX takes for C3D10.
solid::Sparse calc_mass_of_4_points(const spatial::SolidMesh& mesh, double density) {
  std::vector<Eigen::Triplet<double>> entries;
  for (const spatial::SolidElement& element : mesh.elements) {
    const solid::NodeColumns x = solid::places_of(mesh, element);
    for (const solid::ShapePoint& point : solid::stiffness_rule(ElementKind::tet10)) {
      const Eigen::Matrix3d J = x * point.dN.transpose();
      for (int a = 0; a < 10; ++a)
        for (int b = 0; b < 10; ++b)
          entries.emplace_back(element.nodes[static_cast<std::size_t>(a)],
                               element.nodes[static_cast<std::size_t>(b)],
                               point.weight * density * J.determinant() * point.N[a] * point.N[b]);
    }
  }
  const auto n = static_cast<Eigen::Index>(mesh.nodes.size());
  solid::Sparse m(n, n);
  m.setFromTriplets(entries.begin(), entries.end());
  return m;
}

TEST_CASE("solid frequencies: with CalculiX's mass of C3D10 they are CalculiX's") {
  struct Row {
    spatial::SolidMesh mesh;
    const char* root;
    std::vector<double> frequencies;
  };
  const std::array<double, 3> lengths{1.0, 0.1, 0.1};
  const Row rows[] = {{test::make_bar({8, 1, 1}, lengths, ElementKind::tet10),
                       "X0",
                       {83.44854, 83.75281, 502.258, 506.6651, 781.264, 1281.89, 1332.77, 1356.84,
                        2362.34, 2449.479}},
                      {test::make_bracket(),
                       "Z1",
                       {218.0704, 228.0348, 537.2316, 665.7962, 1883.282, 2360.608, 2677.269,
                        2984.124, 3256.112, 4362.038}},
                      {test::make_bar({4, 1, 1}, lengths, ElementKind::tet10),
                       "X0",
                       {85.22889, 85.86321, 526.4356, 537.2033, 784.3865, 1289.089, 1475.972,
                        1540.015, 2447.84, 3007.012}}};
  for (const Row& row : rows) {
    solid::SolidProblem problem = make_held(row.mesh, row.root);
    problem.matrices.m = calc_mass_of_4_points(*problem.mesh, 2700.0);
    check_frequencies(solid::calc_constants(problem, {}).frequencies, row.frequencies, 4e-7);
  }
}

/// Runs CalculiX on a mesh and returns the frequencies that it prints [Hz].
std::vector<double> ask_calculix(const spatial::SolidMesh& mesh, const std::string& step) {
  const test::TemporaryFolder folder;
  test::run_calculix(folder.path(), "bar", test::inp_text(mesh, step));
  return test::read_frequencies(folder / "bar.dat");
}

TEST_CASE("solid frequencies: CalculiX, where it is installed, finds the same ones") {
  if (!test::has_calculix()) return;
  spatial::SolidMesh mesh = test::make_bar({8, 1, 1}, {1.0, 0.1, 0.1}, ElementKind::hex20);
  mesh.labels.resize(mesh.nodes.size());
  for (std::size_t k = 0; k < mesh.labels.size(); ++k) mesh.labels[k] = static_cast<int>(k) + 1;
  solid::SolidProblem problem = make_held(mesh, "X0");
  check_frequencies(solid::calc_constants(problem, {}).frequencies,
                    ask_calculix(mesh, "*BOUNDARY\nX0, 1, 3\n*STEP\n*FREQUENCY\n10\n*END STEP\n"),
                    4e-7);
  problem.frame = spatial::SolidFrame::mean_axis;
  problem.interfaces[0].kind = spatial::InterfaceKind::average;
  std::vector<double> free = ask_calculix(mesh, "*STEP\n*FREQUENCY\n14\n*END STEP\n");
  free.erase(free.begin(), free.begin() + 6);
  check_frequencies(solid::calc_constants(problem, {}).frequencies, free, 4e-7);
}

TEST_CASE("solid frequencies: modes up to a frequency, all modes, and more than there are") {
  solid::SolidProblem problem =
      make_held(test::make_bar({2, 1, 1}, {1.0, 0.1, 0.1}, ElementKind::hex20), "X0");
  const int all = static_cast<int>(3 * (problem.nodes.size() - 8));
  problem.modes = all;
  const space::SolidConstants complete = solid::calc_constants(problem, {});
  CHECK(complete.coordinates == all);
  const std::vector<double>& f = complete.frequencies;
  CHECK(std::is_sorted(f.begin(), f.end()));
  for (const int count : {5, 17}) {
    problem.modes.reset();
    problem.up_to =
        0.5 * (f[static_cast<std::size_t>(count) - 1] + f[static_cast<std::size_t>(count)]);
    const space::SolidConstants part = solid::calc_constants(problem, {});
    REQUIRE(part.coordinates == count);
    check_frequencies(part.frequencies, {f.begin(), f.begin() + count}, 1e-9);
  }
  problem.up_to = 2.0 * f.back();
  CHECK(solid::calc_constants(problem, {}).coordinates == all);
  problem.up_to.reset();
  problem.modes = all + 1;
  CHECK_THROWS_WITH_AS(solid::calc_constants(problem, {}),
                       doctest::Contains(std::to_string(all).c_str()), InputError);
}

TEST_CASE("solid frequencies: equal ones are all found, be they six") {
  // Six bars side by side that only the held face joins.
  test::GridMesh grid;
  grid.cells = {4, 11, 1};
  grid.lengths = {1.0, 1.1, 0.1};
  grid.kind = ElementKind::hex20;
  grid.keeps = [](int, int j, int) { return j % 2 == 0; };
  solid::SolidProblem problem = make_held(test::make_grid_mesh(grid), "X0");
  problem.modes = 14;
  const space::SolidConstants six = solid::calc_constants(problem, {});
  const solid::SolidProblem single =
      make_held(test::make_bar({4, 1, 1}, {1.0, 0.1, 0.1}, ElementKind::hex20), "X0");
  const std::vector<double> f = solid::calc_constants(single, {}).frequencies;
  for (std::size_t k = 0; k < 14; ++k)
    CHECK(std::abs(six.frequencies[k] / f[k < 12 ? 0 : 2] - 1.0) < 1e-9);
}

}  // namespace
}  // namespace spoke
