#include "engine/bodies/plane/nonlinear_strain.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "engine/bodies/plane/implicit_strain.h"
#include "models/plane/beam_elements.h"

namespace spoke::plane {
namespace {

/// A body whose strains are of second order, with flex vectors of a random shape and motion.
struct TestBody {
  FlexibleBody body, linear;
  FlexLayout layout;
  std::vector<double> q, v;

  TestBody(bool is_tapered, int elements, ReferenceFrame frame, std::mt19937& random) {
    BeamProperties beam{1.6, elements, 0.7, 900.0, 11.0, frame};
    if (is_tapered)
      beam.pieces = {{0.0, 1.0, {0.9, 0.6}, {900.0, 700.0}, {12.0, 7.0}},
                     {1.0, 1.6, {0.6, 0.6}, {700.0, 500.0}, {7.0, 4.0}}};
    linear = make_beam_body(beam);
    beam.is_nonlinear = true;
    body = make_beam_body(beam);
    body.damping = linear.damping = {2e-3, 1e-3};
    layout = {body.axial(), body.bending()};
    q = draw(0.1, random);
    v = draw(1.0, random);
  }

  std::vector<double> draw(double size, std::mt19937& random) const {
    std::uniform_real_distribution<double> value(-size, size);
    std::vector<double> flex = zero();
    for (int i = 0; i < body.coordinates(); ++i)
      flex[static_cast<std::size_t>(layout.offset(i))] = value(random);
    return flex;
  }
  std::vector<double> zero() const {
    return std::vector<double>(static_cast<std::size_t>(layout.size()), 0.0);
  }
  double& at(std::vector<double>& flex, int coordinate) const {
    return flex[static_cast<std::size_t>(layout.offset(coordinate))];
  }
  Eigen::VectorXd take(const std::vector<double>& flex) const {
    Eigen::VectorXd values(body.coordinates());
    for (int i = 0; i < values.size(); ++i)
      values[i] = flex[static_cast<std::size_t>(layout.offset(i))];
    return values;
  }
  /// Returns elastic and damping forces.
  Eigen::VectorXd force(const std::vector<double>& shape, const std::vector<double>& rates) const {
    std::vector<double> Q = zero();
    subtract_strain_forces(body, layout, 3e-3, shape.data(), rates.data(), Q.data());
    return take(Q);
  }
  Eigen::VectorXd force(const std::vector<double>& shape) const { return force(shape, zero()); }
};

/// Returns the derivative of a function of a step, to fourth order.
template <class Function>
auto differ(double h, Function&& f) {
  using Value = decltype(f(h));
  return Value((8.0 * (f(h) - f(-h)) - (f(2.0 * h) - f(-2.0 * h))) / (12.0 * h));
}

template <class Check>
void for_bodies(Check&& check) {
  std::mt19937 random(31);
  for (const bool is_tapered : {false, true})
    for (const ReferenceFrame frame : {ReferenceFrame::clamped, ReferenceFrame::chord})
      for (const int elements : {1, 2, 3, 5}) {
        CAPTURE(elements);
        check(TestBody(is_tapered, elements, frame, random));
      }
}

double largest(const Eigen::MatrixXd& matrix) { return matrix.lpNorm<Eigen::Infinity>(); }

}  // namespace

TEST_CASE("elastic forces of second-order strains in the plane are the slopes of their energy") {
  for_bodies([](TestBody test) {
    const Eigen::VectorXd force = test.force(test.q);
    for (int i = 0; i < test.body.coordinates(); ++i)
      CHECK(force[i] == doctest::Approx(-differ(1e-3,
                                                [&](double step) {
                                                  std::vector<double> moved = test.q;
                                                  test.at(moved, i) += step;
                                                  return calc_nonlinear_energy(
                                                      test.body, test.layout, moved.data());
                                                }))
                            .epsilon(1e-7)
                            .scale(largest(force)));
  });
}

TEST_CASE("stiffness of second-order strains in the plane is the slope of their forces") {
  for_bodies([](TestBody test) {
    const Eigen::MatrixXd K = calc_strain_stiffness(test.body, test.layout, test.q.data());
    for (int i = 0; i < test.body.coordinates(); ++i) {
      const Eigen::VectorXd column = differ(1e-3, [&](double step) -> Eigen::VectorXd {
        std::vector<double> moved = test.q;
        test.at(moved, i) += step;
        return -test.force(moved);
      });
      CHECK(largest(K.col(i) - column) < 1e-7 * largest(K));
    }
    CHECK(largest(K - K.transpose()) == 0.0);
    Eigen::MatrixXd linear = Eigen::MatrixXd::Zero(K.rows(), K.cols());
    linear.topLeftCorner(test.body.axial(), test.body.axial()) = test.linear.K_axial.to_dense();
    linear.bottomRightCorner(test.body.bending(), test.body.bending()) =
        test.linear.K_bending.to_dense();
    const Eigen::MatrixXd at_rest =
        calc_strain_stiffness(test.body, test.layout, test.zero().data());
    CHECK(largest(at_rest - linear) < 1e-13 * largest(linear));
  });
}

TEST_CASE("damping in the plane acts on strain rates, and takes the power of its force") {
  for_bodies([](TestBody test) {
    std::vector<double> Q = test.zero();
    const double power = subtract_strain_forces(test.body, test.layout, 3e-3, test.q.data(),
                                                test.v.data(), Q.data());
    const Eigen::VectorXd force = test.take(Q) - test.force(test.q), v = test.take(test.v);
    CHECK(power > 0.0);
    CHECK(power == doctest::Approx(-force.dot(v)).epsilon(1e-12));
    const Eigen::MatrixXd D = calc_strain_damping(test.body, test.layout, 3e-3, test.q.data());
    CHECK(largest(force + D * v) < 1e-12 * largest(force));
    for (int e = 0; e < test.body.elements; ++e) {
      const Twist rate = differ(1e-3, [&](double time) -> Twist {
        std::vector<double> moved = test.q;
        for (std::size_t i = 0; i < moved.size(); ++i) moved[i] += time * test.v[i];
        return calc_strain(test.body, test.layout, e, moved.data());
      });
      const Twist found = calc_strain_rate(test.body, test.layout, e, test.q.data(), test.v.data());
      CHECK((rate - found).norm() < 1e-8);
    }
  });
}

TEST_CASE("a turn of all nodes in the plane strains no element") {
  const double l = 0.4;
  for (const double turn : {0.3, -2.0, std::numbers::pi}) {
    const Rotation R = Rotation::from_angle(turn);
    NodesVector q;
    const Position inner(0.7, -0.2), outer = inner + R * Position(l, 0.0) - Position(l, 0.0);
    q << inner, turn, outer, turn;
    const ElementStrain strain(l, q);
    CHECK(strain.d().norm() < 1e-15);
    // Its rates neither, about any point.
    NodesVector rate;
    rate << 1.0, 2.0, 1.0, Position(1.0, 2.0) + quarter_turn(R * Position(l, 0.0)), 1.0;
    CHECK((strain.map() * rate).norm() < 1e-14);
  }
}

TEST_CASE("an implicit step has the exact tangent where it begins, and solves by it") {
  for_bodies([](TestBody test) {
    const TangentFactors factors{0.02, 0.3, 0.02};
    ImplicitStrain strain = make_implicit_strain(test.body, factors);
    keep_wrenches(test.body, test.q.data(), strain);
    follow_strain(test.body, test.q.data(), strain);
    const Eigen::Index n = test.body.coordinates();
    Eigen::MatrixXd added = Eigen::MatrixXd::Zero(n, n), matrix = added;
    strain.added.add_to(added);
    const Eigen::MatrixXd expected =
        0.02 * calc_strain_stiffness(test.body, test.layout, test.q.data()) +
        0.3 * calc_strain_damping(test.body, test.layout, 0.0, test.q.data());
    CHECK(largest(added - expected) < 1e-13 * largest(expected));
    strain.mass.add_to(matrix);
    matrix += added;
    const Eigen::MatrixXd inverse = matrix.inverse();
    for (int c = 0; c < kTwist; ++c) {
      const int at = test.body.outboard.coordinate[static_cast<std::size_t>(c)];
      if (at < 0) continue;
      const auto& pair = strain.columns[c < kRotation ? 1 : 2];
      for (int i = 0; i < n; ++i)
        CHECK(pair[static_cast<std::size_t>(i)][c < kRotation ? c : 0] ==
              doctest::Approx(inverse(strain.mass.coordinate(i), at))
                  .epsilon(1e-10)
                  .scale(largest(inverse)));
    }
    std::vector<double> Q = test.zero(), c = test.zero();
    const FrameShare share = add_implicit_strain(strain, test.v.data(), 0.7, c.data(), Q.data());
    const Eigen::VectorXd lean = test.take(c), v = test.take(test.v);
    CHECK(largest(test.take(Q) - added * v - 0.7 * lean) < 1e-12 * largest(added * v));
    CHECK(share.moment == doctest::Approx(0.7 * share.inertia + lean.dot(v)));
  });
}

}  // namespace spoke::plane
