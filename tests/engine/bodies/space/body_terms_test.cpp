#include "engine/bodies/kinds/beam/body_terms.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>

#include "engine/bodies/kernels/space/dense_body.h"
#include "engine/bodies/kinds/beam/beam_energies.h"
#include "models/support/instructions.h"
#include "tests/engine/bodies/space/bodies.h"

// Within the namespace: the plane's types have the same names.
namespace spoke::space::test {
namespace {

/// All that a body's kinetic energy depends on: twist of its frame, of the hub, deformation.
struct Motion {
  Twist twist;
  Angular hub_w;
  Eigen::VectorXd q, v;
};

/// Returns the momenta of a motion, by the velocities (v0, w, q', w0).
Eigen::VectorXd momenta(const TestBody& test, const Motion& motion) {
  const auto nf = motion.v.size();
  Eigen::VectorXd p(kTwist + nf + 3);
  const auto energy = [&](Eigen::Index i, double step) {
    Motion moved = motion;
    if (i < kTwist)
      moved.twist[i] += step;
    else if (i < kTwist + nf)
      moved.v[i - kTwist] += step;
    else
      moved.hub_w[i - kTwist - nf] += step;
    return calc_kinetic(test, moved.twist, moved.hub_w, moved.q, moved.v);
  };
  // T is quadratic in the velocities: the central difference is exact.
  for (Eigen::Index i = 0; i < p.size(); ++i) p[i] = 0.5 * (energy(i, 1.0) - energy(i, -1.0));
  return p;
}

/// Returns d/dt of the momenta along accelerations (X_t - w x v0, alpha, q'', w0'), extrapolated.
Eigen::VectorXd momenta_rate(const TestBody& test, const Motion& motion, const Twist& twist_rate,
                             const Eigen::VectorXd& a, const Angular& hub_a) {
  const auto difference = [&](double h) -> Eigen::VectorXd {
    const auto at = [&](double t) {
      return momenta(test, {motion.twist + t * twist_rate, motion.hub_w + t * hub_a,
                            motion.q + t * motion.v + 0.5 * t * t * a, motion.v + t * a});
    };
    return (at(h) - at(-h)) / (2.0 * h);
  };
  const double h = 2e-3;
  return (4.0 * difference(h) - difference(2.0 * h)) / 3.0;
}

/// Returns d(T - V)/dq: both are polynomials of second degree in q, or of no higher degree with
/// this accuracy.
Eigen::VectorXd lagrangian_slope(const TestBody& test, const Motion& motion) {
  Eigen::VectorXd slope(motion.q.size());
  const auto value = [&](Eigen::Index i, double step) {
    Eigen::VectorXd q = motion.q;
    q[i] += step;
    return calc_kinetic(test, motion.twist, motion.hub_w, q, motion.v) -
           calc_potential(test, test.motion.gravity, q);
  };
  for (Eigen::Index i = 0; i < slope.size(); ++i) slope[i] = 0.5 * (value(i, 1.0) - value(i, -1.0));
  return slope;
}

Motion draw_motion(const TestBody& test, std::mt19937& random) {
  Motion motion{make_twist(draw_vector(20.0, random), test.motion.w), test.motion.hub_w, test.q,
                test.v};
  return motion;
}

/// Checks that the terms of an undamped body are those of the Boltzmann-Hamel equations at a random
/// motion.
void check_equations_of_motion(TestBody& test, std::mt19937& random) {
  test.follow();
  test.damping = {};
  for (BeamElement& element : test.body.beam) element.damping.setZero();
  test.body.is_damped = false;
  test.calc_terms();
  const Motion motion = draw_motion(test, random);
  const Position v0 = linear(motion.twist);
  const Angular w = angular(motion.twist);
  const Twist X = make_twist(draw_vector(5.0, random), draw_vector(5.0, random));
  const Eigen::VectorXd a = Eigen::VectorXd::Random(motion.q.size());
  const Angular hub_a = draw_vector(2.0, random);
  const auto nf = a.size();

  const Eigen::VectorXd p = momenta(test, motion);
  Eigen::VectorXd expected =
      momenta_rate(test, motion, make_twist(linear(X) - cross(w, v0), angular(X)), a, hub_a);
  const Position p_t = p.head<3>(), p_w = p.segment<3>(3), p_hub = p.tail<3>();
  expected.head<3>() += cross(w, p_t);
  expected.segment<3>(3) += cross(w, p_w) + cross(v0, p_t);
  expected.segment(kTwist, nf) -= lagrangian_slope(test, motion);
  expected.tail<3>() += cross(motion.hub_w, p_hub);

  Eigen::MatrixXd mass(kTwist + nf, kTwist + nf);
  Eigen::VectorXd force(kTwist + nf), acceleration(kTwist + nf);
  calc_dense_mass(test.body, test.terms, test.work, make_dense_elastic_block(test.body, kExplicit),
                  mass);
  calc_dense_force(test.body, test.terms, test.work, force);
  acceleration << X, a;
  const Eigen::VectorXd found = mass * acceleration - force;
  const double scale = expected.lpNorm<Eigen::Infinity>();
  CHECK((found - expected.head(kTwist + nf)).lpNorm<Eigen::Infinity>() < 1e-9 * scale);
  // The moment that the stiffening leaves to the hub.
  const HubStiffening& hub = test.terms.stiffening;
  const Angular& w0 = motion.hub_w;
  const Position share =
      -hub.inertia * hub_a - hub.rate * w0 - cross(w0, Position(hub.inertia * w0));
  CHECK((share - expected.tail<3>()).norm() < 1e-9 * scale);
}

}  // namespace

TEST_CASE("terms of a spatial body are those of the Boltzmann-Hamel equations, at any velocity") {
  std::mt19937 random(21);
  for (const BeamOptions& options : kStraightAndBent)
    for (const ReferenceFrame frame : {ReferenceFrame::clamped, ReferenceFrame::chord})
      for (const int elements : {1, 3}) {
        CAPTURE(elements);
        check_equations_of_motion(*make_random_body(options, elements, frame, random), random);
      }
}

TEST_CASE("so are those of a body whose directions do not meet, four nodes at a time") {
  std::mt19937 random(22);
  for (const ReferenceFrame frame : {ReferenceFrame::clamped, ReferenceFrame::chord})
    for (const int elements : {1, 3, 4, 6}) {
      CAPTURE(elements);
      const auto test = make_decoupled_body(elements, frame, random);
      REQUIRE(test->body.directions);
      check_equations_of_motion(*test, random);
    }
}

namespace {

/// Returns the terms of a body, and its rows but for coordinates that its frame fixes.
Eigen::VectorXd all_terms(TestBody& test) {
  test.calc_terms();
  const BodyTerms& terms = test.terms;
  std::vector<double> all{terms.dissipation};
  const auto add = [&all](const auto& m) { all.insert(all.end(), m.data(), m.data() + m.size()); };
  add(terms.S);
  add(terms.Theta);
  add(terms.Q);
  add(terms.stiffening.inertia);
  add(terms.stiffening.rate);
  add(terms.stiffening.moment);
  for (int k = 0; k < test.body.node_count(); ++k)
    for (int c = 0; c < kTwist; ++c)
      if (test.body.coordinate(k, c) >= 0)
        for (int i = 0; i < 4; ++i) all.push_back(test.work.rows[kNodeRows * k + 4 * c + i]);
  return Eigen::Map<Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

}  // namespace

TEST_CASE("directions apart or together, a body has the same terms, damped and stiffened too") {
  std::mt19937 random(23);
  for (const ReferenceFrame frame : {ReferenceFrame::clamped, ReferenceFrame::chord})
    for (const int elements : {1, 2, 4, 5, 9}) {
      CAPTURE(elements);
      const auto test = make_decoupled_body(elements, frame, random);
      REQUIRE(test->damping.mass_factor * test->damping.stiffness_factor > 0.0);
      const Eigen::VectorXd apart = all_terms(*test);
      test->body.directions.reset();
      const Eigen::VectorXd together = all_terms(*test);
      CHECK((apart - together).lpNorm<Eigen::Infinity>() <
            1e-13 * together.lpNorm<Eigen::Infinity>());
    }
}

TEST_CASE("kernels for wider vectors agree with those for all processors to round-off") {
  std::mt19937 random(24);
  const Kernels before = kernels_in_use();
  for (const int elements : {3, 4}) {
    const BeamOptions bent{true, true, true};
    for (const auto& test : {make_decoupled_body(elements, ReferenceFrame::clamped, random),
                             make_random_body(bent, elements, ReferenceFrame::chord, random)}) {
      const auto values_with = [&](Kernels kernels) {
        use_kernels(kernels);
        const Eigen::VectorXd terms = all_terms(*test);
        condense_body(test->model, test->terms, test->motion.w, true, test->work);
        const std::vector<Twist> wrenches(test->body.handles.size(), Twist::Ones());
        Eigen::VectorXd values(terms.size() + test->q.size());
        values.head(terms.size()) = terms;
        recover_body(test->model, wrenches.data(), true, test->work, &values[terms.size()]);
        return values;
      };
      const Eigen::VectorXd narrow = values_with(Kernels::baseline);
      for (const Kernels kernels : {Kernels::avx2, Kernels::avx512}) {
        CAPTURE(name_of(kernels));
        const Eigen::VectorXd wide = values_with(kernels);
        CHECK((wide - narrow).lpNorm<Eigen::Infinity>() < 1e-11 * narrow.lpNorm<Eigen::Infinity>());
      }
      CHECK(values_with(Kernels::baseline) == narrow);
    }
  }
  use_kernels(before);
}

TEST_CASE("energies of a spatial body are the sums over its slots and elements") {
  std::mt19937 random(22);
  for (const BeamOptions& options : kStraightAndBent) {
    const auto test = make_random_body(options, 4, ReferenceFrame::chord, random);
    const Motion motion = draw_motion(*test, random);
    const double kinetic = calc_kinetic(*test, motion.twist, motion.hub_w, motion.q, motion.v);
    const double potential = calc_potential(*test, test->motion.gravity, motion.q);
    test->calc_terms();
    const BodyEnergies energies =
        calc_body_energies(test->model, test->state(), motion.twist, test->motion, test->work);
    CHECK(std::abs(energies.kinetic - kinetic) < 1e-14 * kinetic);
    CHECK(std::abs(energies.strain + energies.tension - potential) < 1e-13 * potential);
    CHECK(calc_strain_energy(test->body, test->q.data(), test->work) == energies.strain);
    CHECK((energies.S - test->terms.S).norm() == 0.0);
    // Gravity's tension turns the hub as its energy falls, which is linear in gravity.
    const Angular axis = draw_vector(1.0, random).normalized();
    BodyMotion turned = test->motion;
    turned.gravity = -cross(axis, test->motion.gravity);
    const double change =
        calc_body_energies(test->model, test->state(), motion.twist, turned, test->work).tension;
    CHECK(axis.dot(test->terms.stiffening.moment) == doctest::Approx(-change).epsilon(1e-12));
  }
}

TEST_CASE("the mass matrix of a spatial body is that of its kinetic energy") {
  std::mt19937 random(27);
  for (const BeamOptions& options : kStraightAndBent)
    for (const ReferenceFrame frame : {ReferenceFrame::clamped, ReferenceFrame::chord}) {
      const auto test = make_random_body(options, 5, frame, random);
      test->model.tension = nullptr;
      test->calc_terms();
      const Motion motion = draw_motion(*test, random);
      Eigen::MatrixXd mass(dense_size(test->body), dense_size(test->body));
      calc_dense_mass(test->body, test->terms, test->work,
                      make_dense_elastic_block(test->body, kExplicit), mass);
      Eigen::VectorXd y(mass.rows());
      y << motion.twist, motion.v;
      const double expected = calc_kinetic(*test, motion.twist, motion.hub_w, motion.q, motion.v);
      CHECK(std::abs(0.5 * y.dot(mass * y) - expected) < 1e-14 * expected);
      CHECK((mass - mass.transpose()).norm() < 1e-15 * mass.norm());
    }
}

TEST_CASE("terms of a body know its momentum, and what its tension and the rate of that weigh") {
  std::mt19937 random(29);
  for (const bool is_decoupled : {false, true})
    for (const ReferenceFrame frame : {ReferenceFrame::clamped, ReferenceFrame::chord}) {
      const auto test = is_decoupled ? make_decoupled_body(5, frame, random)
                                     : make_random_body({true, true, true}, 3, frame, random);
      test->calc_terms();
      const BodyTerms& terms = test->terms;
      const Motion motion = draw_motion(*test, random);
      const Position momentum = test->body.mass * linear(motion.twist) +
                                cross(angular(motion.twist), terms.S) + terms.S_rate;
      const Position expected = momenta(*test, motion).head<3>();
      CHECK((momentum - expected).norm() < 1e-10 * expected.norm());
      // The energy of gravity's tension is quadratic in q: the central difference is exact.
      const Position field = draw_vector(9.0, random);
      const auto energy = [&](const Eigen::VectorXd& q) {
        return calc_potential(*test, field, q) - calc_potential(*test, Position::Zero(), q);
      };
      const double rate = 0.5 * (energy(test->q + test->v) - energy(test->q - test->v));
      CHECK(field.dot(terms.tension.value) == doctest::Approx(energy(test->q)).epsilon(1e-9));
      CHECK(field.dot(terms.tension.rate) == doctest::Approx(rate).epsilon(1e-9));
      // Where the hub turns, the field does as well, the other way round.
      const Angular hub_w = draw_vector(2.0, random);
      const double power = calc_tension_power(terms.tension, hub_w, field);
      CHECK(power ==
            doctest::Approx(-rate - terms.tension.value.dot(cross(field, hub_w))).epsilon(1e-9));
    }
}

TEST_CASE("damping takes the power that its force has") {
  std::mt19937 random(23);
  const auto test = make_random_body({true, true, true}, 3, ReferenceFrame::clamped, random);
  test->follow();
  const Eigen::VectorXd damped = test->deformation_force();
  const double dissipation = test->terms.dissipation;
  const Eigen::MatrixXd D = 0.3 * to_dense(test->body, test->body.M) +
                            2e-3 * to_dense(test->body, test->body.K) +
                            to_dense(test->body, test->body.D);
  test->damping = {};
  for (BeamElement& element : test->body.beam) element.damping.setZero();
  const Eigen::VectorXd force = damped - test->deformation_force();
  CHECK((force + D * test->v).norm() < 1e-12 * (D * test->v).norm());
  CHECK(dissipation == doctest::Approx(test->v.dot(D * test->v)).epsilon(1e-12));
}

TEST_CASE("implicit steps take elastic and damping forces where they are told to") {
  std::mt19937 random(24);
  const auto test = make_random_body({false, false, false}, 3, ReferenceFrame::chord, random);
  const Eigen::VectorXd force = test->deformation_force();
  const Eigen::VectorXd q_elastic = test->q_elastic, v_elastic = test->v_elastic;
  test->follow();
  const Eigen::MatrixXd K = to_dense(test->body, test->body.K);
  const Eigen::MatrixXd D =
      0.3 * to_dense(test->body, test->body.M) + 2e-3 * K + to_dense(test->body, test->body.D);
  const Eigen::VectorXd expected =
      test->deformation_force() + K * (test->q - q_elastic) + D * (test->v - v_elastic);
  CHECK((force - expected).norm() < 1e-12 * expected.norm());
}

TEST_CASE("a handle's Jacobian and bias give its acceleration, by differences of its motion") {
  std::mt19937 random(25);
  const auto test = make_random_body({true, true, false}, 4, ReferenceFrame::chord, random);
  const Eigen::VectorXd q = test->q, v = test->v, a = Eigen::VectorXd::Random(q.size());
  const Position v0 = draw_vector(3.0, random);
  const Twist X = make_twist(draw_vector(5.0, random), draw_vector(5.0, random));
  const Angular w = test->motion.w;
  test->calc_terms();
  for (std::size_t h = 0; h < test->body.handles.size(); ++h) {
    CAPTURE(h);
    // Returns the twist of the handle in B at time t; the rate of the rotation by the tangent map.
    const auto twist_at = [&](double t) {
      test->q = q + t * v + 0.5 * t * t * a;
      test->v = v + t * a;
      test->motion.w = w + t * angular(X);
      test->calc_terms();
      const HandleMotion& handle = test->work.handles[h];
      const Position v0_t = v0 + t * (linear(X) - cross(w, v0));
      Twist twist = handle.twist();
      linear(twist) += v0_t + cross(test->motion.w, handle.s);
      angular(twist) += test->motion.w;
      return twist;
    };
    const double step = 1e-3;
    const Twist coarse = (twist_at(2.0 * step) - twist_at(-2.0 * step)) / (4.0 * step);
    const Twist fine = (twist_at(step) - twist_at(-step)) / (2.0 * step);
    const Twist twist = twist_at(0.0);
    // The expected acceleration is d/dt in B, and the part of the turning of B.
    const Twist expected =
        (4.0 * fine - coarse) / 3.0 + make_twist(cross(w, linear(twist)), cross(w, angular(twist)));
    Eigen::MatrixXd J(kTwist, dense_size(test->body));
    calc_handle_jacobian(test->body, static_cast<int>(h), test->work, J);
    Eigen::VectorXd accelerations(dense_size(test->body));
    accelerations << X, a;
    const Twist found = J * accelerations + test->work.handles[h].bias(w);
    CHECK((found - expected).norm() < 1e-8 * expected.norm());
    // The rate of the orientation is w + H th'.
    const Matrix3 R = test->work.handles[h].turn.R.axes;
    const Angular turning = test->work.handles[h].turn.velocity;
    twist_at(step);
    const Matrix3 after = test->work.handles[h].turn.R.axes;
    twist_at(-step);
    const Matrix3 rate = (after - test->work.handles[h].turn.R.axes) / (2.0 * step);
    CHECK((rate - skew(turning) * R).norm() < 1e-4);
    twist_at(0.0);
  }
}

}  // namespace spoke::space::test
