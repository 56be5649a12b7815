#include "engine/bodies/space/joint_forces.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "tests/engine/bodies/space/random_joint.h"
#include "tests/models/space/random_space.h"

using namespace spoke::space;
using namespace spoke::space::testing;

namespace {

/// A random joint in a random state.
struct RandomJoint {
  RandomJoint(const char* kind, std::mt19937& random)
      : joint(make_random_joint(kind, random)), reference(make_quaternion(random_vector(random))) {
    for (auto* values : {&q, &v, &a, &motor})
      for (double& value : *values) value = random_number(random);
  }
  JointState state() const { return {q.data(), v.data(), &reference, nullptr}; }

  Joint joint;
  Quaternion reference;
  std::array<double, Joint::kMost> q{}, v{}, a{}, motor{};
};

/// Returns the state a time t later, at constant velocities.
RandomJoint move(const RandomJoint& from, double t) {
  RandomJoint to = from;
  for (std::size_t c = 0; c < to.q.size(); ++c) to.q[c] += t * to.v[c];
  for (const JointPrimitive& primitive : from.joint.sequence()) {
    if (primitive.kind != JointPrimitive::Kind::spherical) continue;
    const auto at = static_cast<std::size_t>(from.joint.spherical_at);
    for (std::size_t c = 0; c < 3; ++c) to.q[at + c] = from.q[at + c];
    const Angular w(from.v[at], from.v[at + 1], from.v[at + 2]);
    const Quaternion Q =
        turn(calc_orientation(from.joint, primitive, from.state()), t * w, primitive.frame);
    const Quaternion D = make_quaternion(Angular(to.q[at], to.q[at + 1], to.q[at + 2]));
    to.reference = primitive.frame == TurnFrame::child ? Q * D.conjugate() : D.conjugate() * Q;
  }
  return to;
}

double calc_power(const RandomJoint& joint, const JointForces& forces) {
  double sum = 0.0;
  for (std::size_t c = 0; c < joint.v.size(); ++c) sum += forces.tau[c] * joint.v[c];
  return sum;
}

}  // namespace

TEST_CASE("springs, dampers and motors of a joint balance its power") {
  std::mt19937 random(1);
  for (const char* kind : kJointKinds) {
    CAPTURE(std::string(kind));
    const RandomJoint joint(kind, random);
    JointForces forces;
    calc_joint_forces(joint.joint, joint.state(), {}, nullptr, joint.motor.data(), forces);
    const double h = 1e-3;
    const auto energy = [&](double t) {
      const RandomJoint moved = move(joint, t);
      return calc_spring_energy(moved.joint, moved.state());
    };
    const double stored =
        (8.0 * (energy(h) - energy(-h)) - (energy(2.0 * h) - energy(-2.0 * h))) / (12.0 * h);
    double by_motor = 0.0;
    for (std::size_t c = 0; c < joint.v.size(); ++c)
      if (static_cast<int>(c) < joint.joint.coordinates) by_motor += joint.motor[c] * joint.v[c];
    const double taken = calc_dissipation(joint.joint, joint.state());
    CHECK(std::abs(calc_power(joint, forces) - (by_motor - taken - stored)) < 1e-10);
  }
}

TEST_CASE("implicit forces of a joint are its forces where the accelerations are those found") {
  std::mt19937 random(2);
  for (const char* kind : kJointKinds) {
    CAPTURE(std::string(kind));
    const RandomJoint joint(kind, random);
    JointForces plain, implicit;
    calc_joint_forces(joint.joint, joint.state(), {}, nullptr, nullptr, plain);
    calc_joint_forces(joint.joint, joint.state(), {1e-2, 0.1}, joint.a.data(), nullptr, implicit);
    for (std::size_t c = 0; c < Joint::kMost; ++c) {
      const bool is_coordinate = static_cast<int>(c) < joint.joint.coordinates;
      CHECK(plain.share[c] == 0.0);
      CHECK((implicit.share[c] > 0.0) == is_coordinate);
      CHECK(std::abs(implicit.tau[c] - implicit.share[c] * joint.a[c] - plain.tau[c]) < 1e-14);
    }
  }
}

