#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>

#include "tests/engine/bodies/space/bodies.h"

// Small vibrations of a body whose frame turns steadily about the hub's centre, by differences of
// its right-hand side about the steady state.

namespace spoke::space::test {
namespace {

/// Makes a beam of unit mass, length and bending stiffness; stretching, torsion and rotary inertia
/// as given.
std::unique_ptr<TestBody> make_unit_beam(int elements, double torsion_stiffness,
                                         const Position& inertia) {
  SectionProperties section{1.0, 1e7, 1.0, 1.0, 0.0, torsion_stiffness};
  section.lag_inertia = inertia.y();
  section.flap_inertia = inertia.z();
  return std::make_unique<TestBody>(make_beam_body(make_uniform_beam(section, 1.0),
                                                   equal_stations(0.0, 1.0, elements),
                                                   ReferenceFrame::clamped, {0, elements}));
}

Eigen::MatrixXd slope(TestBody& test, Eigen::VectorXd& x, double step) {
  Eigen::MatrixXd result(x.size(), x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const double value = x[i];
    const auto force = [&](double shift) {
      x[i] = value + shift;
      test.follow();
      return test.deformation_force();
    };
    result.col(i) = (force(step) - force(-step)) / (2.0 * step);
    x[i] = value;
  }
  test.follow();
  return result;
}

/// Turns the body, lets it stretch to its steady state, and returns its frequencies [rad/s].
std::vector<double> find_frequencies(TestBody& test, const Angular& w) {
  test.motion.w = test.motion.hub_w = w;
  test.q.setZero();
  test.v.setZero();
  test.follow();
  // Q_f is of second degree at most in q, and mostly linear: two steps of Newton's method suffice.
  for (int i = 0; i < 2; ++i)
    test.q -= slope(test, test.q, 1e-3).lu().solve(test.deformation_force());
  const auto n = test.q.size();
  const Eigen::MatrixXd M = to_dense(test.body, test.body.M);
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  A.topRightCorner(n, n).setIdentity();
  A.bottomLeftCorner(n, n) = M.ldlt().solve(slope(test, test.q, 1e-3));
  A.bottomRightCorner(n, n) = M.ldlt().solve(slope(test, test.v, 1e-3));
  std::vector<double> frequencies;
  const Eigen::VectorXcd values = A.eigenvalues();
  for (const std::complex<double>& value : values)
    if (value.imag() > 0.0) frequencies.push_back(value.imag());
  std::sort(frequencies.begin(), frequencies.end());
  return frequencies;
}

/// Returns the deviation of the nearest frequency from a value, relative to it.
double deviation(const std::vector<double>& frequencies, double value) {
  double least = 1e300;
  for (const double frequency : frequencies)
    least = std::min(least, std::abs(frequency / value - 1.0));
  return least;
}

}  // namespace

// The rotating cantilever without a hub, Euler-Bernoulli: A. D. Wright, C. E. Smith, R. W.
// Thresher, J. L. C. Wang, J. Appl. Mech. 49, 1982; D. H. Hodges, M. J. Rutkowski, AIAA J. 19,
// 1981. They give flap; lag^2 = flap^2 - speed^2. These digits are a Galerkin solution by
// Legendre's polynomials.
TEST_CASE("a turning spatial body vibrates in flap and lag as the rotating cantilever does") {
  struct Reference {
    double speed;
    std::array<double, 3> flap, lag;
  };
  const std::vector<Reference> references = {
      {0.0, {3.516015, 22.034492, 61.697214}, {3.516015, 22.034492, 61.697214}},
      {4.0, {5.585001, 24.273349, 63.966760}, {3.897723, 23.941501, 63.841573}},
      {12.0, {13.170150, 37.603112, 79.614478}, {5.427049, 35.636976, 78.704925}}};
  const auto test = make_unit_beam(12, 1e4, {0.0, 1e-7, 1e-7});
  for (const Reference& reference : references) {
    CAPTURE(reference.speed);
    // About z, v is lag and w is flap; about y the other way round: the same frequencies.
    for (const Angular& axis : {Angular(0.0, 0.0, 1.0), Angular(0.0, 1.0, 0.0)}) {
      const std::vector<double> found = find_frequencies(*test, reference.speed * axis);
      for (std::size_t mode = 0; mode < 3; ++mode) {
        // The element's own error is (k l)^4 / 1440; that of the stretched steady state less.
        CHECK(deviation(found, reference.flap[mode]) < 2e-4);
        CHECK(deviation(found, reference.lag[mode]) < 2e-4);
      }
    }
  }
}

TEST_CASE("rotation stiffens the torsion of a flat section by the propeller moment") {
  // sqrt(W^2 + w0^2 (Iz - Iy)/(Iz + Iy)), W = pi/2 sqrt(GJ/(Iy + Iz)) for length 1; the mesh of
  // eight elements makes W too high by 0.16 %.
  const double GJ = 0.004, flap_inertia = 2e-5, lag_inertia = 2e-4;
  const double W = std::acos(-1.0) / 2.0 * std::sqrt(GJ / (flap_inertia + lag_inertia));
  const auto test = make_unit_beam(8, GJ, {0.0, lag_inertia, flap_inertia});
  for (BeamElement& element : test->body.beam) element.stiffening.torsion.fill(0.0);
  for (const double speed : {0.0, 5.0, 10.0}) {
    const double expected = std::sqrt(W * W + speed * speed * (lag_inertia - flap_inertia) /
                                                  (lag_inertia + flap_inertia));
    CHECK(deviation(find_frequencies(*test, {0.0, 0.0, speed}), expected) < 2e-3);
  }
}

namespace {

/// Zero for whirl of a clamped shaft of unit mass, length and bending stiffness with a frequency in
/// the frame that stands: w'''' + c w'' - whirl^2 w = 0, c = inertia whirl (whirl - 2 speed), and
/// at the end w'' = 0, w''' + c w' = 0.
double calc_whirl_determinant(double whirl, double speed, double inertia) {
  const double c = inertia * whirl * (whirl - 2.0 * speed);
  const double root = std::sqrt(c * c + 4.0 * whirl * whirl);
  const double a = std::sqrt(0.5 * (root - c)), b = std::sqrt(0.5 * (root + c));
  const double slope = a * std::sinh(a) + b * std::sin(b);
  const double bend = a * a * std::cosh(a) + b * b * std::cos(b);
  const double shear = a * a * a * std::sinh(a) - b * b * b * std::sin(b);
  return bend * (bend + c * (std::cosh(a) - std::cos(b))) - slope * (shear + c * slope);
}

double find_whirl(double from, double to, double speed, double inertia) {
  const bool is_positive = calc_whirl_determinant(from, speed, inertia) > 0.0;
  CHECK(is_positive != (calc_whirl_determinant(to, speed, inertia) > 0.0));
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (from + to);
    const bool is_like_from = (calc_whirl_determinant(middle, speed, inertia) > 0.0) == is_positive;
    (is_like_from ? from : to) = middle;
  }
  return from;
}

}  // namespace

