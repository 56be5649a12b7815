// Tests bearings with full matrices at rest: where they hold a weight, and the roots of small
// motions on them.

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <complex>
#include <numbers>
#include <vector>

#include "engine/equilibrium.h"
#include "engine/modes.h"
#include "engine/small_motions/steady/linear_model.h"
#include "tests/engine/bearing_models.h"

namespace spoke {
namespace {

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;
using test::matrix_key;

Matrix2d make_matrix(double xx, double xy, double yx, double yy) {
  Matrix2d matrix;
  matrix << xx, xy, yx, yy;
  return matrix;
}

std::string key_of(const std::string& key, const Matrix2d& A) {
  return matrix_key(key, A(0, 0), A(0, 1), A(1, 0), A(1, 1));
}

/// A mass of 40 kg along x and 30 kg along y.
Scenario make_mass(const std::string& keys, const std::string& gravity = "[0,0,0]") {
  return parse_scenario(test::make_sliding_mass(keys, {0, 0}, {0, 0}, 0.0, 0.0, gravity), "f");
}

/// Returns the roots of (M s^2 + C s + K) u = 0 with imaginary parts of 0 or more, by these.
std::vector<std::complex<double>> find_roots(const Matrix2d& K, const Matrix2d& C) {
  const Matrix2d M = make_matrix(40, 0, 0, 30);
  Eigen::Matrix4d A = Eigen::Matrix4d::Zero();
  A.topRightCorner<2, 2>().setIdentity();
  A.bottomLeftCorner<2, 2>() = -(M.inverse() * K);
  A.bottomRightCorner<2, 2>() = -(M.inverse() * C);
  std::vector<std::complex<double>> roots;
  for (const std::complex<double> root : A.eigenvalues())
    if (root.imag() >= 0.0) roots.push_back(root);
  return roots;
}

/// Checks K and C of a model's only subsystem against differences of the step's accelerations.
void check_linear_bearing(const Scenario& scenario) {
  const auto model = steady::make_steady_model(scenario, {});
  const steady::Equilibrium equilibrium = steady::find_equilibrium(*model);
  const steady::LinearSubsystem own = steady::linearize(equilibrium, *model).subsystems[0];
  const VectorXd& q = equilibrium.q[0];
  const auto accelerate = [&](const VectorXd& moved, const VectorXd& v) {
    steady::SubsystemResponse response;
    model->evaluate(0, {moved, v, moved, v}, model->no_offset(), response);
    return model->accelerations(0);
  };
  const Index n = q.size();
  const VectorXd still = VectorXd::Zero(n);
  MatrixXd by_q(n, n), by_v(n, n);
  for (Index k = 0; k < n; ++k) {
    const VectorXd step = 1e-6 * VectorXd::Unit(n, k);
    by_q.col(k) = (accelerate(q + step, still) - accelerate(q - step, still)) / 2e-6;
    by_v.col(k) = (accelerate(q, step) - accelerate(q, -step)) / 2e-6;
  }
  CHECK((own.K + own.M * by_q).norm() < 1e-7 * own.K.norm());
  CHECK((own.C + own.M * by_v).norm() < 1e-7 * own.C.norm());
  CHECK(own.C.norm() > 1.0);
}

TEST_CASE("bearings: a weight rests where the whole matrix holds it") {
  const Matrix2d K = make_matrix(4e5, 1.5e5, -2.5e5, 1e5);
  const Vector2d weight(40.0 * 3.0, 30.0 * -9.0);
  const Vector2d expected = K.inverse() * weight;
  const std::string by_speed =
      ", speed=[-100,100], stiffness=[[[8e5,0],[-4e5,1e5]],[[0,3e5],[-1e5,1e5]]]";
  for (const std::string& keys : {key_of("stiffness", K), by_speed}) {
    const EquilibriumResult found = solve_equilibrium(make_mass(keys, "[3,-9,0]"));
    const BladeEquilibrium& own = found.blades.at(0);
    CHECK(own.joints.at(0).value == doctest::Approx(expected.x()).epsilon(1e-10));
    CHECK(own.joints.at(1).value == doctest::Approx(expected.y()).epsilon(1e-10));
    CHECK(own.loops.at(0).force.x() == doctest::Approx(-weight.x()).epsilon(1e-10));
    CHECK(own.loops.at(0).force.y() == doctest::Approx(-weight.y()).epsilon(1e-10));
  }
}

TEST_CASE("bearings: small motions have the roots of the quadratic eigenproblem") {
  struct Case {
    Matrix2d K, C;
  };
  for (const Case& c : {Case{make_matrix(4e5, 1e5, -5e4, 3e5), make_matrix(400, 100, -50, 300)},
                        // Circulation that makes a whirl grow.
                        Case{make_matrix(4e5, 9e4, -9e4, 3e5), make_matrix(50, 0, 0, 40)},
                        // Gyroscopic damping alone, and an indefinite stiffness.
                        Case{make_matrix(5e5, 0, 0, 3e5), make_matrix(0, 900, -900, 0)},
                        Case{make_matrix(4e5, 6e5, 1e5, 3e5), make_matrix(90, 0, 0, 0)}}) {
    const auto roots = find_roots(c.K, c.C);
    const ModesResult modes =
        solve_modes(make_mass(key_of("stiffness", c.K) + key_of("damping", c.C)), {.count = 2});
    REQUIRE(roots.size() == 2);
    REQUIRE(modes.modes.size() == 2);
    for (const std::complex<double> root : roots) {
      double off = std::abs(root);
      for (const Mode& mode : modes.modes) off = std::min(off, std::abs(mode.eigenvalue - root));
      CHECK(off < 1e-8 * std::abs(root));
    }
  }
}

/// Returns the roots of a shaft with discs on two bearings, those of bending.
std::vector<std::complex<double>> find_rotor_roots(const std::string& keys) {
  const ModesResult modes =
      solve_modes(parse_scenario(test::make_rotor_on_bearings(keys), "f"), {.count = 7});
  std::vector<std::complex<double>> roots;
  for (const Mode& mode : modes.modes)
    if (mode.kind != "torsion") roots.push_back(mode.eigenvalue);
  return roots;
}

TEST_CASE("bearings: a shaft on cross-coupled bearings has the published frequencies at rest") {
  // Friswell et al., example 4 of section 5.9, by six elements [Hz].
  const double published[] = {11.66259, 14.80139, 33.97000, 49.19360};
  const auto roots = find_rotor_roots(matrix_key("stiffness", 1e6, 5e5, 5e5, 1e6));
  for (std::size_t k = 0; k < 4; ++k)
    CHECK(roots.at(k).imag() / (2.0 * std::numbers::pi) ==
          doctest::Approx(published[k]).epsilon(3e-5));
}

TEST_CASE("bearings: the whirl of a shaft persists where circulation is damping by frequency") {
  // Alike in all directions, with kxy = -kyx = q: at q = c w the whirl at w feels neither.
  const double w = find_rotor_roots(matrix_key("stiffness", 1e6, 0, 0, 1e6)).at(0).imag();
  for (const double share : {0.9, 1.0, 1.1}) {
    const double q = share * 3e3 * w;
    double growth = -1e9;
    for (const std::complex<double> root : find_rotor_roots(
             matrix_key("stiffness", 1e6, q, -q, 1e6) + matrix_key("damping", 3e3, 0, 0, 3e3))) {
      if (root.real() > growth) growth = root.real();
      if (share == 1.0 && std::abs(root.real()) < 1e-3)
        CHECK(root.imag() == doctest::Approx(w).epsilon(1e-9));
    }
    CHECK((share == 1.0 ? std::abs(growth) < 1e-6 * w : (growth > 0.0) == (share > 1.0)));
  }
}

TEST_CASE("bearings: an equilibrium on cross-coupled bearings says that it is not stable") {
  const std::string keys = matrix_key("stiffness", 4e5, 9e4, -9e4, 3e5);
  const EquilibriumResult grows =
      solve_equilibrium(make_mass(keys + matrix_key("damping", 50, 0, 0, 40)));
  REQUIRE(grows.stability.has_value());
  CHECK(grows.stability->motions == SmallMotions::grow);
  const EquilibriumResult decays =
      solve_equilibrium(make_mass(keys + matrix_key("damping", 2000, 0, 0, 2000)));
  CHECK(decays.stability->motions == SmallMotions::decay);
}

TEST_CASE("bearings: matrices of small motions are those of the step, slope by speed included") {
  // A rotor on a torsion spring, so that its speed counts, under a weight that opens the bearing.
  Scenario scenario = parse_scenario(
      test::make_sliding_mass(
          ", speed=[-10,10], stiffness=[[[3e5,1e5],[-2e5,1e5]],[[5e5,2e5],[-3e5,2e5]]], "
          "damping=[[[30,1],[2,40]],[[50,0],[-9,60]]]",
          {0, 0}, {0, 0}, 1.0, 0.3, "[3,-9,0]"),
      "f");
  spatial::JointCoordinate& spin = scenario.space->subsystems[0].joints[2].joint.coordinates[0];
  spin.initial_speed = 0.0;
  spin.stiffness = 700.0;
  check_linear_bearing(scenario);
}

}  // namespace
}  // namespace spoke
