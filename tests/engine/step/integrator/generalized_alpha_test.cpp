#include "engine/step/integrator/generalized_alpha.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <vector>

using namespace spoke;

namespace {

/// Coordinates with their storage.
struct Coordinates {
  static constexpr int kSize = 3;
  std::array<std::vector<double>, 3 + GeneralizedAlpha::count> storage;
  CoordinateBlock block;

  Coordinates() {
    for (std::vector<double>& vector : storage) vector.assign(kSize, 0.0);
    block.size = kSize;
    block.q = storage[0].data();
    block.v = storage[1].data();
    block.a = storage[2].data();
    for (std::size_t k = 0; k < GeneralizedAlpha::count; ++k)
      block.history[k] = storage[3 + k].data();
  }
  const std::vector<double>& a() const { return storage[2]; }
};

using Values = std::vector<double>;

void make_step(const GeneralizedAlpha& method, const Values& a, Coordinates& y) {
  predict(method, 2, y.block);
  correct(method, a.data(), y.block);
}

}  // namespace

TEST_CASE("the predictor continues accelerations on a straight line") {
  const GeneralizedAlpha method = make_generalized_alpha(0.8, 0.01);
  Coordinates y;
  const Values first{1.0, -2.0, 0.5}, second{1.5, -2.0, 0.25}, third{7.0, 8.0, 9.0};
  complete_restart(method, first.data(), y.block);
  make_step(method, second, y);
  predict(method, 2, y.block);
  CHECK(y.a() == Values{2.0, -2.0, 0.0});
  // The coordinates are those of the predicted accelerations.
  const double qp = y.block.history[GeneralizedAlpha::predicted_q][0],
               vp = y.block.history[GeneralizedAlpha::predicted_v][0];
  CHECK(y.block.q[0] == doctest::Approx(qp + 2.0 * method.position_gain).epsilon(1e-14));
  CHECK(y.block.v[0] == doctest::Approx(vp + 2.0 * method.velocity_gain).epsilon(1e-14));
  // Iterations of a step leave the line that the next one continues.
  correct(method, first.data(), y.block);
  correct(method, third.data(), y.block);
  predict(method, 2, y.block);
  CHECK(y.a() == Values{12.5, 18.0, 17.75});
}

TEST_CASE("the predictor continues accelerations on a parabola, and as they are") {
  const GeneralizedAlpha method = make_generalized_alpha(0.8, 0.01);
  const auto parabola = [](double t) { return Values{1.0 + t * t, 2.0 * t - 3.0 * t * t, 0.5}; };
  Coordinates y;
  complete_restart(method, parabola(0.0).data(), y.block);
  for (const double t : {1.0, 2.0}) make_step(method, parabola(t), y);
  predict(method, 3, y.block);
  CHECK(y.a() == parabola(3.0));
  correct(method, parabola(3.0).data(), y.block);
  predict(method, 1, y.block);
  CHECK(y.a() == parabola(3.0));
}

TEST_CASE("what the predictor begins with changes no step, only what is left to correct") {
  const GeneralizedAlpha method = make_generalized_alpha(0.5, 0.1);
  Coordinates y, other;
  const Values first{1.0, -2.0, 0.5}, second{1.5, -2.0, 0.25};
  for (Coordinates* each : {&y, &other}) complete_restart(method, first.data(), each->block);
  for (int i = 0; i < Coordinates::kSize; ++i)
    other.block.history[GeneralizedAlpha::last_a][i] = 100.0 + i;
  make_step(method, second, y);
  make_step(method, second, other);
  CHECK(other.storage[0] == y.storage[0]);
  CHECK(other.storage[1] == y.storage[1]);
}

TEST_CASE("accelerations of a steady rise are predicted to their last digits") {
  const GeneralizedAlpha method = make_generalized_alpha(0.8, 0.01);
  Coordinates y;
  Values a(3, 1.0);
  complete_restart(method, a.data(), y.block);
  for (int n = 1; n < 6; ++n) {
    predict(method, 2, y.block);
    a.assign(3, 1.0 + 0.25 * n);
    const double change = correct(method, a.data(), y.block).change;
    if (n > 1) CHECK(change == 0.0);
  }
}

TEST_CASE("a restart takes no slope of the accelerations along") {
  const GeneralizedAlpha method = make_generalized_alpha(0.8, 0.01);
  Coordinates y;
  const Values first{1.0, -2.0, 0.5}, second{1.5, -2.0, 0.25}, jumped{-40.0, 3.0, 0.25};
  complete_restart(method, first.data(), y.block);
  make_step(method, second, y);
  begin_restart(method, y.block);
  complete_restart(method, jumped.data(), y.block);
  predict(method, 2, y.block);
  CHECK(y.a() == jumped);

  clear_accelerations(y.block);
  CHECK(y.a() == Values(3, 0.0));
  predict(method, 2, y.block);
  CHECK(y.a() == Values(3, 0.0));
}

TEST_CASE(
    "the change of a step is that since the accelerations of the last, whatever was predicted") {
  const GeneralizedAlpha method = make_generalized_alpha(0.8, 0.01);
  Coordinates y;
  const Values first{1.0, -2.0, 0.5}, second{1.5, -2.5, 0.25}, third{2.0, -3.0, -1.75};
  complete_restart(method, first.data(), y.block);
  make_step(method, second, y);
  predict(method, 2, y.block);
  CHECK(calc_step_change(method, third.data(), y.block) ==
        doctest::Approx(2.0 * method.position_gain).epsilon(1e-14));
  CHECK(calc_step_change(method, second.data(), y.block) == 0.0);
  // The correction is counted from what was predicted.
  CHECK(correct(method, third.data(), y.block).change ==
        doctest::Approx(1.75 * method.position_gain).epsilon(1e-14));
}
