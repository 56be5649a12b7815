// Orientations whose angular velocity is a given function of time.

#include "engine/step/integrator/rotation.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "models/space/rotation_vector.h"

using namespace spoke;
using namespace spoke::space;

namespace {

/// An orientation between two plain coordinates, whose accelerations are all given.
struct Turning {
  explicit Turning(TurnFrame frame) : rotation{&block, 1, &state, frame} {
    block.size = 5;
    block.q = storage.data();
    block.v = block.q + 5;
    block.a = block.v + 5;
    for (std::size_t k = 0; k < GeneralizedAlpha::count; ++k)
      block.history[k] = block.a + 5 * (k + 1);
    std::copy_n(velocity(0.0).data(), 5, block.v);
    std::copy_n(acceleration(0.0).data(), 5, block.a);
  }
  Turning(const Turning&) = delete;

  static std::array<double, 5> velocity(double t) {
    return {std::cos(t), std::sin(3 * t), 2.0 + std::cos(2 * t), 1.0 - t * t, -std::sin(t)};
  }
  static std::array<double, 5> acceleration(double t) {
    return {-std::sin(t), 3 * std::cos(3 * t), -2 * std::sin(2 * t), -2 * t, -std::cos(t)};
  }
  space::Rotation orientation() const { return make_rotation(calc_orientation(rotation)); }

  std::array<double, 5 * (3 + GeneralizedAlpha::count)> storage{};
  CoordinateBlock block;
  RotationState state;
  RotationBlock rotation;
};

void run(const Rk4& method, int steps, Turning& y) {
  for (int n = 0; n < steps; ++n)
    for (const int stage : {1, 2, 3, 0}) {
      advance(method, stage, y.rotation);
      const double node = stage == 0 ? 1.0 : Rk4::nodes[static_cast<std::size_t>(stage)];
      std::copy_n(Turning::acceleration((n + node) * method.step).data(), 5, y.block.a);
    }
}

void run(const GeneralizedAlpha& method, int steps, Turning& y) {
  clear_accelerations(y.block);
  complete_restart(method, Turning::acceleration(0.0).data(), y.block);
  for (int n = 1; n <= steps; ++n) {
    predict(method, 2, y.rotation);
    correct(method, Turning::acceleration(n * method.step).data(), y.block);
  }
}

/// The orientation at t = 1 by many small turns, each about the velocity in its middle, and one
/// step of Richardson's extrapolation to the limit.
Matrix3 integrate_finely(TurnFrame frame) {
  const auto integrate = [frame](int steps) {
    Quaternion Q;
    for (int n = 0; n < steps; ++n) {
      const std::array<double, 5> v = Turning::velocity((n + 0.5) / steps);
      Q = turn(Q, Angular(v[1], v[2], v[3]) / steps, frame);
    }
    return make_rotation(Q).axes;
  };
  return (4.0 * integrate(4000) - integrate(2000)) / 3.0;
}

template <class Method>
double calc_error(const Method& method, int steps, TurnFrame frame) {
  Turning y(frame);
  run(method, steps, y);
  return (y.orientation().axes - integrate_finely(frame)).norm();
}

}  // namespace

TEST_CASE("orientations of rk4 are of order 4, of generalized_alpha of order 2") {
  for (const TurnFrame frame : {TurnFrame::child, TurnFrame::parent}) {
    const double rk4 = calc_error(Rk4{0.02}, 50, frame);
    const double rk4_half = calc_error(Rk4{0.01}, 100, frame);
    CHECK(rk4_half < 1e-7);
    CHECK(rk4 / rk4_half > 14.0);
    CHECK(rk4 / rk4_half < 19.0);
    const double alpha = calc_error(make_generalized_alpha(0.8, 0.02), 50, frame);
    const double alpha_half = calc_error(make_generalized_alpha(0.8, 0.01), 100, frame);
    CHECK(alpha_half < 1e-3);
    CHECK(alpha / alpha_half > 3.6);
    CHECK(alpha / alpha_half < 4.4);
  }
}

TEST_CASE("the plain coordinates beside an orientation are integrated as they were without") {
  Turning y(TurnFrame::child), plain(TurnFrame::child);
  const Rk4 method{0.02};
  run(method, 50, y);
  for (int n = 0; n < 50; ++n)
    for (const int stage : {1, 2, 3, 0}) {
      spoke::advance(method, stage, plain.block);
      const double node = stage == 0 ? 1.0 : Rk4::nodes[static_cast<std::size_t>(stage)];
      std::copy_n(Turning::acceleration((n + node) * method.step).data(), 5, plain.block.a);
    }
  for (const int c : {0, 4}) {
    CHECK(y.block.q[c] == plain.block.q[c]);
    CHECK(y.block.v[c] == plain.block.v[c]);
  }
  for (const int c : {1, 2, 3}) CHECK(y.block.v[c] == plain.block.v[c]);
}

TEST_CASE("folding leaves an orientation as it is, of unit length") {
  Turning y(TurnFrame::parent);
  run(make_generalized_alpha(0.8, 0.1), 3, y);
  const Matrix3 before = y.orientation().axes;
  y.state.reference = (1.0 + 1e-12) * y.state.reference;
  fold(y.rotation);
  CHECK((y.orientation().axes - before).norm() < 2e-15);
  CHECK(Angular(y.block.q[1], y.block.q[2], y.block.q[3]).norm() == 0.0);
  CHECK(std::abs(y.state.reference.squared_norm() - 1.0) < 1e-15);
}
