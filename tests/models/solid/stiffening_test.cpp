// Geometric stiffness: frequencies of rotating bars, the slope of torsion, and foreshortening.

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "tests/approx.h"
#include "tests/models/solid/solids.h"

namespace spoke {
namespace {

using space::NodalSolid;
using space::ReducedSolid;
using space::SolidConstants;
using spatial::ElementKind;
using testing::approx;

/// A bar along x of length 1 with rho A = 1 and E I about y = 1, held at x = 0, centred on the
/// axis.
solid::SolidProblem make_spinning_bar(int cells, ElementKind kind, double b, double t, double nu) {
  const spatial::SolidMaterial material{12.0 / (b * t * t * t), nu, 1.0 / (b * t)};
  solid::SolidProblem problem = test::make_problem(
      test::make_bar({cells, 1, 1}, {1.0, b, t}, kind, true), material, spatial::Vector::Zero());
  test::add_interface(problem, "X0");
  return problem;
}

/// Returns the stiffness K + K_G(w) + Phi^T (m (x) A(w)) Phi of modes.
Eigen::MatrixXd rotating_stiffness(const ReducedSolid& solid, const space::Angular& w) {
  Eigen::MatrixXd K = solid.stiffness.asDiagonal();
  const std::array<double, space::kSpins> spins = space::spin_monomials(w);
  for (std::size_t k = 0; k < spins.size(); ++k) K += spins[k] * solid.own[k];
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      const double A = w[a] * w[b] - (a == b ? w.squaredNorm() : 0.0);
      K += A * solid.m[static_cast<std::size_t>(3 * a + b)];
    }
  return K;
}

/// Returns frequencies [rad/s] and shapes of a rotating bar in its modes.
Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solve_modes(const SolidConstants& bar, double w) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(
      rotating_stiffness(*bar.reduced(), {0.0, 0.0, w}));
}

/// The motion of a mode along axis y or z as part of all, by the squares of displacements.
double share_of_axis(const Eigen::VectorXd& u, int axis) {
  double sum = 0.0;
  for (Eigen::Index i = axis; i < u.size(); i += 3) sum += u[i] * u[i];
  return sum / u.squaredNorm();
}

/// The mean moment of the displacements about the bar, as part of their size: 1 of torsion.
double share_of_twist(const SolidConstants& bar, const Eigen::VectorXd& u) {
  double sum = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < bar.nodes.size(); ++i) {
    const Eigen::Vector3d v = u.segment<3>(static_cast<Eigen::Index>(3 * i));
    sum += bar.nodes[i].y() * v.z() - bar.nodes[i].z() * v.y();
    largest += std::hypot(bar.nodes[i].y(), bar.nodes[i].z()) * v.norm();
  }
  return std::abs(sum) / largest;
}

/// Modes among which those of the references are.
constexpr Eigen::Index kLowest = 12;

/// Frequencies of the modes that move along z, or along y or z, ascending.
std::vector<double> bending_frequencies(const SolidConstants& bar, double w, bool is_flap) {
  const auto eigen = solve_modes(bar, w);
  std::vector<double> found;
  for (Eigen::Index k = 0; k < kLowest; ++k) {
    const Eigen::VectorXd u = bar.reduced()->shapes * eigen.eigenvectors().col(k);
    const double share = share_of_axis(u, 2) + (is_flap ? 0.0 : share_of_axis(u, 1));
    if (share > 0.7 && share_of_twist(bar, u) < 0.5)
      found.push_back(std::sqrt(eigen.eigenvalues()[k]));
  }
  return found;
}

double torsion_of(const SolidConstants& bar, double w) {
  const auto eigen = solve_modes(bar, w);
  for (Eigen::Index k = 0; k < kLowest; ++k)
    if (share_of_twist(bar, bar.reduced()->shapes * eigen.eigenvectors().col(k)) > 0.5)
      return std::sqrt(eigen.eigenvalues()[k]);
  return 0.0;
}

