#include "models/plane/beam_elements.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tests/approx.h"

using namespace spoke;
using spoke::testing::approx;

namespace {

plane::BeamProperties beam(int elements, ReferenceFrame frame) {
  return {2.0, elements, 0.2, 5e6, 566.0, frame};
}

/// Returns H from its rows.
Eigen::MatrixXd coupling_from_rows(const plane::FlexibleBody& body) {
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(body.axial(), body.bending());
  for (int i = 0; i < body.axial(); ++i)
    for (int k = 0; k < plane::AxialBendingCoupling::kWidth; ++k) {
      const int column = 2 * i + body.H.offset + k;
      const double value = body.H.rows[i * plane::AxialBendingCoupling::kWidth + k];
      if (column >= 0 && column < body.bending())
        H(i, column) = value;
      else
        CHECK(value == 0.0);
    }
  return H;
}

Eigen::MatrixXd coupling_from_pairs(const plane::FlexibleBody& body) {
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(body.axial(), body.bending());
  for (int k = 0; k < body.axial(); ++k)
    for (int m = 0; m < plane::AxialBendingCoupling::kHeight; ++m)
      for (int side = 0; side < 2; ++side) {
        const int row = k - 2 + m;
        const double value =
            body.H.pairs[2 * (plane::AxialBendingCoupling::kHeight * k + m) + side];
        if (row >= 0 && row < body.axial())
          H(row, 2 * k + side) = value;
        else
          CHECK(value == 0.0);
      }
  return H;
}

/// A speed of rotation and the frequencies of the first lag modes, both times L^2 sqrt(rhoA/EI).
struct RotatingBeam {
  double speed;
  std::array<double, 3> frequencies;
};

/// Returns the first frequencies of bending of a clamped body that turns about its frame's origin,
/// times L^2 sqrt(rhoA/EI) as is `speed`: of K + w^2 (KG - M) against M, since the axis across the
/// body turns with it.
Eigen::Vector3d lag_frequencies(int elements, double speed) {
  const plane::BeamProperties properties = beam(elements, ReferenceFrame::clamped);
  const plane::FlexibleBody body = make_beam_body(properties);
  const double unit = std::sqrt(properties.bending_stiffness / properties.mass_per_length) /
                      (properties.length * properties.length);
  const double w = speed * unit;
  const Eigen::MatrixXd M = body.M_bending.to_dense();
  const Eigen::MatrixXd KG = make_centrifugal_stiffness(properties, 0.0, 0.0).to_dense();
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      body.K_bending.to_dense() + w * w * (KG - M), M, Eigen::EigenvaluesOnly);
  return solver.eigenvalues().head<3>().cwiseSqrt() / unit;
}

}  // namespace

TEST_CASE("every node's coordinates are counted once, but those the frame fixes") {
  for (const ReferenceFrame frame : {ReferenceFrame::clamped, ReferenceFrame::chord})
    for (const int elements : {1, 2, 5}) {
      const plane::FlexibleBody body = make_beam_body(beam(elements, frame));
      std::vector<int> seen(body.coordinates(), 0);
      int fixed = 0;
      for (int node = 0; node <= elements; ++node)
        for (int c = 0; c < kTwist; ++c) {
          const int index = body.coordinate(node, c);
          if (index < 0)
            ++fixed;
          else
            ++seen.at(index);
        }
      CHECK(fixed == 3);
      CHECK(std::count(seen.begin(), seen.end(), 1) == body.coordinates());
    }
}

TEST_CASE("integrals of a body are those of a uniform bar") {
  for (const ReferenceFrame frame : {ReferenceFrame::clamped, ReferenceFrame::chord})
    for (const int elements : {1, 2, 5}) {
      const plane::FlexibleBody body = make_beam_body(beam(elements, frame));
      CHECK(body.mass == approx(0.4));
      CHECK(body.S0.x() == approx(0.4));
      CHECK(body.I0 == approx(0.4 * 4.0 / 3.0));
      // A uniform stretch u = x moves as s0 does: S u = S0, d0 . u = I0, Mff u = d0, u.Mff u = I0.
      const Eigen::VectorXd u = Eigen::VectorXd::LinSpaced(elements, 2.0 / elements, 2.0);
      CHECK(body.S_axial.head(elements).dot(u) == approx(body.S0.x()));
      CHECK(body.d_axial.head(elements).dot(u) == approx(body.I0));
      CHECK((body.M_axial.to_dense() * u - body.d_axial.head(elements)).norm() < 1e-14);
    }
}

TEST_CASE("a clamped body that turns as a whole has the inertia of a bar and no strain") {
  const plane::FlexibleBody body = make_beam_body(beam(5, ReferenceFrame::clamped));
  // v = x, psi = 1 at every node but the frame's, where the first element bends instead.
  Eigen::VectorXd q(body.bending());
  for (int node = 1; node <= 5; ++node) {
    q[2 * (node - 1)] = 0.4 * node;
    q[2 * (node - 1) + 1] = 1.0;
  }
  const Eigen::VectorXd force = body.K_bending.to_dense() * q;
  CHECK(force.tail(body.bending() - 4).norm() < 1e-9 * body.K_bending.to_dense().norm());
}

