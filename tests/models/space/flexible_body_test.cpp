#include "models/space/flexible_body.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "models/space/rotation_vector.h"
#include "tests/approx.h"
#include "tests/models/space/beam_equations.h"
#include "tests/models/space/beams.h"

// Within the namespace: the plane's types have the same names.
namespace spoke::space::test {
namespace {

using testing::approx;

const std::vector<BeamOptions> kAllBeams{
    {false, false, false}, {false, true, true}, {true, false, true}, {true, true, true}};

FlexibleBody make_body(const Beam& beam, int elements, ReferenceFrame frame, std::mt19937& random) {
  return make_beam_body(beam, make_unequal_stations(beam, elements, random), frame, {0, elements});
}

/// Returns the nodal forces A q of all coordinates, those that the frame fixes included.
Eigen::VectorXd multiply(const BlockTridiagonal& A, const Eigen::VectorXd& q) {
  Eigen::VectorXd f = Eigen::VectorXd::Zero(q.size());
  for (int k = 0; k < A.nodes(); ++k) {
    const auto at = static_cast<std::size_t>(k);
    f.segment<kTwist>(kTwist * k) += A.diagonal[at] * q.segment<kTwist>(kTwist * k);
    if (k + 1 == A.nodes()) break;
    f.segment<kTwist>(kTwist * (k + 1)) += A.below[at] * q.segment<kTwist>(kTwist * k);
    f.segment<kTwist>(kTwist * k) += A.below[at].transpose() * q.segment<kTwist>(kTwist * (k + 1));
  }
  return f;
}

/// Returns the coordinates of all nodes in a small rigid motion.
Eigen::VectorXd rigid_motion(const FlexibleBody& body, const Position& u, const Position& th) {
  Eigen::VectorXd q(kTwist * body.node_count());
  for (int k = 0; k < body.node_count(); ++k)
    q.segment<kTwist>(kTwist * k) << u + cross(th, body.nodes[static_cast<std::size_t>(k)]), th;
  return q;
}

}  // namespace

TEST_CASE("every coordinate of a spatial body's nodes is counted once, but those the frame fixes") {
  std::mt19937 random(1);
  const Beam beam = make_random_beam({}, random);
  for (const ReferenceFrame frame : {ReferenceFrame::clamped, ReferenceFrame::chord})
    for (const int elements : {1, 2, 5}) {
      const FlexibleBody body = make_body(beam, elements, frame, random);
      std::vector<int> seen(static_cast<std::size_t>(body.coordinates()), 0);
      int fixed = 0;
      for (int node = 0; node <= elements; ++node)
        for (int c = 0; c < kTwist; ++c) {
          const int index = body.coordinate(node, c);
          if (index < 0)
            ++fixed;
          else
            ++seen.at(static_cast<std::size_t>(index));
        }
      CHECK(fixed == 6);
      CHECK(std::count(seen.begin(), seen.end(), 1) == body.coordinates());
    }
}

TEST_CASE(
    "mass, first moment and inertia of a body are those of its curve, however it is divided") {
  std::mt19937 random(2);
  for (const BeamOptions& options : kAllBeams) {
    const Beam beam = make_random_beam(options, random);
    for (const int elements : {1, 3, 8}) {
      CAPTURE(elements);
      const FlexibleBody body = make_body(beam, elements, ReferenceFrame::clamped, random);
      const MassMoments expected = integrate_mass(beam, body.pose);
      CHECK(std::abs(body.mass - expected.mass) < 1e-9 * expected.mass);
      CHECK((body.S0 - expected.first).norm() < 1e-9 * expected.first.norm());
      CHECK((body.J0 - expected.second).norm() < 1e-9 * expected.second.norm());
    }
  }
}

TEST_CASE("a rigid motion costs no force, and has the momenta of a rigid body") {
  std::mt19937 random(3);
  for (const BeamOptions& options : kAllBeams) {
    const FlexibleBody body =
        make_body(make_random_beam(options, random), 4, ReferenceFrame::clamped, random);
    const Position u(0.3, -0.2, 0.5), th(0.2, 0.4, -0.1);
    const Eigen::VectorXd q = rigid_motion(body, u, th);
    double largest = 0.0;
    for (const TwistMatrix& block : body.K.diagonal)
      largest = std::max(largest, block.cwiseAbs().maxCoeff());
    CHECK(multiply(body.K, q).cwiseAbs().maxCoeff() < 1e-14 * largest);
    // 2 T of the motion: m u.u + 2 u.(th x S) + th.Theta th.
    const Matrix3 Theta = body.J0.trace() * Matrix3::Identity() - body.J0;
    const double expected =
        body.mass * u.squaredNorm() + 2.0 * u.dot(cross(th, body.S0)) + th.dot(Theta * th);
    CHECK(q.dot(multiply(body.M, q)) == approx(expected).epsilon(1e-12));
    Position momentum = Position::Zero();
    for (std::size_t k = 0; k < body.C_t.size(); ++k)
      momentum += body.C_t[k].transpose() * q.segment<kTwist>(kTwist * static_cast<int>(k));
    CHECK((momentum - (body.mass * u + cross(th, body.S0))).norm() < 1e-12 * momentum.norm());
  }
}

TEST_CASE("a wrench at the tip deforms any body as the beam's differential equations say") {
  std::mt19937 random(4);
  for (const BeamOptions& options : kAllBeams) {
    const Beam beam = make_random_beam(options, random);
    for (const int elements : {1, 3, 7}) {
      CAPTURE(elements);
      const FlexibleBody body = make_body(beam, elements, ReferenceFrame::clamped, random);
      Twist wrench;
      wrench << 3.0, -2.0, 5.0, 1.0, 0.7, -0.4;
      Eigen::VectorXd force = Eigen::VectorXd::Zero(body.coordinates());
      force.tail<kTwist>() = wrench;
      const Twist found = to_dense(body, body.K).ldlt().solve(force).tail<kTwist>();
      const Twist expected = solve_statics(beam, body.pose, wrench);
      CHECK((found - expected).norm() < 1e-7 * expected.norm());
    }
  }
}

TEST_CASE("damping in proportion to the stiffness by one factor is that part of the stiffness") {
  std::mt19937 random(5);
  Beam beam = make_random_beam({true, false, false}, random);
  for (SectionProperties& section : beam.properties) section.shear_stiffness_y = 0.0;
  beam.damping.setConstant(0.02);
  const FlexibleBody body = make_body(beam, 3, ReferenceFrame::clamped, random);
  const Eigen::MatrixXd K = to_dense(body, body.K);
  CHECK((to_dense(body, body.D) - 0.02 * K).norm() < 1e-9 * K.norm());
}

TEST_CASE("each strain of a straight uniform beam is damped by its own factor") {
  SectionProperties section{1.0, 1e5, 300.0, 100.0, 0.0, 80.0};
  section.lag_inertia = section.flap_inertia = 1e-3;
  Beam beam = make_uniform_beam(section, 2.0);
  beam.damping << 1e-3, 0.0, 0.0, 2e-3, 3e-3, 4e-3;
  const FlexibleBody body =
      make_beam_body(beam, equal_stations(0.0, 2.0, 1), ReferenceFrame::clamped, {0, 1});
  const TwistMatrix &K = body.K.diagonal[1], &D = body.D.diagonal[1];
  CHECK(D(0, 0) == approx(1e-3 * K(0, 0)));
  CHECK(D(3, 3) == approx(2e-3 * K(3, 3)));
  CHECK(D(2, 2) == approx(3e-3 * K(2, 2)));
  CHECK(D(1, 1) == approx(4e-3 * K(1, 1)));
}

TEST_CASE("clamped blades vibrate as a transfer matrix of the beam's equations says") {
  // 16 elements; general sections, twist and offsets, straight and bent, and rigid in shear.
  std::mt19937 random(6);
  for (int kind = 0; kind < 3; ++kind) {
    CAPTURE(kind);
    Beam beam = make_random_beam({kind == 1, kind != 2, false}, random);
    if (kind == 2)
      for (SectionProperties& section : beam.properties)
        section.shear_stiffness_y = section.shear_stiffness_z = 0.0;
    const FlexibleBody body = make_beam_body(beam, equal_stations(0.0, beam.station.back(), 16),
                                             ReferenceFrame::clamped, {0, 16});
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
        to_dense(body, body.K), to_dense(body, body.M), Eigen::EigenvaluesOnly);
    const BeamEquations equations(beam, 800);
    for (int mode = 0; mode < 2; ++mode) {
      const double found = std::sqrt(solver.eigenvalues()[mode]);
      CHECK(std::abs(found / equations.find_frequency(found) - 1.0) < 2e-4);
    }
  }
}

}  // namespace spoke::space::test