/// Flap and lag of an independent prototype at a speed [rad/s].
struct Row {
  double speed;
  std::array<double, 3> flap, lag;
};

void check_bar(const SolidConstants& bar, const std::vector<Row>& rows) {
  for (const Row& row : rows) {
    CAPTURE(row.speed);
    // At rest modes of a square section are those of its diagonals: all in one list.
    std::vector<double> expected(row.flap.begin(), row.flap.end());
    expected.insert(expected.end(), row.lag.begin(), row.lag.end());
    std::sort(expected.begin(), expected.end());
    const std::vector<double> found = bending_frequencies(bar, row.speed, false);
    REQUIRE(found.size() >= expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k)
      CHECK(std::abs(found[k] / expected[k] - 1.0) < 1e-5);
  }
}

TEST_CASE("solid stiffening: flap and lag of rotating bars are those of an independent prototype") {
  solid::SolidProblem problem = make_spinning_bar(24, ElementKind::tet10, 0.01, 0.01, 0.3);
  problem.modes = 60;
  check_bar(solid::calc_constants(problem, {}),
            {{0.0, {3.53596, 22.18161, 62.23996}, {3.53953, 22.20661, 62.32905}},
             {4.0, {5.60505, 24.42505, 64.55191}, {3.92654, 24.09461, 64.40068}},
             {12.0, {13.20065, 37.73544, 80.11315}, {5.50145, 35.77762, 79.20741}}});
  problem = make_spinning_bar(24, ElementKind::tet10, 0.01, 0.01, 0.0);
  problem.modes = 60;
  check_bar(solid::calc_constants(problem, {}),
            {{0.0, {3.51673, 22.06578, 61.90659}, {3.51678, 22.06813, 61.9223}},
             {2.0, {4.13807, 22.64686, 62.4906}, {3.62269, 22.5584, 62.45503}},
             {6.0, {7.36178, 26.83833, 66.88888}, {4.26595, 26.15943, 66.61918}},
             {8.0, {9.25901, 30.02375, 70.49076}, {4.66192, 28.93892, 70.0357}},
             {12.0, {13.17461, 37.63214, 79.79995}, {5.43868, 35.66875, 78.89365}}});
  problem = make_spinning_bar(48, ElementKind::tet10, 0.01, 0.01, 0.0);
  problem.modes = 60;
  check_bar(solid::calc_constants(problem, {}),
            {{0.0, {3.51599, 22.03353, 61.69085}, {3.51593, 22.03088, 61.67318}},
             {12.0, {13.17027, 37.60084, 79.60117}, {5.42815, 35.63573, 78.69256}}});
}

TEST_CASE("solid stiffening: a flat bar's flap and torsion, and the slope of torsion") {
  solid::SolidProblem problem = make_spinning_bar(32, ElementKind::hex20, 0.06, 0.01, 0.3);
  problem.modes = 60;
  const SolidConstants bar = solid::calc_constants(problem, {});
  const std::pair<double, std::array<double, 4>> rows[] = {
      {0.0, {3.543, 22.20269, 62.19415, 111.1139}},
      {4.0, {5.61, 24.43414, 64.45306, 111.2597}},
      {8.0, {9.28639, 30.14501, 70.75482, 111.6958}},
      {12.0, {13.20704, 37.74805, 80.05107, 112.4186}}};
  for (const auto& row : rows) {
    const double speed = row.first;
    const std::array<double, 4>& expected = row.second;
    CAPTURE(speed);
    const std::vector<double> flap = bending_frequencies(bar, speed, true);
    for (std::size_t k = 0; k < 3; ++k) CHECK(std::abs(flap[k] / expected[k] - 1.0) < 1e-5);
    CHECK(std::abs(torsion_of(bar, speed) / expected[3] - 1.0) < 1e-5);
  }
  // Propeller term (b^2 - t^2) / (b^2 + t^2) and trapeze term: no terms of their own are needed.
  const double slope = (std::pow(torsion_of(bar, 8.0), 2) - std::pow(torsion_of(bar, 0.0), 2)) / 64;
  CHECK(slope == approx(2.0258).epsilon(2e-3));
}

