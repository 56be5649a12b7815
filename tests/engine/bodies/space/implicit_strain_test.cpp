#include "engine/bodies/space/implicit_strain.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>
#include <memory>

#include "engine/bodies/space/nonlinear_strain.h"
#include "tests/engine/bodies/space/bodies.h"

namespace spoke::space::test {
namespace {

constexpr int kElements = 8, kMiddle = 4;

/// Makes a slender straight beam of unit length, mass and stiffness with handles in its middle and
/// at its end.
std::unique_ptr<TestBody> make_slender_body() {
  SectionProperties section;
  section.axial_stiffness = 1e7;
  section.flap_stiffness = section.lag_stiffness = section.torsion_stiffness = 1.0;
  section.mass_per_length = 1.0;
  section.flap_inertia = section.lag_inertia = 1e-5;
  Beam beam = make_uniform_beam(section, 1.0);
  beam.is_nonlinear = true;
  return std::make_unique<TestBody>(make_beam_body(
      beam, equal_stations(0.0, 1.0, kElements), ReferenceFrame::clamped, {0, kMiddle, kElements}));
}

/// Returns the coordinates at which a moment about z and a force along x act on the end.
Eigen::VectorXd bend(const TestBody& test, double moment, double force) {
  const FlexibleBody& body = test.body;
  Eigen::VectorXd q = Eigen::VectorXd::Zero(body.coordinates()), load = q;
  load[body.coordinate(kElements, 0)] = force;
  load[body.coordinate(kElements, 5)] = moment;
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(kTwist * body.node_count());
  constexpr int kSteps = 5, kIterations = 8;
  for (int step = 1; step <= kSteps; ++step)
    for (int k = 0; k < kIterations; ++k) {
      Eigen::VectorXd nodal = still, forces = still, rest(q.size()), scratch(3 * kElements);
      expand(body, q.data(), nodal.data());
      const NodalMotion at{nodal.data(), still.data()};
      subtract_strain_forces(body, 0.0, at, at, scratch.data(), forces.data());
      compress(body, forces.data(), rest.data());
      rest += load * step / kSteps;
      const Eigen::MatrixXd K = calc_strain_matrices(body, 0.0, nodal.data()).stiffness;
      q += K.partialPivLu().solve(rest);
    }
  CHECK(q[body.coordinate(kElements, 5)] > 0.9 * moment);
  return q;
}

ImplicitStrain follow(const TestBody& test, const Eigen::VectorXd& q, double gain) {
  ImplicitStrain strain =
      make_implicit_strain(test.body, {1.0, gain, 0.0}, gain, make_elastic_block(test.body, {}));
  keep_wrenches(test.body, q.data(), strain);
  follow_strain(test.body, q.data(), test.work, strain);
  return strain;
}

/// Returns S over the flex vector.
Eigen::MatrixXd make_dense_shift(const FlexibleBody& body, const ImplicitShift& shift) {
  const Eigen::Index n = body.coordinates();
  Eigen::MatrixXd S(n, n);
  Eigen::VectorXd nodal(kTwist * body.node_count());
  for (Eigen::Index i = 0; i < n; ++i) {
    expand(body, Eigen::VectorXd::Unit(n, i).eval().data(), nodal.data());
    shift.apply(nodal.data());
    compress(body, nodal.data(), S.col(i).data());
  }
  return S;
}

/// Returns the inverse of Mhat.
Eigen::MatrixXd invert_left(const FlexibleBody& body, const ImplicitStrain& strain) {
  const Eigen::MatrixXd S = make_dense_shift(body, strain.shift);
  return S * (to_dense(body, body.M) + to_dense(body, strain.added)).inverse() * S.transpose();
}

}  // namespace

TEST_CASE(
    "the left-hand side is nearly the tangent of a body bent by half a radian, also pressed") {
  const auto test = make_slender_body();
  const FlexibleBody& body = test->body;
  for (const double gain : {5e-6, 1e-4})
    for (const double force : {0.0, -1.0}) {
      CAPTURE(gain);
      CAPTURE(force);
      const Eigen::VectorXd q = bend(*test, 0.5, force);
      const ImplicitStrain strain = follow(*test, q, gain);
      Eigen::VectorXd nodal(kTwist * body.node_count());
      expand(body, q.data(), nodal.data());
      const Eigen::MatrixXd right =
          to_dense(body, body.M) + gain * calc_strain_matrices(body, 0.0, nodal.data()).stiffness;
      // What a pass leaves of an error: what places along the elements have of psi, and the shift
      // of masses, remain.
      const Eigen::MatrixXd left =
          Eigen::MatrixXd::Identity(q.size(), q.size()) - invert_left(body, strain) * right;
      CHECK(left.eigenvalues().cwiseAbs().maxCoeff() < 0.25);
    }
}

TEST_CASE("handles within a bent body move by its left-hand side") {
  const auto test = make_slender_body();
  const FlexibleBody& body = test->body;
  const ImplicitStrain strain = follow(*test, bend(*test, 0.5, 0.0), 5e-6);
  const Eigen::MatrixXd inverse = invert_left(body, strain);
  const auto at = [&](int a, int b) -> Eigen::MatrixXd {
    return inverse.block<kTwist, kTwist>(body.coordinate(a, 0), body.coordinate(b, 0));
  };
  const auto check = [](const Eigen::MatrixXd& found, const Eigen::MatrixXd& expected) {
    CHECK((found - expected).norm() < 1e-9 * expected.norm());
  };
  check(strain.block.Z_diagonal[1].matrix(), at(kMiddle, kMiddle));
  check(strain.block.Z_diagonal[2].matrix(), at(kElements, kElements));
  const int pair = tree::MultiPort<Space>::count_pairs(2) + 1;
  check(strain.block.Z_pairs[static_cast<std::size_t>(pair)], at(kMiddle, kElements));
}

TEST_CASE("the left-hand side of a body that its pressure would buckle is positive definite") {
  const auto test = make_slender_body();
  Eigen::VectorXd q = Eigen::VectorXd::Zero(test->body.coordinates());
  for (int k = 1; k <= kElements; ++k) q[test->body.coordinate(k, 0)] = -1e-6 * k;
  const ImplicitStrain strain = follow(*test, q, 1.0);
  const Eigen::MatrixXd inverse = invert_left(test->body, strain);
  CHECK(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(inverse).eigenvalues().minCoeff() > 0.0);
  CHECK(strain.turn.isZero(0.0));
}

}  // namespace spoke::space::test
