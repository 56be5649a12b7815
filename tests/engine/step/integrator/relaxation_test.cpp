// Iterations that swing: how they are damped.

#include "engine/step/integrator/relaxation.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace spoke;

namespace {

/// Passes until an iteration whose errors are multiplied by these factors has converged.
template <std::size_t n>
int count_passes(const std::array<double, n>& factors, bool relaxes) {
  std::array<double, n> errors;
  errors.fill(1.0);
  StepProgress progress;
  for (int pass = 1; pass <= 200; ++pass) {
    double change = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      const double residual = (factors[i] - 1.0) * errors[i];
      change = std::max(change, std::abs(residual));
      errors[i] += progress.control.relaxation * residual;
    }
    progress.passes = pass;
    if (change <= 1e-10) return pass;
    learn_contraction(change, progress);
    progress.change = change;
    progress.share_before = progress.control.relaxation;
    progress.control.relaxation = relaxes ? choose_share(progress) : 1.0;
  }
  return 200;
}

}  // namespace

TEST_CASE("relaxation: swinging iterations converge in half as many passes, and beyond 1") {
  const std::array<double, 4> slow{-0.74, -0.5, -0.2, 0.01};
  CHECK(count_passes(slow, false) > 70);
  CHECK(count_passes(slow, true) < 30);
  const std::array<double, 4> beyond{-1.3, -0.9, -0.4, 0.01};
  CHECK(count_passes(beyond, false) == 200);
  CHECK(count_passes(beyond, true) < 60);
}

TEST_CASE("relaxation: iterations that converge fast, or from one side, stay as good") {
  const std::array<double, 3> fast{-1e-4, 1e-5, 3e-5};
  CHECK(count_passes(fast, true) == count_passes(fast, false));
  const std::array<double, 2> one_sided{0.5, 0.1};
  CHECK(count_passes(one_sided, true) < 2 * count_passes(one_sided, false));
}

TEST_CASE("relaxation: a share of a correction goes a share of the way, and tells the whole") {
  const GeneralizedAlpha method = make_generalized_alpha(0.8, 0.01);
  double q[2] = {0.0, 0.0}, v[2] = {0.0, 0.0}, a[2] = {1.0, -2.0};
  double qp[2] = {0.1, 0.2}, vp[2] = {0.3, 0.4}, carry[2] = {0.0, 0.0};
  CoordinateBlock block;
  block.q = q;
  block.v = v;
  block.a = a;
  block.size = 2;
  block.history[GeneralizedAlpha::predicted_q] = qp;
  block.history[GeneralizedAlpha::predicted_v] = vp;
  block.history[GeneralizedAlpha::carry_over] = carry;
  const double found[2] = {3.0, -2.5};
  const Correction correction = correct_relaxed(method, 0.5, found, block);
  CHECK(a[0] == 2.0);
  CHECK(a[1] == -2.25);
  CHECK(q[0] == doctest::Approx(0.1 + method.position_gain * 2.0));
  CHECK(v[1] == doctest::Approx(0.4 - method.velocity_gain * 2.25));
  CHECK(correction.change == doctest::Approx(method.position_gain * 2.0));
  CHECK(correction.squares == doctest::Approx(q[0] * q[0] + q[1] * q[1]));
}