/// K + K_G(w) + m (x) A(w) in the coordinates of nodes.
Eigen::MatrixXd rotating_stiffness(const NodalSolid& solid, const space::Angular& w) {
  solid::Sparse kg = solid.m;
  Eigen::VectorXd values = Eigen::VectorXd::Zero(kg.nonZeros());
  const std::array<double, space::kSpins> spins = space::spin_monomials(w);
  for (std::size_t k = 0; k < spins.size(); ++k) values += spins[k] * solid.own[k];
  std::copy(values.begin(), values.end(), kg.valuePtr());
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(solid.Xi.rows(), solid.Xi.rows());
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      const double A = w[a] * w[b] - (a == b ? w.squaredNorm() : 0.0);
      for (Eigen::Index j = 0; j < kg.cols(); ++j) {
        solid::Sparse::InnerIterator geometric(kg, j);
        for (solid::Sparse::InnerIterator mass(solid.m, j); mass; ++mass, ++geometric)
          full(3 * mass.row() + a, 3 * j + b) =
              A * mass.value() + (a == b ? geometric.value() : 0.0);
      }
    }
  return Eigen::MatrixXd(solid.K) + solid.Xi.transpose() * full * solid.Xi;
}

TEST_CASE("solid stiffening: with all modes reduced is nodal, at any spin") {
  for (const auto kind : {spatial::InterfaceKind::rigid, spatial::InterfaceKind::average}) {
    solid::SolidProblem problem = make_spinning_bar(2, ElementKind::hex20, 0.1, 0.1, 0.3);
    problem.interfaces[0].kind = kind;
    test::add_interface(problem, "X1");
    problem.coordinates = spatial::SolidCoordinates::nodal;
    const SolidConstants nodal = solid::calc_constants(problem, {});
    problem.coordinates = spatial::SolidCoordinates::reduced;
    problem.modes = nodal.coordinates - 6;
    const SolidConstants reduced = solid::calc_constants(problem, {});
    REQUIRE(reduced.coordinates == nodal.coordinates);
    const space::Angular w(3.0, -7.0, 5.0);
    const NodalSolid& body = *nodal.nodal();
    Eigen::MatrixXd M = Eigen::MatrixXd::Zero(body.Xi.rows(), body.Xi.rows());
    for (Eigen::Index j = 0; j < body.m.cols(); ++j)
      for (solid::Sparse::InnerIterator entry(body.m, j); entry; ++entry)
        for (int a = 0; a < 3; ++a) M(3 * entry.row() + a, 3 * j + a) = entry.value();
    const Eigen::MatrixXd mass = body.Xi.transpose() * M * body.Xi;
    const Eigen::VectorXd full =
        Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(rotating_stiffness(body, w), mass)
            .eigenvalues();
    const Eigen::VectorXd modal =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(rotating_stiffness(*reduced.reduced(), w))
            .eigenvalues();
    // Of translation and of wrenches on the tip, too: projected they are those of modes.
    const Eigen::MatrixXd& Phi = reduced.reduced()->shapes;
    const auto check_projected = [&](const Eigen::VectorXd& values, const Eigen::MatrixXd& found) {
      solid::Sparse kg = body.m;
      std::copy(values.begin(), values.end(), kg.valuePtr());
      Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(Phi.cols(), Phi.cols());
      for (int a = 0; a < 3; ++a) {
        const Eigen::MatrixXd axis = Phi(Eigen::seqN(a, Phi.rows() / 3, 3), Eigen::all);
        expected += axis.transpose() * (kg * axis);
      }
      CHECK((found - expected).cwiseAbs().maxCoeff() < 1e-12 * expected.cwiseAbs().maxCoeff());
    };
    for (std::size_t c = 0; c < 3; ++c)
      check_projected(body.translation[c], reduced.reduced()->translation[c]);
    for (std::size_t c = 0; c < 6; ++c) {
      check_projected(body.places[1][c], reduced.reduced()->places[1][c]);
      CHECK(reduced.reduced()->places[0][c].isZero(0.0));  // what the frame fixes has no stress
    }
    CHECK((modal.array() / full.array() - 1.0).abs().head(12).maxCoeff() < 1e-8);
    CHECK((modal - full).cwiseAbs().maxCoeff() < 1e-10 * full.cwiseAbs().maxCoeff());
  }
}