TEST_CASE("a linear spring of an implicit step stands at the predicted coordinate") {
  JointPrimitive spring;
  spring.stiffness = 3.0;
  spring.damping = 0.5;
  spring.rest = 0.1;
  const Joint joint = make_joint({}, std::span(&spring, 1));
  const double c = 1e-2, c_rate = 0.1;  // beta' h^2, gamma' h
  const double qp = 0.4, vp = -0.3, a = 7.0, q = qp + c * a, v = vp + c_rate * a;
  const JointState state{&q, &v, nullptr, nullptr};
  JointForces forces;
  calc_joint_forces(joint, state, {c, c_rate}, &a, nullptr, forces);
  CHECK(std::abs(forces.tau[0] - (-3.0 * (qp - 0.1) - 0.5 * vp)) < 1e-14);
}

TEST_CASE("a stop takes over smoothly, and is a spring beyond its width") {
  JointPrimitive stopped;
  stopped.stop = {-0.5, 1.0, 8.0, 2.0, 0.25};
  const Joint joint = make_joint({}, std::span(&stopped, 1));
  const double v = 0.7;
  const auto forces_at = [&](double q) {
    const JointState state{&q, &v, nullptr, nullptr};
    const double a = 0.0;
    JointForces forces;
    calc_joint_forces(joint, state, {1.0, 0.0}, &a, nullptr, forces);
    return std::array<double, 3>{forces.tau[0], forces.share[0], calc_dissipation(joint, state)};
  };
  const auto expect = [&](double q, double spring, double share) {
    CAPTURE(q);
    const auto [force, stiffness, dissipation] = forces_at(q);
    CHECK(std::abs(force - (spring - 2.0 * share * v)) < 1e-14);
    CHECK(std::abs(stiffness - 8.0 * share) < 1e-14);
    CHECK(std::abs(dissipation - 2.0 * share * v * v) < 1e-14);
  };
  expect(0.3, 0.0, 0.0);
  expect(1.0, 0.0, 0.0);
  expect(1.125, -8.0 * 0.125 * 0.125 / 0.5, 0.5);
  expect(1.25, -8.0 * 0.125, 1.0);
  expect(2.0, -8.0 * 0.875, 1.0);
  expect(-1.5, 8.0 * 0.875, 1.0);
}

TEST_CASE("friction sets in smoothly, and falls by Stribeck's law") {
  JointPrimitive slider;
  slider.friction = {2.0, 3.0, 0.1, 0.5};
  const Joint joint = make_joint({}, std::span(&slider, 1));
  const auto force_at = [&](double v, bool by_secant) {
    const double q = 0.0, a = 0.0;
    JointForces forces;
    calc_joint_forces(joint, {&q, &v, nullptr, nullptr}, {0.0, 1.0, by_secant ? 1.0 : 0.0}, &a,
                      nullptr, forces);
    return forces;
  };
  for (const double v : {-2.0, -0.3, -0.05, 1e-9, 0.02, 0.15, 0.6}) {
    CAPTURE(v);
    const double size = (2.0 + std::exp(-v * v / 0.25)) * std::tanh(v / 0.1);
    const double h = 1e-5;
    const double slope =
        (force_at(v - h, false).tau[0] - force_at(v + h, false).tau[0]) / (2.0 * h);
    CHECK(std::abs(force_at(v, false).tau[0] + size) < 1e-14);
    CHECK(std::abs(force_at(v, false).share[0] - std::max(slope, 0.0)) < 1e-5);
    CHECK(std::abs(force_at(v, true).share[0] - std::max(size / v, slope)) < 1e-5);
    const double q = 0.0;
    CHECK(std::abs(calc_dissipation(joint, {&q, &v, nullptr, nullptr}) - size * v) < 1e-14);
  }
  CHECK(force_at(0.3, false).share[0] == 0.0);  // falls
  for (const bool by_secant : {false, true}) CHECK(force_at(0.0, by_secant).share[0] == 30.0);
}
