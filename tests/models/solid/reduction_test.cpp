// Reduced solids: orthonormal, with the invariants of the mesh, converging as Craig and Bampton's
// do.

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "models/solid/constraints.h"
#include "models/solid/memory.h"
#include "models/solid/statics.h"
#include "spoke/error.h"
#include "tests/models/solid/solids.h"

namespace spoke {
namespace {

using space::ReducedSolid;
using space::SolidConstants;
using spatial::ElementKind;
using spatial::InterfaceKind;

/// Three interfaces: a held face, a rigid one and one that follows a mean.
solid::SolidProblem make_held_bracket(InterfaceKind root) {
  solid::SolidProblem problem =
      test::make_problem(test::make_bracket(), test::aluminium(), {0.05, 0.05, 0.4});
  test::add_interface(problem, "Z1", root);
  test::add_interface(problem, "X1");
  test::add_interface(problem, "Z0", InterfaceKind::average);
  // Z0 and X1 share a line of nodes: the mean is taken over others.
  solid::ChosenNodes& mean = problem.interfaces[2].chosen;
  std::erase_if(mean.nodes, [&](int node) {
    return problem.nodes[static_cast<std::size_t>(node)].x() > 0.2 - 0.05;
  });
  mean.weights.assign(mean.nodes.size(), 1.0 / static_cast<double>(mean.nodes.size()));
  mean.point.setZero();
  for (const int node : mean.nodes)
    mean.point += mean.weights[0] * problem.nodes[static_cast<std::size_t>(node)];
  return problem;
}

/// The rows of an axis of shapes.
Eigen::MatrixXd axis_of(const Eigen::MatrixXd& shapes, int axis) {
  return shapes(Eigen::seqN(axis, shapes.rows() / 3, 3), Eigen::all);
}

TEST_CASE("solid reduction: a mean that holds is solved as what it couples in full") {
  for (const bool has_boundary : {false, true}) {
    solid::SolidProblem problem = make_held_bracket(InterfaceKind::average);
    if (!has_boundary) problem.interfaces.resize(1);
    const solid::Constraints constraints = solid::make_constraints(
        problem.nodes, problem.interfaces, problem.sets, spatial::SolidFrame::clamped);
    REQUIRE(constraints.dependent.size() == 6);
    const solid::Sparse& K = problem.matrices.K;
    const solid::Sparse whole = solid::project(K, constraints.Xi);
    const solid::MeanStiffness parts = solid::take_apart(K, constraints.Xi, constraints.dependent);
    const Eigen::MatrixXd coupled = parts.follows * parts.coupling.transpose();
    const Eigen::MatrixXd sum = Eigen::MatrixXd(parts.held) + coupled + coupled.transpose() +
                                parts.follows * parts.own * parts.follows.transpose();
    const double largest = whole.coeffs().cwiseAbs().maxCoeff();
    CHECK((sum - Eigen::MatrixXd(whole)).cwiseAbs().maxCoeff() < 1e-14 * largest);
    CHECK(parts.held.nonZeros() < whole.nonZeros());
    const solid::ClampedStatics expected(whole, constraints.boundary, {});
    const solid::ClampedStatics found(whole, parts, constraints.boundary, {});
    REQUIRE(found.is_definite());
    const Eigen::MatrixXd f = Eigen::MatrixXd::Random(whole.rows(), 3);
    const Eigen::MatrixXd q = expected.solve(f), modes = expected.constraint_modes();
    CHECK((found.solve(f) - q).norm() < 1e-11 * q.norm());
    CHECK((found.constraint_modes() - modes).norm() <= 1e-11 * modes.norm());
  }
}

TEST_CASE("solid reduction: modes are orthonormal, and invariants those of the mesh") {
  for (const InterfaceKind root : {InterfaceKind::rigid, InterfaceKind::average}) {
    for (const auto frame : {spatial::SolidFrame::clamped, spatial::SolidFrame::mean_axis}) {
      solid::SolidProblem problem = make_held_bracket(root);
      problem.frame = frame;
      problem.modes = 12;
      problem.is_stiffened = false;
      const bool is_free = frame == spatial::SolidFrame::mean_axis;
      const SolidConstants body = solid::calc_constants(problem, {});
      CHECK(body.coordinates == 12 + 12 + (is_free ? 6 : 0));
      const ReducedSolid& solid = *body.reduced();
      const Eigen::MatrixXd& Phi = solid.shapes;
      const solid::Sparse& m = problem.matrices.m;
      Eigen::MatrixXd x(m.rows(), 3), mass = Eigen::MatrixXd::Zero(Phi.cols(), Phi.cols());
      for (Eigen::Index i = 0; i < m.rows(); ++i)
        x.row(i) = problem.nodes[static_cast<std::size_t>(i)].transpose();
      for (int a = 0; a < 3; ++a) mass += axis_of(Phi, a).transpose() * (m * axis_of(Phi, a));
      CHECK((mass - Eigen::MatrixXd::Identity(mass.rows(), mass.cols())).cwiseAbs().maxCoeff() <
            1e-12);
      const Eigen::MatrixXd K = Phi.transpose() * (problem.matrices.K * Phi);
      const Eigen::MatrixXd diagonal = solid.stiffness.asDiagonal();
      CHECK((K - diagonal).cwiseAbs().maxCoeff() < 1e-10 * solid.stiffness.maxCoeff());
      CHECK(std::is_sorted(solid.stiffness.begin(), solid.stiffness.end()));
      for (int a = 0; a < 3; ++a) {
        CHECK(
            (solid.C_t.col(a) - axis_of(Phi, a).transpose() * (m * Eigen::VectorXd::Ones(m.rows())))
                .cwiseAbs()
                .maxCoeff() < 1e-13 * std::sqrt(body.mass));
        for (int b = 0; b < 3; ++b) {
          const auto k = static_cast<std::size_t>(3 * a + b);
          CHECK((solid.m[k] - axis_of(Phi, a).transpose() * (m * axis_of(Phi, b)))
                    .cwiseAbs()
                    .maxCoeff() < 1e-13);
          CHECK((solid.h[k] - axis_of(Phi, a).transpose() * (m * x.col(b))).cwiseAbs().maxCoeff() <
                1e-13 * std::sqrt(body.mass));
        }
      }
      CHECK((body.J0 - x.transpose() * (m * x)).cwiseAbs().maxCoeff() < 1e-14 * body.mass);
      // Places in modes are those of the shapes.
      for (std::size_t p = 0; p < body.places.size(); ++p) {
        if (body.places[p].is_fixed()) {
          CHECK((p == 0 && !is_free));
          continue;
        }
        const solid::ChosenNodes& chosen = problem.interfaces[p].chosen;
        const auto E = solid::make_average(chosen, problem.nodes);
        Eigen::MatrixXd u(3 * static_cast<Eigen::Index>(chosen.nodes.size()), Phi.cols());
        for (std::size_t k = 0; k < chosen.nodes.size(); ++k)
          u.middleRows<3>(static_cast<Eigen::Index>(3 * k)) =
              Phi.middleRows<3>(3 * chosen.nodes[k]);
        const Eigen::MatrixXd expected = E * u;  // of a rigid interface, its motion itself
        for (std::size_t c = 0; c < body.places[p].at.size(); ++c)
          CHECK((body.places[p].columns[c] - expected.col(body.places[p].at[c]))
                    .cwiseAbs()
                    .maxCoeff() < 1e-11 * expected.cwiseAbs().maxCoeff());
      }
    }
  }
}

TEST_CASE("solid reduction: the clamped frame of a mean keeps the mean at rest") {
  solid::SolidProblem problem = make_held_bracket(InterfaceKind::average);
  problem.is_stiffened = false;
  const SolidConstants body = solid::calc_constants(problem, {});
  const solid::ChosenNodes& root = problem.interfaces[0].chosen;
  const auto E = solid::make_average(root, problem.nodes);
  Eigen::MatrixXd u(3 * static_cast<Eigen::Index>(root.nodes.size()), body.coordinates);
  for (std::size_t k = 0; k < root.nodes.size(); ++k)
    u.middleRows<3>(static_cast<Eigen::Index>(3 * k)) =
        body.reduced()->shapes.middleRows<3>(3 * root.nodes[k]);
  CHECK((E * u).cwiseAbs().maxCoeff() < 1e-12 * u.cwiseAbs().maxCoeff() / 0.01);
  CHECK(u.cwiseAbs().maxCoeff() > 1e-3);  // but its nodes move
}

TEST_CASE("solid reduction: means turn and move with rigid motions, and spread a force") {
  const spatial::SolidMesh mesh = test::make_bracket();
  std::vector<space::Position> nodes(mesh.nodes.begin(), mesh.nodes.end());
  solid::ChosenNodes chosen = test::choose_equally(mesh, "X0");
  for (std::size_t k = 0; k < chosen.weights.size(); ++k)
    chosen.weights[k] =
        (1.0 + static_cast<double>(k)) /
        (0.5 * static_cast<double>(chosen.weights.size() * (chosen.weights.size() + 1)));
  chosen.point = {0.1, -0.2, 0.7};
  const auto E = solid::make_average(chosen, nodes);
  const Eigen::Vector3d v(0.3, -0.1, 0.2), turn(0.02, -0.05, 0.01);
  Eigen::VectorXd u(E.cols());
  for (std::size_t k = 0; k < chosen.nodes.size(); ++k)
    u.segment<3>(static_cast<Eigen::Index>(3 * k)) =
        v + turn.cross(Eigen::Vector3d(nodes[static_cast<std::size_t>(chosen.nodes[k])]));
  Eigen::VectorXd expected(6);
  expected << v + turn.cross(Eigen::Vector3d(chosen.point)), turn;
  CHECK((E * u - expected).cwiseAbs().maxCoeff() < 1e-13);

  Eigen::VectorXd wrench(6);
  wrench << 3.0, -2.0, 5.0, 0.7, 0.2, -0.4;
  const Eigen::VectorXd forces = E.transpose() * wrench;
  Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = force;
  for (std::size_t k = 0; k < chosen.nodes.size(); ++k) {
    const Eigen::Vector3d f = forces.segment<3>(static_cast<Eigen::Index>(3 * k));
    force += f;
    moment +=
        Eigen::Vector3d(nodes[static_cast<std::size_t>(chosen.nodes[k])] - chosen.point).cross(f);
  }
  CHECK((force - wrench.head<3>()).cwiseAbs().maxCoeff() < 1e-13);
  CHECK((moment - wrench.tail<3>()).cwiseAbs().maxCoeff() < 1e-13);
}

TEST_CASE("solid reduction: one node or a line of nodes have a mean that does not turn about it") {
  const std::vector<space::Position> nodes{{1.0, 2.0, 3.0}, {1.0, 2.0, 4.0}, {1.0, 2.0, 5.0}};
  const auto one = solid::make_average({{1}, {1.0}, {1.0, 2.0, 4.0}, 0.0}, nodes);
  CHECK(one.topRows<3>() == Eigen::Matrix3d::Identity());
  CHECK(one.bottomRows<3>().isZero(0.0));
  const auto line =
      solid::make_average({{0, 1, 2}, {0.25, 0.5, 0.25}, {1.0, 2.0, 4.0}, 0.0}, nodes);
  CHECK(line.row(5).isZero(0.0));
  Eigen::VectorXd u(9);  // a turn about x through the middle
  u << 0.0, 0.1, 0.0, 0.0, 0.0, 0.0, 0.0, -0.1, 0.0;
  CHECK(std::abs((line * u)[3] - 0.1) < 1e-15);
}

TEST_CASE("solid reduction: six modes of an interface and 14 give the lowest frequencies") {
  // A bar that is held at one end and has a rigid interface at the other, free: frequencies with
  // all modes are the exact ones.
  solid::SolidProblem problem =
      test::make_problem(test::make_bar({4, 1, 1}, {1.0, 0.1, 0.1}, ElementKind::tet10),
                         test::aluminium(), spatial::Vector::Zero());
  problem.is_stiffened = false;
  test::add_interface(problem, "X0");
  test::add_interface(problem, "X1");
  problem.modes = 14;
  const SolidConstants reduced = solid::calc_constants(problem, {});
  CHECK(reduced.coordinates == 20);
  problem.modes = static_cast<int>(3 * (problem.nodes.size() - 18));
  const SolidConstants complete = solid::calc_constants(problem, {});
  CHECK(complete.coordinates == *problem.modes + 6);
  // An independent prototype has found 2e-6, 4e-6, 5e-5, 1.3e-4, 1.1e-4, 1e-3.
  const double expected[] = {4e-6, 8e-6, 1e-4, 2.6e-4, 2.2e-4, 2e-3};
  for (int k = 0; k < 6; ++k) {
    const double excess =
        std::sqrt(reduced.reduced()->stiffness[k] / complete.reduced()->stiffness[k]) - 1.0;
    CHECK(excess > -1e-9);
    CHECK(excess < expected[k]);
  }
}

TEST_CASE("solid reduction: static loads on interfaces deform it exactly") {
  for (const InterfaceKind root : {InterfaceKind::rigid, InterfaceKind::average}) {
    solid::SolidProblem problem = make_held_bracket(root);
    problem.is_stiffened = false;
    const SolidConstants reduced = solid::calc_constants(problem, {});
    problem.coordinates = spatial::SolidCoordinates::nodal;
    const SolidConstants nodal = solid::calc_constants(problem, {});
    const space::NodalSolid& body = *nodal.nodal();
    const Eigen::LLT<Eigen::MatrixXd> K{Eigen::MatrixXd(body.K)};
    for (std::size_t p = 1; p < 3; ++p) {
      Eigen::MatrixXd E = Eigen::MatrixXd::Zero(6, nodal.coordinates),
                      E_r = Eigen::MatrixXd::Zero(6, reduced.coordinates);
      for (std::size_t k = 0; k < nodal.places[p].at.size(); ++k)
        E.col(nodal.places[p].at[k]) = nodal.places[p].columns[k];
      for (std::size_t k = 0; k < reduced.places[p].at.size(); ++k)
        E_r.col(reduced.places[p].at[k]) = reduced.places[p].columns[k];
      const Eigen::MatrixXd exact = E * K.solve(E.transpose());
      const Eigen::MatrixXd modal =
          E_r * reduced.reduced()->stiffness.cwiseInverse().asDiagonal() * E_r.transpose();
      CHECK((modal - exact).cwiseAbs().maxCoeff() < 1e-9 * exact.cwiseAbs().maxCoeff());
    }
  }
}

TEST_CASE("solid reduction: damping ratios, one or as many as there are modes") {
  solid::SolidProblem problem = make_held_bracket(InterfaceKind::rigid);
  problem.is_stiffened = false;
  problem.modes = 3;
  SolidConstants body = solid::calc_constants(problem, {});
  const ReducedSolid& solid = *body.reduced();
  solid::set_damping({}, body);
  REQUIRE(solid.damping.size() == body.coordinates);
  CHECK(solid.damping.isZero(0.0));
  solid::set_damping({0.02}, body);
  for (int k = 0; k < body.coordinates; ++k)
    CHECK(solid.damping[k] == doctest::Approx(0.04 * std::sqrt(solid.stiffness[k])));
  std::vector<double> ratios(static_cast<std::size_t>(body.coordinates), 0.0);
  ratios[1] = 0.5;
  solid::set_damping(ratios, body);
  CHECK(solid.damping[1] == doctest::Approx(std::sqrt(solid.stiffness[1])));
  CHECK(solid.damping[0] == 0.0);
  ratios.pop_back();
  CHECK_THROWS_WITH_AS(solid::set_damping(ratios, body), doctest::Contains("15"), InputError);
}

TEST_CASE("solid reduction: more memory than there is, is refused before it is used") {
  spatial::SolidBody body;
  body.interfaces.resize(2);
  auto mesh = std::make_shared<spatial::SolidMesh>(test::make_bracket());
  solid::SolidGeometry geometry;
  geometry.mesh = mesh;
  const double small = solid::estimate_memory(body, geometry);
  solid::require_memory(body, geometry, 1e10);
  CHECK(small < 1e8);
  mesh->nodes.resize(3000000);  // its factor would have some 6e10 entries
  CHECK(solid::estimate_memory(body, geometry) > 1e11);
  CHECK_THROWS_WITH_AS(solid::require_memory(body, geometry, 1e10), doctest::Contains("GB"),
                       InputError);
  CHECK_THROWS_AS(solid::require_factor_memory(1e13, 1e10), InputError);
}

TEST_CASE("solid reduction: modes up to a frequency are refused where there are too many") {
  solid::SolidProblem problem = make_held_bracket(InterfaceKind::rigid);
  problem.is_stiffened = false;
  problem.up_to = 1e3;
  const double unknowns = 3.0 * static_cast<double>(problem.nodes.size());
  // Enough for 24 modes and three interfaces' shapes, where the search begins, but not for 48.
  const double bytes = 8.0 * unknowns * (10.0 * (36.0 + 18.0) + 100.0);
  const solid::Control control{.memory = bytes / 0.8};
  CHECK(solid::calc_constants(problem, control).frequencies.size() < 24);
  problem.up_to = 1e5;
  CHECK_THROWS_WITH_AS(solid::calc_constants(problem, control),
                       doctest::Contains("use a lower frequency"), InputError);
}

TEST_CASE("solid reduction: stresses of nodes under constant strain are that stress") {
  Eigen::Matrix3d H;
  H << 1e-3, 2e-4, -3e-4, 5e-4, -2e-3, 1e-4, 4e-4, -6e-4, 7e-4;
  const spatial::SolidMaterial material = test::aluminium();
  const double mu = material.youngs_modulus / (2.0 * (1.0 + material.poissons_ratio));
  const double lambda = 2.0 * mu * material.poissons_ratio / (1.0 - 2.0 * material.poissons_ratio);
  const Eigen::Matrix3d stress =
      mu * (H + H.transpose()) + lambda * H.trace() * Eigen::Matrix3d::Identity();
  Eigen::VectorXd expected(6);
  expected << stress(0, 0), stress(1, 1), stress(2, 2), stress(1, 2), stress(0, 2), stress(0, 1);
  for (const ElementKind kind :
       {ElementKind::tet4, ElementKind::tet10, ElementKind::hex8, ElementKind::hex20}) {
    const spatial::SolidMesh mesh = test::make_bar({3, 2, 1}, {1.0, 0.4, 0.3}, kind);
    Eigen::VectorXd u(3 * static_cast<Eigen::Index>(mesh.nodes.size()));
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
      u.segment<3>(static_cast<Eigen::Index>(3 * i)) = H * mesh.nodes[i];
    const Eigen::VectorXd found = solid::make_stress_operator(mesh, material) * u;
    for (Eigen::Index i = 0; i < found.size(); i += 6)
      CHECK((found.segment<6>(i) - expected).cwiseAbs().maxCoeff() < 1e-11 * stress.norm());
  }
}

}  // namespace
}  // namespace spoke