/// The bar grid(12, 1, 1; 1, 0.05, 0.05), E 1e7, nu 0.3, with an interface at its tip that follows
/// the mean of its nodes.
SolidConstants make_loaded_bar(spatial::SolidCoordinates coordinates) {
  solid::SolidProblem problem =
      test::make_problem(test::make_bar({12, 1, 1}, {1.0, 0.05, 0.05}, ElementKind::tet10, true),
                         {1e7, 0.3, 1000.0}, spatial::Vector::Zero());
  test::add_interface(problem, "X0");
  test::add_interface(problem, "X1", spatial::InterfaceKind::average);
  problem.coordinates = coordinates;
  return solid::calc_constants(problem, {});
}

TEST_CASE("solid stiffening: foreshortening of a loaded bar is that of total Lagrangian") {
  // Total Lagrangian, and - 1/2 q^T K_G^(tip, x) q by an independent prototype.
  struct Row {
    double force, total, second_order;
  };
  const SolidConstants bar = make_loaded_bar(spatial::SolidCoordinates::reduced);
  const ReducedSolid& solid = *bar.reduced();
  Eigen::MatrixXd E = Eigen::MatrixXd::Zero(6, bar.coordinates);
  for (std::size_t k = 0; k < bar.places[1].at.size(); ++k)
    E.col(bar.places[1].at[k]) = bar.places[1].columns[k];
  for (const Row& row :
       {Row{0.04, -4.815681e-06, -4.766177e-06}, Row{0.08, -1.915978e-05, -1.906471e-05}}) {
    Eigen::VectorXd wrench = Eigen::VectorXd::Zero(6);
    wrench[1] = 0.5 * row.force;
    wrench[2] = row.force;
    // The attachment modes of the tip have the static solution in their span.
    const Eigen::VectorXd q =
        (E.transpose() * wrench).cwiseQuotient(Eigen::VectorXd(solid.stiffness));
    const double second = -0.5 * q.dot(solid.places[1][0] * q);
    const Eigen::VectorXd tip = E * q;
    CHECK(std::abs(second / row.second_order - 1.0) < 1e-5);
    CHECK(std::abs(tip[0] + 5.1e-8 * row.force / 0.04) < 1e-9);
    CHECK(std::abs((tip[0] + second) / row.total - 1.0) < 5e-4);
  }
}