TEST_CASE("a tip force bends a body as a cantilever, a chord body as a beam on two supports") {
  const double EI = 566.0, L = 2.0;
  const plane::FlexibleBody clamped = make_beam_body(beam(4, ReferenceFrame::clamped));
  Eigen::VectorXd force = Eigen::VectorXd::Zero(8);
  force[6] = 1.0;
  const Eigen::VectorXd q = clamped.K_bending.to_dense().ldlt().solve(force);
  CHECK(q[6] == approx(L * L * L / (3.0 * EI)));
  CHECK(q[7] == approx(L * L / (2.0 * EI)));

  const plane::FlexibleBody chord = make_beam_body(beam(4, ReferenceFrame::chord));
  force.setZero();
  force[3] = 1.0;  // v of the middle node
  const Eigen::VectorXd p = chord.K_bending.to_dense().ldlt().solve(force);
  CHECK(p[3] == approx(L * L * L / (48.0 * EI)));
  CHECK(p[0] == approx(L * L / (16.0 * EI)));
  CHECK(p[7] == approx(-L * L / (16.0 * EI)));
}

TEST_CASE("both storages of the axial-bending coupling agree, and with its integral") {
  for (const ReferenceFrame frame : {ReferenceFrame::clamped, ReferenceFrame::chord})
    for (const int elements : {1, 2, 3, 6}) {
      const plane::FlexibleBody body = make_beam_body(beam(elements, frame));
      const Eigen::MatrixXd H = coupling_from_rows(body);
      CHECK((H - coupling_from_pairs(body)).norm() == 0.0);
      // A uniform stretch u = x: H^T u = int rhoA x N_v dx = c0.
      const Eigen::VectorXd u = Eigen::VectorXd::LinSpaced(elements, 2.0 / elements, 2.0);
      CHECK((H.transpose() * u - body.c_bending).norm() < 1e-14);
    }
}

TEST_CASE("the centrifugal stiffness of a deflected blade is its tension times the slope squared") {
  // v = x from the frame on needs a slope at the frame: compare quadratic forms of v = x^2.
  const plane::BeamProperties properties = beam(6, ReferenceFrame::clamped);
  const double distance = 0.7, outboard = 1.3, rhoA = 0.2, L = 2.0;
  const plane::SymmetricBand<3> KG = make_centrifugal_stiffness(properties, distance, outboard);
  Eigen::VectorXd q(12);
  for (int node = 1; node <= 6; ++node) {
    const double x = L * node / 6;
    q[2 * (node - 1)] = x * x;
    q[2 * (node - 1) + 1] = 2.0 * x;
  }
  // int (2 x)^2 [rhoA ((L^2 - x^2)/2 + distance (L - x)) + outboard] dx
  const double expected = 4.0 * (rhoA * (std::pow(L, 5) / 6 - std::pow(L, 5) / 10 +
                                         distance * (std::pow(L, 4) / 3 - std::pow(L, 4) / 4)) +
                                 outboard * L * L * L / 3);
  CHECK(q.dot(KG.to_dense() * q) == approx(expected));
}

// The rotating cantilever without a hub, Euler-Bernoulli: A. D. Wright, C. E. Smith, R. W.
// Thresher, J. L. C. Wang, "Vibration Modes of Centrifugally Stiffened Beams", J. Appl. Mech. 49,
// 1982; D. H. Hodges, M. J. Rutkowski, AIAA J. 19, 1981. They give flap, out of the plane: lag^2 =
// flap^2 - speed^2. These eight digits are a solution of the eigenvalue problem independent of
// Spoke.
TEST_CASE("a turning clamped body vibrates in lag as the rotating cantilever does") {
  const std::vector<RotatingBeam> references = {
      {0.0, {3.5160153, 22.034492, 61.697214}},  {2.0, {3.621797, 22.526311, 62.241059}},
      {4.0, {3.8977225, 23.941501, 63.841573}},  {6.0, {4.2632254, 26.129042, 66.413436}},
      {8.0, {4.6571496, 28.908873, 69.836241}},  {10.0, {5.0489749, 32.119686, 73.976464}},
      {12.0, {5.4270493, 35.636976, 78.704925}},
  };
  // The element is stiffer than the beam: its frequencies are too high by (k l)^4 / 1440 of
  // themselves, k the wave number, l = L/16; that is 4.0e-5 for the third mode at rest, k L =
  // 7.8548, and at no speed is a mode further off. With twice the elements the error is 16 times
  // smaller, and both extrapolate to the reference in all its digits.
  const double tolerance = std::pow(7.8548 / 16, 4) / 1440;
  for (const RotatingBeam& reference : references) {
    CAPTURE(reference.speed);
    const Eigen::Vector3d expected(reference.frequencies.data());
    const Eigen::Vector3d coarse = lag_frequencies(16, reference.speed);
    const Eigen::Vector3d fine = lag_frequencies(32, reference.speed);
    const Eigen::Array3d excess = coarse.array() / expected.array() - 1.0;
    const Eigen::Array3d rest = (16.0 * fine - coarse).array() / 15.0 / expected.array() - 1.0;
    CHECK(excess.minCoeff() > 0.0);
    CHECK(excess.maxCoeff() < tolerance);
    CHECK(rest.abs().maxCoeff() < 1e-7);
  }
}