TEST_CASE("the rotary inertia of a shaft that spins splits its whirl") {
  // As Rayleigh's shaft in the frame that stands says; the body's frame turns with it. Rotations of
  // sections are linear between the nodes: of what inertia does, up to (k l)^2/12 is missing.
  constexpr double kInertia = 2e-3, kSpeed = 8.0;
  const auto test = make_unit_beam(16, 1.0, {0.0, kInertia, kInertia});
  const std::vector<double> found = find_frequencies(*test, {kSpeed, 0.0, 0.0});
  for (const double sign : {1.0, -1.0})
    for (const double still : {3.5160, 22.0345}) {
      const double whirl = find_whirl(sign * 0.8 * still, sign * 1.2 * still, kSpeed, kInertia);
      CHECK(std::abs(std::abs(whirl) - still) > 5e-3 * still);
      CHECK(deviation(found, std::abs(whirl - kSpeed)) < 5e-4);
    }
}

TEST_CASE("a turning strip without torsional stiffness is held straight by its tension") {
  // Tension w0^2 (1 - x^2)/2 on a twisted strip of gyration k^2 = (Iy + Iz)/A: Legendre's equation,
  // (w/w0)^2 - (Iz - Iy)/(Iz + Iy) = n (2 n - 1) for its functions odd in x: 1, 6, 15.
  const double flap_inertia = 1e-6, lag_inertia = 3e-5;
  const double moment = flap_inertia + lag_inertia, difference = lag_inertia - flap_inertia;
  SectionProperties section{1.0, 1e6, 1e6 * lag_inertia, 1e6 * flap_inertia, 0.0, 1e-9};
  section.lag_inertia = lag_inertia;
  section.flap_inertia = flap_inertia;
  TestBody test(make_beam_body(make_uniform_beam(section, 1.0), equal_stations(0.0, 1.0, 16),
                               ReferenceFrame::clamped, {0, 16}));
  const double speed = 5.0;
  const std::vector<double> found = find_frequencies(test, {0.0, 0.0, speed});
  for (const auto& [expected, tolerance] : {std::pair{1.0, 1e-3}, {6.0, 1e-2}})
    CHECK(deviation(found, speed * std::sqrt(expected + difference / moment)) < tolerance);
}

}  // namespace spoke::space::test
