// Compares a rigid body with point masses that it may be made of.

#include "engine/bodies/space/rigid_body_terms.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "tests/models/space/random_space.h"

using namespace spoke::space;
using namespace spoke::space::testing;

namespace {

struct CloudPoint {
  double mass;
  Position p;
};

std::vector<CloudPoint> make_cloud(std::mt19937& random) {
  std::vector<CloudPoint> cloud;
  for (int k = 0; k < 8; ++k) {
    const double mass = 1.5 + random_number(random);
    cloud.push_back({mass, random_vector(random)});
  }
  return cloud;
}

RigidBody make_body(const std::vector<CloudPoint>& cloud) {
  RigidBody body;
  for (const CloudPoint& point : cloud) {
    body.mass += point.mass;
    body.centre += point.mass * point.p;
  }
  body.centre /= body.mass;
  for (const CloudPoint& point : cloud) {
    const Matrix3 r = skew(point.p - body.centre);
    body.inertia -= point.mass * r * r;
  }
  return body;
}

}  // namespace

TEST_CASE("momentum, energy and gyroscopic force of a rigid body are those of its point masses") {
  std::mt19937 random(1);
  const std::vector<CloudPoint> cloud = make_cloud(random);
  const RigidBody body = make_body(cloud);
  const SymmetricTwistMatrix mass = calc_mass(body);
  const Twist v = random_twist(random);
  const Angular w = angular(v);
  Twist momentum = Twist::Zero(), inertia_force = Twist::Zero();
  double energy = 0.0;
  for (const CloudPoint& point : cloud) {
    const Position velocity = linear(v) + cross(w, point.p);
    momentum += point.mass * translate(point.p, make_twist(velocity, Angular::Zero()));
    energy += 0.5 * point.mass * velocity.squaredNorm();
    const Position centripetal = cross(w, cross(w, point.p));
    inertia_force -= point.mass * translate(point.p, make_twist(centripetal, Angular::Zero()));
  }
  CHECK((mass * v - momentum).norm() < 1e-13);
  CHECK(std::abs(calc_kinetic_energy(mass, v) - energy) < 1e-13);
  CHECK((calc_gyroscopic_force(mass, v) - inertia_force).norm() < 1e-12);
}

TEST_CASE("the multi-port of a rigid body gives the accelerations of its handles") {
  std::mt19937 random(2);
  RigidBody body = make_body(make_cloud(random));
  body.outboard = {random_vector(random), random_vector(random)};
  const RigidPort constants(body);
  const Twist v = random_twist(random), Q = random_twist(random);
  std::vector<SymmetricTwistMatrix> diagonal(3);
  std::vector<TwistMatrix> pairs(3);
  std::vector<Twist> free(3);
  const spoke::tree::MultiPort<spoke::Space> port{3, diagonal.data(), pairs.data(), free.data()};
  condense(constants, v, Q, port);

  const std::vector<Twist> f{random_twist(random), random_twist(random), random_twist(random)};
  const Twist X = recover_frame(constants, Q, f);
  // The equation of motion, about the origin.
  Twist right = Q;
  for (std::size_t h = 0; h < 3; ++h) right += translate(constants.handles[h], f[h]);
  CHECK((constants.mass * X - right).norm() < 1e-12);
  // The acceleration of a handle is that of the rigid frame there.
  for (int h = 0; h < 3; ++h) {
    Twist by_port = free[static_cast<std::size_t>(h)];
    for (int k = 0; k < 3; ++k) {
      const Twist& wrench = f[static_cast<std::size_t>(k)];
      if (k == h)
        by_port += diagonal[static_cast<std::size_t>(h)] * wrench;
      else if (h < k)
        by_port += port.between(h, k) * wrench;
      else
        by_port += port.between(k, h).transpose() * wrench;
    }
    const Position& s = constants.handles[static_cast<std::size_t>(h)];
    const Angular w = angular(v);
    Twist expected = X;
    linear(expected) += cross(angular(X), s) + cross(w, cross(w, s));
    CHECK((by_port - expected).norm() < 1e-12);
  }
}
