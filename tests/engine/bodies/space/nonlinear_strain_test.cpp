#include "engine/bodies/space/nonlinear_strain.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>

#include "engine/bodies/kernels/space/dense_body.h"
#include "engine/bodies/kinds/beam/beam_energies.h"
#include "tests/engine/bodies/space/bodies.h"

namespace spoke::space::test {
namespace {

/// Makes a random beam of strains of second order, at a random state without tension of a tree.
std::unique_ptr<TestBody> make_nonlinear_body(const BeamOptions& options, int elements,
                                              ReferenceFrame frame, std::mt19937& random) {
  auto test = make_random_body(options, elements, frame, random, true);
  test->model.tension = nullptr;
  test->follow();
  return test;
}

/// Returns the values by node of a flex vector.
Eigen::VectorXd by_node(const FlexibleBody& body, const Eigen::VectorXd& flex) {
  Eigen::VectorXd nodal(kTwist * body.node_count());
  expand(body, flex.data(), nodal.data());
  return nodal;
}

double calc_energy(const TestBody& test, const Eigen::VectorXd& q) {
  Eigen::VectorXd scratch(3 * test.body.elements);
  return calc_nonlinear_energy(test.body, by_node(test.body, q).data(), scratch.data());
}

/// Returns the derivative of a function of a step, to fourth order.
template <class Function>
auto differ(double h, Function&& f) {
  using Value = decltype(f(h));
  return Value((8.0 * (f(h) - f(-h)) - (f(2.0 * h) - f(-2.0 * h))) / (12.0 * h));
}

Eigen::VectorXd gradient(const TestBody& test, const Eigen::VectorXd& q) {
  Eigen::VectorXd slope(q.size());
  for (Eigen::Index i = 0; i < q.size(); ++i)
    slope[i] = differ(3e-4, [&](double step) {
      Eigen::VectorXd moved = q;
      moved[i] += step;
      return calc_energy(test, moved);
    });
  return slope;
}

/// Returns the elastic and damping forces on the flex vector.
Eigen::VectorXd strain_force(const TestBody& test, const Eigen::VectorXd& q,
                             const Eigen::VectorXd& v) {
  const FlexibleBody& body = test.body;
  const Eigen::VectorXd q_nodal = by_node(body, q), v_nodal = by_node(body, v);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(q_nodal.size()), flex(body.coordinates());
  Eigen::VectorXd scratch(3 * body.elements);
  const NodalMotion at{q_nodal.data(), v_nodal.data()};
  subtract_strain_forces(body, test.damping.stiffness_factor, at, at, scratch.data(), force.data());
  compress(body, force.data(), flex.data());
  return flex;
}

template <class Check>
void for_bodies(Check&& check) {
  std::mt19937 random(71);
  for (const BeamOptions& options : kStraightAndBent)
    for (const ReferenceFrame frame : {ReferenceFrame::clamped, ReferenceFrame::chord})
      for (const int elements : {1, 2, 4}) {
        CAPTURE(elements);
        check(*make_nonlinear_body(options, elements, frame, random));
      }
}

}  // namespace

TEST_CASE("elastic forces of second-order strains are the slopes of their energy") {
  for_bodies([](TestBody& test) {
    const Eigen::VectorXd slope = gradient(test, test.q);
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(test.q.size());
    const double scale = slope.lpNorm<Eigen::Infinity>();
    CHECK((strain_force(test, test.q, none) + slope).lpNorm<Eigen::Infinity>() < 1e-7 * scale);
  });
}

TEST_CASE("they are those of linear strains where displacements are small") {
  for_bodies([](TestBody& test) {
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(test.q.size()), q = 1e-7 * test.q;
    const Eigen::VectorXd linear = make_dense_elastic_block(test.body, {0.0, 1.0, 0.0}) * q;
    CHECK((strain_force(test, q, none) + linear).lpNorm<Eigen::Infinity>() <
          1e-5 * linear.lpNorm<Eigen::Infinity>());
  });
}

TEST_CASE("the stiffness of second-order strains is the slope of their forces") {
  for_bodies([](TestBody& test) {
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(test.q.size());
    const Eigen::VectorXd nodal = by_node(test.body, test.q);
    const Eigen::MatrixXd K = calc_strain_matrices(test.body, 0.0, nodal.data()).stiffness;
    for (Eigen::Index i = 0; i < test.q.size(); ++i) {
      const Eigen::VectorXd column = differ(1e-3, [&](double step) -> Eigen::VectorXd {
        Eigen::VectorXd moved = test.q;
        moved[i] += step;
        return -strain_force(test, moved, none);
      });
      CHECK((K.col(i) - column).lpNorm<Eigen::Infinity>() < 1e-6 * K.lpNorm<Eigen::Infinity>());
    }
    CHECK((K - K.transpose()).norm() < 1e-12 * K.norm());
  });
}

TEST_CASE("damping acts on strain rates, and takes the power of its force") {
  for_bodies([](TestBody& test) {
    const FlexibleBody& body = test.body;
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(test.q.size());
    const Eigen::VectorXd force =
        strain_force(test, test.q, test.v) - strain_force(test, test.q, none);
    const Eigen::VectorXd q = by_node(body, test.q), v = by_node(body, test.v);
    Eigen::VectorXd unused = Eigen::VectorXd::Zero(q.size()), scratch(3 * body.elements);
    const NodalMotion at{q.data(), v.data()};
    const double power = subtract_strain_forces(body, test.damping.stiffness_factor, at, at,
                                                scratch.data(), unused.data());
    CHECK(power > 0.0);
    CHECK(power == doctest::Approx(-force.dot(test.v)).epsilon(1e-10));
    const Eigen::MatrixXd D =
        calc_strain_matrices(body, test.damping.stiffness_factor, q.data()).damping;
    CHECK((force + D * test.v).lpNorm<Eigen::Infinity>() < 1e-10 * force.lpNorm<Eigen::Infinity>());
  });
}

TEST_CASE("a turn of all nodes about the first costs no energy") {
  std::mt19937 random(72);
  for (const BeamOptions& options : kStraightAndBent) {
    const auto test = make_nonlinear_body(options, 4, ReferenceFrame::clamped, random);
    const FlexibleBody& body = test->body;
    const Angular turn(0.3, 0.3, -0.35);
    const Rotation R = exponential(turn);
    Eigen::VectorXd q(kTwist * body.node_count()), force = Eigen::VectorXd::Zero(q.size());
    for (int k = 0; k < body.node_count(); ++k) {
      const Position& s = body.nodes[static_cast<std::size_t>(k)];
      q.segment<kTwist>(kTwist * k) << R * s - s, turn;
    }
    Eigen::VectorXd scratch(3 * body.elements);
    CHECK(calc_nonlinear_energy(body, q.data(), scratch.data()) < 1e-20);
    std::vector<Twist> wrenches(4);
    calc_strain_wrenches(body, q.data(), scratch.data(), wrenches.data());
    CHECK(wrenches[0].norm() < 1e-9);
  }
}

TEST_CASE("tables of a straight uniform element are those of its polynomials") {
  Beam beam = make_uniform_beam({.mass_per_length = 1.0,
                                 .axial_stiffness = 900.0,
                                 .lag_stiffness = 11.0,
                                 .flap_stiffness = 3.0,
                                 .torsion_stiffness = 2.0},
                                1.6);
  const BodyGeometry geometry = make_body_geometry(beam, {0.0, 1.6});
  const std::vector<BeamElement> elements = make_beam_elements(beam, geometry);
  const ElementSecondOrder second = make_second_order(beam, geometry, elements)[0];
  const double L = 1.6, wagner = 14.0 / 900.0 / L;
  Twist d;
  d << 0.02, 0.3, -0.2, 0.4, -0.15, 0.25;
  const auto value = [&d](const TwistMatrix& form) { return 0.5 * d.dot(form * d); };
  const double py = -d[2] / L, pz = d[1] / L, ph = d[3], be = d[4], ga = d[5];
  const double shortening =
      L * (0.6 * (py * py + pz * pz) - 0.1 * (py * be + pz * ga) + (be * be + ga * ga) / 15.0);
  CHECK(value(second.rotation[0]) == doctest::Approx(py * ga - pz * be).epsilon(1e-11));
  CHECK(value(second.rotation[1]) == doctest::Approx(ph * (pz - 0.5 * ga)).epsilon(1e-11));
  CHECK(value(second.rotation[2]) == doctest::Approx(ph * (0.5 * be - py)).epsilon(1e-11));
  CHECK(value(second.place[0]) ==
        doctest::Approx(-shortening - 0.5 * wagner * ph * ph).epsilon(1e-11));
  CHECK(value(second.place[1]) == doctest::Approx(L * ph * be / 6.0 + d[0] * pz).epsilon(1e-11));
  CHECK(value(second.place[2]) == doctest::Approx(L * ph * ga / 6.0 - d[0] * py).epsilon(1e-11));
}

TEST_CASE("terms of a body with second-order strains are those of Lagrange's equations") {
  std::mt19937 random(73);
  for (const BeamOptions& options : kStraightAndBent) {
    const auto test = make_nonlinear_body(options, 3, ReferenceFrame::clamped, random);
    const FlexibleBody& body = test->body;
    test->damping = {};
    test->body.is_damped = false;
    test->calc_terms();
    const Twist twist = make_twist(draw_vector(2.0, random), test->motion.w);
    const auto lagrangian = [&](const Eigen::VectorXd& q, const Twist& twist,
                                const Eigen::VectorXd& v) {
      const BodyState state{q.data(), v.data(), q.data(), v.data()};
      BodyMotion motion = test->motion;
      motion.w = angular(twist);
      const BodyEnergies energies =
          calc_body_energies(test->model, state, twist, motion, test->work);
      return energies.kinetic - energies.strain;
    };
    // d/dt dL/dq' along q' alone, and dL/dq, where twist and q' stand.
    const Eigen::Index n = test->q.size();
    const auto momentum = [&](const Eigen::VectorXd& q, Eigen::Index i) {
      return differ(1e-1, [&](double step) {
        Eigen::VectorXd v = test->v;
        v[i] += step;
        return lagrangian(q, twist, v);
      });
    };
    Eigen::VectorXd expected(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const double slope = differ(1e-3, [&](double step) {
        Eigen::VectorXd q = test->q;
        q[i] += step;
        return lagrangian(q, twist, test->v);
      });
      expected[i] =
          slope - differ(1e-3, [&](double time) { return momentum(test->q + time * test->v, i); });
    }
    // X is the acceleration of the frame as a point of space: w x v0 where v0 stands in it.
    const Twist X = make_twist(cross(angular(twist), linear(twist)), Angular::Zero());
    Eigen::MatrixXd mass(dense_size(body), dense_size(body));
    calc_dense_mass(body, test->terms, test->work, make_dense_elastic_block(body, {}), mass);
    Eigen::VectorXd force(dense_size(body));
    calc_dense_force(body, test->terms, test->work, force);
    const Eigen::VectorXd found = force.tail(n) - mass.bottomLeftCorner(n, kTwist) * X;
    CHECK((found - expected).lpNorm<Eigen::Infinity>() < 1e-6 * expected.lpNorm<Eigen::Infinity>());
    const double turned = differ(1.0, [&](double step) {
      Twist moved = twist;
      moved[4] += step;
      return lagrangian(test->q, moved, test->v);
    });
    Eigen::VectorXd y(dense_size(body));
    y << twist, test->v;
    CHECK((mass * y)[4] == doctest::Approx(turned).epsilon(1e-9));
  }
}

}  // namespace spoke::space::test
