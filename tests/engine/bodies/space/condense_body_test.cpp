#include "engine/bodies/kinds/beam/condense_body.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>

#include "engine/bodies/kernels/space/dense_body.h"
#include "tests/engine/bodies/space/bodies.h"

// Within the namespace: the plane's types have the same names.
namespace spoke::space::test {
namespace {

/// A body's equations as full matrices.
struct Dense {
  Eigen::MatrixXd mass;
  Eigen::VectorXd force;
  std::vector<Eigen::MatrixXd> J;

  Dense(const TestBody& test, const BlockFactors& factors) {
    const int n = dense_size(test.body);
    mass.resize(n, n);
    force.resize(n);
    calc_dense_mass(test.body, test.terms, test.work, make_dense_elastic_block(test.body, factors),
                    mass);
    calc_dense_force(test.body, test.terms, test.work, force);
    for (std::size_t h = 0; h < test.body.handles.size(); ++h) {
      J.emplace_back(kTwist, n);
      calc_handle_jacobian(test.body, static_cast<int>(h), test.work, J.back());
    }
  }
};

void check_agreement(TestBody& test, bool implicit, std::mt19937& random, double tolerance) {
  test.calc_terms();
  const Dense dense(test, implicit ? kImplicit : kExplicit);
  condense_body(test.model, test.terms, test.motion.w, implicit, test.work);
  const int n = static_cast<int>(test.body.handles.size());
  std::vector<Twist> wrenches;
  Eigen::VectorXd right = dense.force;
  for (int h = 0; h < n; ++h) {
    wrenches.push_back(make_twist(draw_vector(9.0, random), draw_vector(9.0, random)));
    right += dense.J[static_cast<std::size_t>(h)].transpose() * wrenches.back();
  }
  // More digits leave only the errors of the kernels.
  using Matrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
  const Matrix mass = dense.mass.cast<long double>();
  const Vector solution = mass.ldlt().solve(Vector(right.cast<long double>()));
  const Eigen::VectorXd expected = solution.cast<double>();
  Eigen::VectorXd a(test.body.coordinates());
  const Twist X = recover_body(test.model, wrenches.data(), implicit, test.work, a.data());
  const double scale = expected.lpNorm<Eigen::Infinity>();
  CHECK((X - expected.head<kTwist>()).lpNorm<Eigen::Infinity>() < tolerance * scale);
  CHECK((a - expected.tail(a.size())).lpNorm<Eigen::Infinity>() < tolerance * scale);

  // The ports: accelerations of the handles by the wrenches on them.
  for (int h = 0; h < n; ++h) {
    const auto& J = dense.J[static_cast<std::size_t>(h)];
    const Twist acceleration = J * expected + test.work.handles[h].bias(test.motion.w);
    Twist found = test.work.port.free[h];
    for (int b = 0; b < n; ++b) {
      const Twist& f = wrenches[static_cast<std::size_t>(b)];
      if (b == h)
        found += test.work.port.diagonal[h] * f;
      else if (h < b)
        found += test.work.port.between(h, b) * f;
      else
        found += test.work.port.between(b, h).transpose() * f;
    }
    CHECK((found - acceleration).norm() < tolerance * scale);
  }
}

}  // namespace

TEST_CASE("condensing a body and recovering it solves its full equations") {
  std::mt19937 random(31);
  for (const BeamOptions& options : kStraightAndBent)
    for (const ReferenceFrame frame : {ReferenceFrame::clamped, ReferenceFrame::chord})
      for (const int elements : {1, 2, 4, 7})
        for (const bool implicit : {false, true}) {
          CAPTURE(elements);
          CAPTURE(implicit);
          const auto test = make_random_body(options, elements, frame, random);
          // A part of the relative precision that grows as E^3 is lost, as with a full matrix.
          check_agreement(*test, implicit, random, 3e-13 + 1.5e-14 * std::pow(elements, 3));
        }
}

TEST_CASE("a body whose directions do not meet solves its full equations, too") {
  std::mt19937 random(33);
  for (const ReferenceFrame frame : {ReferenceFrame::clamped, ReferenceFrame::chord})
    for (const int elements : {1, 2, 4, 7})
      for (const bool implicit : {false, true}) {
        CAPTURE(elements);
        CAPTURE(implicit);
        const auto test = make_decoupled_body(elements, frame, random);
        REQUIRE(test->body.is_decoupled);
        check_agreement(*test, implicit, random, 3e-13 + 1.5e-14 * std::pow(elements, 3));
      }
}

TEST_CASE("the terms of a body whose directions do not meet are those of any other") {
  std::mt19937 random(34);
  for (const ReferenceFrame frame : {ReferenceFrame::clamped, ReferenceFrame::chord}) {
    const auto test = make_decoupled_body(4, frame, random);
    const Eigen::VectorXd force = test->deformation_force();
    const BodyTerms terms = test->terms;
    test->body.is_decoupled = test->body.is_straight = false;
    const double scale = force.lpNorm<Eigen::Infinity>();
    CHECK((test->deformation_force() - force).lpNorm<Eigen::Infinity>() < 1e-13 * scale);
    CHECK((test->terms.Q - terms.Q).lpNorm<Eigen::Infinity>() < 1e-13 * scale);
    CHECK((test->terms.Theta - terms.Theta).norm() < 1e-14 * terms.Theta.norm());
    CHECK((test->terms.stiffening.rate - terms.stiffening.rate).norm() <
          1e-13 * terms.stiffening.rate.norm());
  }
}

TEST_CASE("twisted and bent bodies have directions that meet") {
  std::mt19937 random(35);
  for (const BeamOptions& options : kStraightAndBent)
    CHECK_FALSE(make_random_body(options, 3, ReferenceFrame::clamped, random)->body.is_decoupled);
}

TEST_CASE("a body is condensed with children at its root, and with several at one node") {
  std::mt19937 random(36);
  for (const ReferenceFrame frame : {ReferenceFrame::clamped, ReferenceFrame::chord}) {
    const Beam beam = make_random_beam({true, true, true}, random);
    TestBody test(
        make_beam_body(beam, make_unequal_stations(beam, 3, random), frame, {0, 3, 0, 1, 0, 3}));
    randomize_state(random, test);
    check_agreement(test, false, random, 1e-12);
  }
}

TEST_CASE("a kernel's work depends on nothing that was in its memory before") {
  std::mt19937 random(32);
  const auto test = make_random_body({true, true, true}, 3, ReferenceFrame::clamped, random);
  const auto run = [&] {
    test->calc_terms();
    condense_body(test->model, test->terms, test->motion.w, false, test->work);
    const std::vector<Twist> wrenches(test->body.handles.size(), Twist::Ones());
    Eigen::VectorXd a(test->body.coordinates());
    recover_body(test->model, wrenches.data(), false, test->work, a.data());
    return a;
  };
  const Eigen::VectorXd first = run();
  test->q *= 2.0;
  run();
  test->q *= 0.5;
  CHECK(run() == first);
}

}  // namespace spoke::space::test