TEST_CASE("solid stiffening: a held bar's tension under weight, spin and pull is that by hand") {
  solid::SolidProblem problem =
      test::make_problem(test::make_bar({12, 1, 1}, {1.0, 0.02, 0.02}, ElementKind::hex20, true),
                         {1e7, 0.0, 1000.0}, spatial::Vector::Zero());
  test::add_interface(problem, "X0");
  test::add_interface(problem, "X1");
  problem.modes = 60;
  const SolidConstants bar = solid::calc_constants(problem, {});
  const ReducedSolid& solid = *bar.reduced();
  // v = s^2 / 2 along z, so that the work is int N s^2 ds; rho A = 0.4.
  Eigen::VectorXd u(3 * static_cast<Eigen::Index>(bar.nodes.size()));
  for (std::size_t i = 0; i < bar.nodes.size(); ++i) {
    const double s = bar.nodes[i].x();
    u.segment<3>(static_cast<Eigen::Index>(3 * i)) << -bar.nodes[i].z() * s, 0.0, 0.5 * s * s;
  }
  const Eigen::VectorXd q = solid.shapes.colPivHouseholderQr().solve(u);
  CHECK((solid.shapes * q - u).norm() < 1e-3 * u.norm());
  const auto work = [&](const Eigen::MatrixXd& K) { return q.dot(K * q); };
  // Accelerated along x: N = - rho A (1 - s).
  CHECK(work(solid.translation[0]) == approx(-0.4 / 12.0).epsilon(5e-3));
  // Spun: N = rho A (1 - s^2) / 2, about y and about z.
  CHECK(work(solid.own[1]) == approx(0.4 / 15.0).epsilon(5e-3));
  CHECK(work(solid.own[2]) == approx(0.4 / 15.0).epsilon(5e-3));
  // Pulled at the tip: N = 1.
  CHECK(work(solid.places[1][0]) == approx(1.0 / 3.0).epsilon(5e-3));
}

TEST_CASE("solid stiffening: a bar that flies by itself has the stress of its own rotation") {
  // Of a bar that spins about its middle the tension is rho A w^2 (L^2/4 - s^2) / 2: the work of
  // K_G on a slope v' = s^2 is int N v'^2 ds; here by hand for v = s^2 / 2, v' = s.
  solid::SolidProblem problem =
      test::make_problem(test::make_bar({12, 1, 1}, {1.0, 0.02, 0.02}, ElementKind::hex20, true),
                         {1e7, 0.0, 1000.0}, spatial::Vector::Zero());
  test::add_interface(problem, "X0", spatial::InterfaceKind::average);
  test::add_interface(problem, "X1", spatial::InterfaceKind::average);
  problem.frame = spatial::SolidFrame::mean_axis;
  problem.modes = 60;
  const SolidConstants bar = solid::calc_constants(problem, {});
  const ReducedSolid& solid = *bar.reduced();
  CHECK(solid.C_t.cwiseAbs().maxCoeff() < 1e-10);
  // Moment of momentum about the origin: of modes with C_t = 0 that about any point.
  for (const auto& [a, b] : {std::pair{0, 1}, std::pair{1, 2}, std::pair{2, 0}})
    CHECK((solid.h[static_cast<std::size_t>(3 * b + a)] -
           solid.h[static_cast<std::size_t>(3 * a + b)])
              .cwiseAbs()
              .maxCoeff() < 1e-10);
  // Least squares for v along z, u = (-z v', 0, v), without rigid motions: in the span of modes.
  Eigen::VectorXd u(3 * static_cast<Eigen::Index>(bar.nodes.size()));
  for (std::size_t i = 0; i < bar.nodes.size(); ++i) {
    const double s = bar.nodes[i].x() - 0.5;
    u.segment<3>(static_cast<Eigen::Index>(3 * i)) << -bar.nodes[i].z() * s, 0.0,
        0.5 * s * s - 1.0 / 24.0;
  }
  const Eigen::VectorXd q = solid.shapes.colPivHouseholderQr().solve(u);
  CHECK((solid.shapes * q - u).norm() < 0.02 * u.norm());
  // int over s from -1/2 to 1/2 of rho A (1/4 - s^2) / 2 s^2 = rho A / 240.
  const double work = q.dot(solid.own[2] * q);
  CHECK(work == approx(0.4 / 240.0).epsilon(0.02));
  for (const Eigen::MatrixXd& K : solid.translation) CHECK(K.cwiseAbs().maxCoeff() == 0.0);
  // A pull at one end with the relief of the acceleration: N = F (s + 1/2), int N s^2 = F / 24.
  const double pulled = q.dot(solid.places[1][0] * q);
  CHECK(pulled == approx(1.0 / 24.0).epsilon(0.02));
}

}  // namespace
}  // namespace spoke
