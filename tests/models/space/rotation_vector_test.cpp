#include "models/space/rotation_vector.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <random>
#include <unsupported/Eigen/MatrixFunctions>
#include <vector>

#include "models/space/quaternion.h"
#include "tests/models/space/random_space.h"

using namespace spoke::space;
using namespace spoke::space::testing;

namespace {

/// Angles within the range of the series, about its end, and beyond.
const std::vector<double> kAngles{0.0, 1e-160, 1e-9, 1e-3, 0.5, 0.999999, 1.000001, 2.0, 3.1};

/// Returns the vector of a skew matrix.
Position unskew(const Matrix3& m) { return {m(2, 1), m(0, 2), m(1, 0)}; }

/// Returns d/dx f(x) at 0, to order 4.
template <class Function>
auto differentiate(const Function& f, double h) {
  return ((8.0 * (f(h) - f(-h)) - (f(2.0 * h) - f(-2.0 * h))) / (12.0 * h)).eval();
}

}  // namespace

TEST_CASE("the exponential of a rotation vector is the matrix exponential") {
  std::mt19937 random(1);
  for (const double angle : kAngles) {
    CAPTURE(angle);
    const Angular theta = angle * random_axis(random);
    const Matrix3 R = exponential(theta).axes;
    const Eigen::Matrix3d expected = Eigen::Matrix3d(skew(theta)).exp();
    CHECK((R - expected).cwiseAbs().maxCoeff() < 2e-15);
    CHECK((R.transpose() * R - Matrix3::Identity()).cwiseAbs().maxCoeff() < 2e-15);
  }
}

TEST_CASE("the tangent map and its rate are derivatives of the exponential") {
  std::mt19937 random(2);
  for (const double angle : kAngles) {
    CAPTURE(angle);
    const Angular theta = angle * random_axis(random);
    const Angular rate = random_vector(random), second = random_vector(random);
    const auto at = [&](double t) -> Angular { return theta + t * rate + 0.5 * t * t * second; };
    const RotationVectorMotion motion = calc_rotation_vector_motion(theta, rate);
    CHECK((motion.R.axes - exponential(theta).axes).norm() == 0.0);
    CHECK((motion.H - calc_tangent(theta)).norm() == 0.0);
    // w~ = R' R^T, resolved in the frame that R leads to.
    const Matrix3 R_rate =
        differentiate([&](double t) -> Matrix3 { return exponential(at(t)).axes; }, 1e-3);
    const Angular w = unskew(R_rate * motion.R.axes.transpose());
    CHECK((motion.velocity - w).norm() < 1e-11);
    const Angular w_rate = differentiate(
        [&](double t) -> Angular { return calc_tangent(at(t)) * (rate + t * second); }, 1e-3);
    CHECK((motion.H * second + motion.convective - w_rate).norm() < 1e-11);
  }
}

TEST_CASE("coefficients of a rotation are smooth where the series ends") {
  const RotationCoefficients below = calc_rotation_coefficients(1.0 - 1e-15);
  const RotationCoefficients above = calc_rotation_coefficients(1.0);
  CHECK(std::abs(below.s - above.s) < 2e-15);
  CHECK(std::abs(below.c - above.c) < 2e-15);
  CHECK(std::abs(below.d - above.d) < 2e-15);
  CHECK(std::abs(below.c_rate - above.c_rate) < 2e-15);
  CHECK(std::abs(below.d_rate - above.d_rate) < 2e-15);
}

TEST_CASE("the logarithm takes the exponential back") {
  std::mt19937 random(3);
  for (const double angle : kAngles) {
    CAPTURE(angle);
    const Angular theta = angle * random_axis(random);
    CHECK((logarithm(exponential(theta)) - theta).norm() < 1e-14 * (1.0 + angle));
    CHECK((logarithm(make_quaternion(theta)) - theta).norm() < 1e-14 * (1.0 + angle));
  }
  // A half turn has two vectors, of one rotation.
  const Angular half = std::numbers::pi * random_axis(random);
  CHECK((exponential(logarithm(exponential(half))).axes - exponential(half).axes).norm() < 1e-14);
}

TEST_CASE("quaternions are rotations") {
  std::mt19937 random(4);
  for (int round = 0; round < 50; ++round) {
    const Angular a = 3.0 * random_vector(random), b = 3.0 * random_vector(random);
    const Quaternion A = make_quaternion(a), B = make_quaternion(b);
    CHECK(std::abs(A.squared_norm() - 1.0) < 1e-15);
    CHECK((make_rotation(A).axes - exponential(a).axes).norm() < 1e-14);
    CHECK((make_rotation(A * B).axes - (exponential(a) * exponential(b)).axes).norm() < 1e-14);
    CHECK((make_rotation(A.conjugate()).axes - exponential(a).inverse().axes).norm() < 1e-14);
    const Quaternion back = make_quaternion(exponential(a));
    CHECK(back.w >= 0.0);
    CHECK((make_rotation(back).axes - exponential(a).axes).norm() < 1e-14);
    const Quaternion scaled{2.5 * A.w, 2.5 * A.v}, unit = normalize(scaled);
    CHECK(std::abs(unit.w - A.w) + (unit.v - A.v).norm() < 1e-15);
  }
}

TEST_CASE("rotations of more than a right angle about each axis have their quaternion") {
  for (int axis = 0; axis < 3; ++axis)
    for (const double angle : {2.0, std::numbers::pi, 4.0}) {
      const Rotation R = exponential(angle * Angular(Angular::Unit(axis)));
      CHECK((make_rotation(make_quaternion(R)).axes - R.axes).norm() < 1e-15);
    }
}

TEST_CASE("rates of a quaternion belong to an angular velocity") {
  std::mt19937 random(5);
  const Quaternion Q = make_quaternion(random_vector(random));
  const Angular w = random_vector(random);
  const auto numbers = [](const Quaternion& q) {
    return Eigen::Vector4d(q.w, q.v.x(), q.v.y(), q.v.z());
  };
  const auto turn = [&](double t) { return make_quaternion(Angular(t * w)); };
  const Eigen::Vector4d in_child =
      differentiate([&](double t) { return numbers(Q * turn(t)); }, 1e-3);
  const Eigen::Vector4d in_parent =
      differentiate([&](double t) { return numbers(turn(t) * Q); }, 1e-3);
  CHECK((numbers(calc_rate(Q, w)) - in_child).norm() < 1e-12);
  CHECK((numbers(calc_rate(w, Q)) - in_parent).norm() < 1e-12);
}
