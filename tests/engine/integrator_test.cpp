// The two methods on a single vibration y'' = -w^2 y, where everything is known.

#include <doctest/doctest.h>

#include <cmath>

#include "engine/integrator/generalized_alpha.h"
#include "engine/integrator/rk4.h"
#include "tests/approx.h"

using namespace spoke;
using spoke::testing::approx;

namespace {

/// One coordinate with its storage.
struct Vibration {
  double frequency;
  std::array<double, 7> storage{};
  CoordinateBlock block;

  explicit Vibration(double w) : frequency(w) {
    block.size = 1;
    block.q = &storage[0];
    block.v = &storage[1];
    block.a = &storage[2];
    for (int k = 0; k < 4; ++k) block.history[k] = &storage[3 + k];
    *block.q = 1.0;
    *block.a = -w * w;
  }
  double amplitude() const { return std::hypot(*block.q, *block.v / frequency); }
};

/// A step as the engine does it: the elastic force of the unknown acceleration goes to the left.
void step(const GeneralizedAlpha& method, Vibration& y) {
  predict(method, y.block);
  const double stiffness = y.frequency * y.frequency;
  const double a = -stiffness * *y.block.history[GeneralizedAlpha::predicted_q] /
                   (1.0 + method.position_gain * stiffness);
  correct(method, &a, y.block);
}

void step(const Rk4& method, Vibration& y) {
  for (const int stage : {1, 2, 3, 0}) {
    advance(method, stage, y.block);
    *y.block.a = -y.frequency * y.frequency * *y.block.q;
  }
}

template <class Method>
double error_at_one_second(Method method, int steps) {
  Vibration y(5.0);
  if constexpr (std::is_same_v<Method, GeneralizedAlpha>) start(method, y.block);
  for (int n = 0; n < steps; ++n) step(method, y);
  return std::abs(*y.block.q - std::cos(5.0));
}

}  // namespace

TEST_CASE("generalized_alpha damps infinite frequencies by its spectral radius") {
  for (const double radius : {0.0, 0.5, 0.8, 1.0}) {
    const GeneralizedAlpha method = make_generalized_alpha(radius, 1.0);
    Vibration y(1e5);
    start(method, y.block);
    // Positions of a triple root fall as n^2 radius^n: twice as far on 4 times as much. At radius 1
    // the roots still differ.
    double before = 0.0;
    for (int n = 0; n < 40; ++n) step(method, y);
    before = std::abs(*y.block.q);
    for (int n = 0; n < 40; ++n) step(method, y);
    const double rate = std::pow(std::abs(*y.block.q) / std::max(before, 1e-300), 1.0 / 40);
    CAPTURE(radius);
    const double growth = radius < 1.0 ? std::pow(4.0, 1.0 / 40) : 1.0;
    if (radius > 0.0) CHECK(rate == approx(radius * growth).epsilon(0.003));
    if (radius == 0.0) CHECK(std::abs(*y.block.q) < 1e-9);
  }
}

TEST_CASE("generalized_alpha with spectral radius 1 keeps every amplitude") {
  const GeneralizedAlpha method = make_generalized_alpha(1.0, 0.1);
  for (const double frequency : {1.0, 10.0, 1000.0}) {
    Vibration y(frequency);
    start(method, y.block);
    double largest = 0.0;
    for (int n = 0; n < 5000; ++n) {
      step(method, y);
      if (n > 4000) largest = std::max(largest, std::abs(*y.block.q));
    }
    CAPTURE(frequency);
    CHECK(largest < 2.5);
    CHECK(largest > 0.9);
  }
}

TEST_CASE("both methods converge at their order") {
  for (const double radius : {0.0, 0.8, 1.0}) {
    const double coarse = error_at_one_second(make_generalized_alpha(radius, 1.0 / 200), 200);
    const double fine = error_at_one_second(make_generalized_alpha(radius, 1.0 / 400), 400);
    CHECK(std::log2(coarse / fine) == approx(2.0).epsilon(0.05));
  }
  const double coarse = error_at_one_second(Rk4{1.0 / 50}, 50);
  const double fine = error_at_one_second(Rk4{1.0 / 100}, 100);
  CHECK(std::log2(coarse / fine) == approx(4.0).epsilon(0.05));
}

TEST_CASE("rk4 is stable up to 2 sqrt(2) over the frequency and not beyond") {
  const double limit = 2.0 * std::sqrt(2.0);
  for (const double factor : {0.99, 1.01}) {
    Vibration y(1.0);
    const Rk4 method{factor * limit};
    for (int n = 0; n < 500; ++n) step(method, y);
    CHECK((y.amplitude() <= 1.0) == (factor < 1.0));
  }
}
