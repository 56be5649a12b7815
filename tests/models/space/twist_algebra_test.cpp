#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <random>

#include "models/plane/plane.h"
#include "models/space/space.h"
#include "tests/models/space/random_space.h"

using namespace spoke::space;
using namespace spoke::space::testing;

namespace {

double difference(const TwistMatrix& a, const TwistMatrix& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

/// Returns T = [1, -p~; 0, 1]: from the acceleration of a point to that of the point at p from
/// there.
TwistMatrix leads_to(const Position& p) {
  TwistMatrix T = TwistMatrix::Identity();
  T.topRightCorner<3, 3>() = -skew(p);
  return T;
}

/// Returns the acceleration of a chain's root per wrench, in code for any world.
template <class Matrix, class Rotation, class Position, class Twist, class TwistMatrix>
Twist respond(const Matrix& a, const Rotation& R, const Position& p, const Twist& f,
              const TwistMatrix& m) {
  using spoke::translate;  // since functions of vectors alone are in namespace spoke
  const Matrix b = eliminate(a, m, invert(a + rotate(R, a)));
  return translate(p, translate(p, b) * Twist(R * f - f));
}

}  // namespace

TEST_CASE("symmetric twist matrices are the matrices that they stand for") {
  std::mt19937 random(1);
  for (int round = 0; round < 20; ++round) {
    const SymmetricTwistMatrix a = random_inertia(random), b = random_inertia(random);
    const TwistMatrix A = a.matrix(), B = b.matrix(), M = random_matrix(random);
    const Rotation R = random_rotation(random);
    const Position p = random_vector(random);
    const TwistMatrix T = leads_to(p), X = leads_to(-p);
    const Twist v = random_twist(random);
    CHECK(difference(A, A.transpose()) == 0.0);
    CHECK(difference((a + b).matrix(), A + B) == 0.0);
    CHECK(difference((a - b).matrix(), A - B) == 0.0);
    CHECK((a * v - A * v).norm() < 1e-14);
    CHECK((R * v - R.matrix() * v).norm() < 1e-14);
    CHECK(difference(rotate(R, a).matrix(), R.matrix() * A * R.matrix().transpose()) < 1e-14);
    CHECK(difference(translate(p, a).matrix(), T.transpose() * A * T) < 1e-13);
    CHECK(difference(refer(p, a).matrix(), X * A * X.transpose()) < 1e-13);
    CHECK((translate(p, v) - T.transpose() * v).norm() < 1e-14);
    CHECK((refer(p, v) - X * v).norm() < 1e-14);
    CHECK(difference(eliminate(a, M, b).matrix(), A - M * B * M.transpose()) < 1e-13);
    CHECK(difference(subtract_square(a, v, 0.3).matrix(), A - 0.3 * v * v.transpose()) < 1e-14);
  }
}

TEST_CASE("the inverse of a symmetric twist matrix is that of the matrix") {
  std::mt19937 random(2);
  for (int round = 0; round < 100; ++round) {
    const SymmetricTwistMatrix a = random_inertia(random);
    const TwistMatrix inverse = invert(a).matrix(), expected = a.matrix().inverse();
    CHECK(difference(inverse, expected) < 1e-11 * expected.norm());
    CHECK(difference(inverse, inverse.transpose()) < 1e-12 * expected.norm());
  }
  CHECK_FALSE(invert(SymmetricTwistMatrix{}).matrix().allFinite());
}

TEST_CASE("code for the plane's names compiles for plane and space") {
  std::mt19937 random(3);
  const Twist v = respond(random_inertia(random), random_rotation(random), random_vector(random),
                          random_twist(random), random_matrix(random));
  CHECK(v.allFinite());
  const spoke::plane::SymmetricTwistMatrix a{2.0, 0.1, 3.0, 0.2, 0.3, 4.0};
  const spoke::TwistMatrix m = 0.1 * spoke::TwistMatrix::Identity();
  CHECK(respond(a, spoke::plane::Rotation::from_angle(0.3), spoke::Position(1.0, 2.0),
                spoke::Twist(1.0, 2.0, 3.0), m)
            .allFinite());
}

TEST_CASE("structures of space hold nothing but doubles") {
  CHECK(sizeof(Twist) == 6 * sizeof(double));
  CHECK(sizeof(Pose) == 12 * sizeof(double));
  CHECK(sizeof(SymmetricTwistMatrix) == 36 * sizeof(double));
  CHECK(alignof(TwistMatrix) == alignof(double));
  CHECK(sizeof(Quaternion) == 4 * sizeof(double));
}
