// The two methods on a single vibration y'' = -w^2 (y + D y') + force, where everything is known.

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <vector>

#include "engine/step/integrator/generalized_alpha.h"
#include "engine/step/integrator/rk4.h"
#include "tests/approx.h"

using namespace spoke;
using spoke::testing::approx;

namespace {

/// One coordinate with its storage.
struct Vibration {
  double frequency;      // rad/s
  double damping = 0.0;  // share of the stiffness [s]
  double force = 0.0;    // per mass [m/s^2]
  std::array<double, 3 + GeneralizedAlpha::count> storage{};
  CoordinateBlock block;

  explicit Vibration(double w) : frequency(w) {
    block.size = 1;
    block.q = &storage[0];
    block.v = &storage[1];
    block.a = &storage[2];
    for (std::size_t k = 0; k < GeneralizedAlpha::count; ++k) block.history[k] = &storage[3 + k];
    *block.q = 1.0;
    *block.a = -w * w;
  }
  double amplitude() const { return std::hypot(*block.q, *block.v / frequency); }
  /// Beside the force's own rest position, strain and kinetic energy per mass.
  double energy() const {
    const double y = *block.q - force / (frequency * frequency);
    return 0.5 * (frequency * frequency * y * y + *block.v * *block.v);
  }
};

/// The acceleration that the engine's implicit pass finds: forces of the unknown one on the left.
double solve(const GeneralizedAlpha& method, const Vibration& y) {
  const double stiffness = y.frequency * y.frequency;
  const double q = *y.block.history[GeneralizedAlpha::predicted_q];
  const double v = *y.block.history[GeneralizedAlpha::predicted_v];
  return (y.force - stiffness * (q + y.damping * v)) /
         (1.0 + stiffness * (method.position_gain + y.damping * method.velocity_gain));
}

void restart(const GeneralizedAlpha& method, Vibration& y) {
  begin_restart(method, y.block);
  const double a = solve(method, y);
  complete_restart(method, &a, y.block);
}

void start(const GeneralizedAlpha& method, Vibration& y) {
  clear_accelerations(y.block);
  restart(method, y);
}

/// With all of the amplitude in the vibration, whether the step resolves it or not.
void start_with_true_acceleration(const GeneralizedAlpha& method, Vibration& y) {
  clear_accelerations(y.block);
  const double a = y.force - y.frequency * y.frequency * *y.block.q;
  complete_restart(method, &a, y.block);
}

void step(const GeneralizedAlpha& method, Vibration& y) {
  predict(method, 2, y.block);
  const double a = solve(method, y);
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
  if constexpr (std::is_same_v<Method, GeneralizedAlpha>) start(method, y);
  for (int n = 0; n < steps; ++n) step(method, y);
  return std::abs(*y.block.q - std::cos(5.0));
}

}  // namespace

