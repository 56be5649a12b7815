#include "engine/bodies/space/implicit_tension.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>

#include "engine/bodies/kernels/space/dense_body.h"
#include "tests/engine/bodies/space/bodies.h"

namespace spoke::space::test {
namespace {

constexpr double kGain = 3e-4;

/// Makes a body that the rotation of its hub pulls everywhere: it points outward, with all that it
/// carries.
std::unique_ptr<TestBody> make_pulled_body(const char* kind, int elements, ReferenceFrame frame,
                                           std::mt19937& random) {
  const bool is_decoupled = kind == std::string("decoupled");
  auto test = is_decoupled ? make_decoupled_body(elements, frame, random)
                           : make_random_body({kind == std::string("bent"), true, true}, elements,
                                              frame, random);
  test->tension.R_HB = exponential(draw_vector(0.2, random));
  test->tension.origin = Position(2.0, 0.1, -0.2);
  for (CarriedMass& carried : test->tension.carried)
    carried.moment = Position(9.0, 0.4, -0.5) + draw_vector(0.3, random);
  return test;
}

constexpr const char* kKinds[] = {"decoupled", "straight", "bent"};

/// A speed that rounding leaves as it is.
const Angular kSpeed(2.0, -8.0, 24.0);

ImplicitTension make_tension(const TestBody& test, const Angular& w) {
  ImplicitTension tension =
      make_implicit_tension(test.body, test.tension, kImplicit, kGain, test.blocks[1]);
  follow_speed(test.body, test.tension, w, tension);
  return tension;
}

/// Returns the rows of the work of a body for its coordinates only: by C_w^T and the force.
Eigen::MatrixXd take_rows(const TestBody& test) {
  Eigen::MatrixXd rows(test.body.coordinates(), 4);
  for (int k = 0; k < test.body.node_count(); ++k)
    for (int c = 0; c < kTwist; ++c)
      if (const int at = test.body.coordinate(k, c); at >= 0)
        for (int i = 0; i < 4; ++i) rows(at, i) = test.work.rows[kNodeRows * k + 4 * c + i];
  return rows;
}

/// Terms that tension adds to the equations of a body in [rotation of the frame; deformation].
struct Added {
  Eigen::MatrixXd mass;
  Eigen::VectorXd force;
};

Added find_added(TestBody& test, const ImplicitTension& tension, const Eigen::VectorXd& y) {
  test.calc_terms();
  const BodyTerms before = test.terms;
  const Eigen::MatrixXd rows = take_rows(test);
  const Eigen::VectorXd a = y.tail(test.body.coordinates());
  add_implicit_tension(test.body, tension, a.data(), y.head<3>(), test.work, test.terms);
  const Eigen::MatrixXd change = take_rows(test) - rows;
  const Eigen::Index n = change.rows();
  Added added{Eigen::MatrixXd::Zero(3 + n, 3 + n), Eigen::VectorXd(3 + n)};
  added.mass.topLeftCorner<3, 3>() = test.terms.Theta - before.Theta;
  added.mass.bottomLeftCorner(n, 3) = change.leftCols<3>();
  added.mass.topRightCorner(3, n) = change.leftCols<3>().transpose();
  add_dense(test.body, tension.stiffness, added.mass.bottomRightCorner(n, n));
  added.force << angular(test.terms.Q) - angular(before.Q), change.col(3);
  CHECK(linear(test.terms.Q) == linear(before.Q));
  return added;
}

/// Returns beta' h^2 K by the energy, which is a quadratic form.
Eigen::MatrixXd make_expected(const TestBody& test, const Angular& w) {
  const Eigen::Index n = 3 + test.body.coordinates();
  const auto form = [&](const Eigen::VectorXd& y) {
    return kGain * calc_tension_form(test, w, y.head<3>(), y.tail(n - 3));
  };
  Eigen::MatrixXd K(n, n);
  const Eigen::MatrixXd unit = Eigen::MatrixXd::Identity(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      K(i, j) = 0.25 * (form(unit.col(i) + unit.col(j)) - form(unit.col(i) - unit.col(j)));
  return K;
}

}  // namespace

TEST_CASE("tension on the left-hand side is that of slopes of frame and deformation together") {
  std::mt19937 random(81);
  for (const char* kind : kKinds)
    for (const ReferenceFrame frame : {ReferenceFrame::clamped, ReferenceFrame::chord})
      for (const int elements : {1, 2, 4}) {
        CAPTURE(std::string(kind));
        CAPTURE(elements);
        const auto test = make_pulled_body(kind, elements, frame, random);
        const ImplicitTension tension = make_tension(*test, kSpeed);
        REQUIRE(tension.w == kSpeed);
        const Eigen::MatrixXd expected = make_expected(*test, kSpeed);
        const double scale = expected.norm();
        REQUIRE(scale > 0.0);
        const Eigen::VectorXd y = Eigen::VectorXd::Random(expected.rows());
        const Added added = find_added(*test, tension, y);
        CHECK((added.mass - expected).norm() < 1e-10 * scale);
        CHECK((added.mass - added.mass.transpose()).norm() < 1e-12 * scale);
        CHECK((added.force - expected * y).norm() < 1e-10 * scale * y.norm());
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(added.mass);
        CHECK(solver.eigenvalues().minCoeff() > -1e-10 * scale);
      }
}

TEST_CASE("of a uniform beam from the axis on, tension adds w^2 m L^3/3 to its frame's rotation") {
  // The tension is T = w^2 m (L^2 - s^2)/2, whose integral this is.
  SectionProperties section;
  section.axial_stiffness = 900.0;
  section.flap_stiffness = section.lag_stiffness = 3.0;
  section.torsion_stiffness = 2.0;
  section.mass_per_length = 1.7;
  section.lag_inertia = section.flap_inertia = 0.1;  // Mhat is definite
  const double L = 2.5, w = 8.0;
  for (const int elements : {1, 3, 8}) {
    const Beam beam = make_uniform_beam(section, L);
    std::vector<double> stations;
    for (int k = 0; k <= elements; ++k) stations.push_back(L * k / elements);
    TestBody test(make_beam_body(beam, stations, ReferenceFrame::clamped, {0, elements}));
    const ImplicitTension tension = make_tension(test, Angular(0.0, 0.0, w));
    const double expected = kGain * w * w * section.mass_per_length * L * L * L / 3.0;
    CHECK(tension.turn(1, 1) == doctest::Approx(expected).epsilon(1e-10));
    CHECK(tension.turn(2, 2) == doctest::Approx(expected).epsilon(1e-10));
    CHECK(std::abs(tension.turn(0, 0)) < 1e-12 * expected);
  }
}

TEST_CASE("a body with tension on the left-hand side is condensed as its full equations say") {
  std::mt19937 random(82);
  for (const char* kind : kKinds)
    for (const ReferenceFrame frame : {ReferenceFrame::clamped, ReferenceFrame::chord})
      for (const int elements : {1, 4}) {
        CAPTURE(std::string(kind));
        CAPTURE(elements);
        const auto test = make_pulled_body(kind, elements, frame, random);
        ImplicitTension tension = make_tension(*test, Angular(2.0, 5.0, -7.0));
        follow_speed(test->body, test->tension, 2.0 * kSpeed, tension);  // nothing stays of it
        const Eigen::VectorXd before = Eigen::VectorXd::Random(test->body.coordinates());
        test->calc_terms();
        add_implicit_tension(test->body, tension, before.data(), draw_vector(2.0, random),
                             test->work, test->terms);
        Eigen::MatrixXd elastic = make_dense_elastic_block(test->body, kImplicit);
        add_dense(test->body, tension.stiffness, elastic);
        const int n = dense_size(test->body);
        Eigen::MatrixXd mass(n, n), J(kTwist, n);
        Eigen::VectorXd force(n);
        calc_dense_mass(test->body, test->terms, test->work, elastic, mass);
        calc_dense_force(test->body, test->terms, test->work, force);
        std::vector<Twist> wrenches;
        for (std::size_t h = 0; h < test->body.handles.size(); ++h) {
          wrenches.push_back(make_twist(draw_vector(9.0, random), draw_vector(9.0, random)));
          calc_handle_jacobian(test->body, static_cast<int>(h), test->work, J);
          force += J.transpose() * wrenches.back();
        }
        const Eigen::VectorXd expected = mass.ldlt().solve(force);
        test->model.blocks[1] = &tension.block;
        condense_body(test->model, test->terms, test->motion.w, true, test->work);
        Eigen::VectorXd a(test->body.coordinates());
        const Twist X = recover_body(test->model, wrenches.data(), true, test->work, a.data());
        const double scale = expected.lpNorm<Eigen::Infinity>();
        CHECK((X - expected.head<kTwist>()).lpNorm<Eigen::Infinity>() < 1e-9 * scale);
        CHECK((a - expected.tail(a.size())).lpNorm<Eigen::Infinity>() < 1e-9 * scale);
      }
}

TEST_CASE("tension is made anew only where the hub's speed has come to another of 32 an octave") {
  std::mt19937 random(83);
  const auto test = make_pulled_body("bent", 3, ReferenceFrame::clamped, random);
  ImplicitTension tension = make_tension(*test, Angular(0.0, 0.0, 33.0));
  CHECK(tension.w == Angular(0.0, 0.0, 33.0));
  const std::vector<double> block = tension.block.inverse;
  const auto follow = [&](const Angular& w) {
    follow_speed(test->body, test->tension, w, tension);
    return tension.w;
  };
  for (const double speed : {33.0, 32.6, 33.4, 33.0}) {
    CHECK(follow({0.1, -0.3, speed}) == Angular(0.0, 0.0, 33.0));
    CHECK(tension.block.inverse == block);
  }
  CHECK(follow({0.1, -0.3, 33.6}) == Angular(0.0, 0.0, 34.0));
  CHECK(tension.block.inverse != block);
  CHECK(follow({-65.0, 0.9, 15.2}) == Angular(-66.0, 0.0, 16.0));
  // A speed makes the same, whatever was before.
  CHECK(follow({0.1, -0.3, 33.4}) == Angular(0.0, 0.0, 33.0));
  CHECK(tension.block.inverse == block);
  const ImplicitTension other = make_tension(*test, Angular(0.0, 0.2, 32.7));
  CHECK(other.block.inverse == block);
  CHECK(other.turn == tension.turn);
}

TEST_CASE("below the least speed there is no tension on the left-hand side") {
  std::mt19937 random(84);
  for (const char* kind : kKinds) {
    const auto test = make_pulled_body(kind, 4, ReferenceFrame::clamped, random);
    ImplicitTension tension = make_tension(*test, kSpeed);
    REQUIRE(tension.least > 0.0);
    const ElasticBlock plain = make_elastic_block(test->body, kImplicit);
    follow_speed(test->body, test->tension, Angular(0.0, 0.0, 1.05 * tension.least), tension);
    CHECK(tension.is_on());
    CHECK(tension.block.inverse != plain.inverse);
    for (const double speed : {0.99 * tension.least, 0.0}) {
      follow_speed(test->body, test->tension, Angular(0.0, 0.0, speed), tension);
      CHECK_FALSE(tension.is_on());
      CHECK(tension.block.inverse == plain.inverse);
      const Eigen::VectorXd y = Eigen::VectorXd::Ones(3 + test->body.coordinates());
      const Added added = find_added(*test, tension, y);
      CHECK(added.mass.norm() == 0.0);
      CHECK(added.force.norm() == 0.0);
    }
  }
}

TEST_CASE("what the hub's rotation presses is left out") {
  std::mt19937 random(85);
  for (const char* kind : kKinds) {
    const auto test = make_pulled_body(kind, 3, ReferenceFrame::chord, random);
    // The rotation pushes from outside inward, and so do the masses that it carries.
    test->tension.origin.x() = -30.0;
    for (CarriedMass& carried : test->tension.carried) carried.moment.x() = -9.0;
    const ImplicitTension tension = make_tension(*test, Angular(0.0, 0.0, 8.0));
    const Eigen::VectorXd y = Eigen::VectorXd::Ones(3 + test->body.coordinates());
    const Added added = find_added(*test, tension, y);
    CHECK(added.mass.norm() == 0.0);
    CHECK(added.force.norm() == 0.0);
  }
}

}  // namespace spoke::space::test