TEST_CASE("generalized_alpha damps infinite frequencies by its spectral radius") {
  for (const double radius : {0.0, 0.5, 0.8, 1.0}) {
    const GeneralizedAlpha method = make_generalized_alpha(radius, 1.0);
    Vibration y(1e5);
    start_with_true_acceleration(method, y);
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
    start_with_true_acceleration(method, y);
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

TEST_CASE("a sudden force strains what a step does not resolve no more than what it resolves") {
  for (const double radius : {0.0, 0.3, 0.8, 1.0})
    for (const double frequency : {0.01, 1.0, 100.0, 1e5})
      for (const double damping : {0.0, 0.02, 10.0}) {
        CAPTURE(radius);
        CAPTURE(frequency);
        CAPTURE(damping);
        const GeneralizedAlpha method = make_generalized_alpha(radius, 1.0);
        Vibration y(frequency);
        y.damping = damping;
        y.force = 1.0;
        *y.block.q = 0.0;
        const double before = y.energy();
        start(method, y);
        // In a quarter of a period of what is resolved, and long after what is not.
        double largest = 0.0;
        for (int n = 0; n < 200; ++n) {
          step(method, y);
          largest = std::max(largest, y.energy());
        }
        CHECK(largest <= 1.01 * before);
      }
}

TEST_CASE("a restart without a jump of forces changes nothing") {
  for (const double radius : {0.0, 0.8, 1.0}) {
    const GeneralizedAlpha method = make_generalized_alpha(radius, 0.1);
    for (const double frequency : {1.0, 1e4}) {
      Vibration once(frequency), always(frequency);
      once.damping = always.damping = 1e-3;
      start(method, once);
      start(method, always);
      for (int n = 0; n < 100; ++n) {
        step(method, once);
        step(method, always);
        restart(method, always);
      }
      CHECK(*always.block.q == approx(*once.block.q).epsilon(1e-10));
    }
  }
}

TEST_CASE("generalized_alpha keeps its order where the force jumps between two steps") {
  // From rest at 0 to a force of 1 at t = 0.5, then y = (1 - cos(5 (t - 0.5))) / 25.
  const auto error = [](double radius, int steps) {
    const GeneralizedAlpha method = make_generalized_alpha(radius, 1.0 / steps);
    Vibration y(5.0);
    *y.block.q = 0.0;
    start(method, y);
    for (int n = 0; n < steps; ++n) {
      if (2 * n == steps) {
        y.force = 1.0;
        restart(method, y);
      }
      step(method, y);
    }
    return std::abs(*y.block.q - (1.0 - std::cos(2.5)) / 25.0);
  };
  for (const double radius : {0.0, 0.8, 1.0}) {
    CAPTURE(radius);
    CHECK(std::log2(error(radius, 200) / error(radius, 400)) == approx(2.0).epsilon(0.05));
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

TEST_CASE("generalized_alpha lengthens the period and damps by its closed forms") {
  constexpr double kAngle = 0.08;  // w h
  for (const double radius : {0.0, 0.3, 0.5, 0.8, 1.0}) {
    CAPTURE(radius);
    const GeneralizedAlpha method = make_generalized_alpha(radius, kAngle);
    Vibration y(1.0);
    start(method, y);
    for (int n = 0; n < 100; ++n) step(method, y);  // till the method's third root is gone
    std::array<double, 4> q{};
    for (double& value : q) {
      value = *y.block.q;
      step(method, y);
    }
    // q_n+1 = sum q_n - product q_n-1, of the two roots exp((-ratio +- i) angle).
    const double determinant = q[0] * q[2] - q[1] * q[1];
    const double product = (q[1] * q[3] - q[2] * q[2]) / determinant;
    const double sum = (q[0] * q[3] - q[1] * q[2]) / determinant;
    const double angle = std::acos(0.5 * sum / std::sqrt(product));
    const double d = (1.0 - radius) / (1.0 + radius);
    CHECK(kAngle / angle - 1.0 ==
          approx((1.0 / 12 + 0.375 * d * d) * kAngle * kAngle).epsilon(0.02));
    const double ratio = -0.5 * std::log(product) / kAngle;
    CHECK(ratio == approx(0.5 * std::pow(d * kAngle, 3)).epsilon(0.04).scale(1e-6));
  }
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

namespace {

/// Random coordinates in two parts of n, with zeros before, between and behind them.
struct PaddedBlock {
  static constexpr int kPad = 4;
  // q, v, a, history, new accelerations
  std::array<std::vector<double>, 4 + GeneralizedAlpha::count> storage;
  CoordinateBlock block;

  PaddedBlock(int n, std::mt19937& random) {
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    block.size = 2 * n + 3 * kPad;
    block.margin = kPad;
    block.gap_begin = kPad + n;
    block.gap_end = 2 * kPad + n;
    for (std::vector<double>& vector : storage)
      for (int i = 0; i < block.size; ++i) vector.push_back(is_padding(i) ? 0.0 : unit(random));
    block.q = storage[0].data();
    block.v = storage[1].data();
    block.a = storage[2].data();
    for (std::size_t k = 0; k < GeneralizedAlpha::count; ++k)
      block.history[k] = storage[3 + k].data();
  }
  bool is_padding(int i) const {
    return i < block.margin || i >= block.size - block.margin ||
           (i >= block.gap_begin && i < block.gap_end);
  }
  const double* found() const { return storage.back().data(); }
};

/// Applies `apply(block, new accelerations)` to a block, and to each coordinate of a copy alone:
/// all values must be the same, the largest result the block's, and the padding zero.
template <class Apply>
void check_alone(const Apply& apply) {
  std::mt19937 random(5);
  for (const int n : {1, 2, 3, 4, 7, 16}) {
    CAPTURE(n);
    std::mt19937 again = random;
    PaddedBlock whole(n, random), single(n, again);
    const double result = apply(whole.block, whole.found());
    double largest = 0.0;
    for (int i = 0; i < single.block.size; ++i) {
      if (single.is_padding(i)) continue;
      CoordinateBlock one = single.block.component(i);
      largest = std::max(largest, apply(one, single.found() + i));
    }
    CHECK(result == largest);
    CHECK(whole.storage == single.storage);
    for (const std::vector<double>& vector : whole.storage)
      for (int i = 0; i < whole.block.size; ++i)
        if (whole.is_padding(i)) CHECK(vector[static_cast<std::size_t>(i)] == 0.0);
  }
}

}  // namespace

TEST_CASE("each coordinate of a block is integrated as if it were alone") {
  const GeneralizedAlpha alpha = make_generalized_alpha(0.8, 0.005);
  for (const int order : {1, 2, 3})
    check_alone([&](CoordinateBlock& block, const double*) {
      predict(alpha, order, block);
      return 0.0;
    });
  check_alone([&](CoordinateBlock& block, const double* found) {
    return correct(alpha, found, block).change;
  });
  for (const int stage : {0, 1, 2, 3})
    check_alone([stage](CoordinateBlock& block, const double*) {
      advance(Rk4{1e-3}, stage, block);
      return 0.0;
    });
}
