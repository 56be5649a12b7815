// The law of a pitch controller against what its documents say, sample by sample.

#include "engine/bodies/kernels/pitch_control.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "tests/approx.h"

using namespace spoke;
using doctest::Approx;

namespace {

constexpr double kPeriod = 0.02;

PitchControl make_control() {
  PitchControl control;
  control.speed = 1.2;
  control.proportional = 2.0;
  control.integral = 0.8;
  control.minimum = 0.0;
  control.maximum = 1.5;
  return control;
}

/// Takes samples of speeds one after another, and returns the demands.
std::vector<double> demands_of(const PitchControl& control, const std::vector<double>& speeds) {
  ControlState state = start_control(control);
  std::vector<double> demands;
  for (std::size_t k = 0; k < speeds.size(); ++k) {
    take_sample(control, speeds[k], static_cast<double>(k) * kPeriod, kPeriod, k == 0, state);
    demands.push_back(state.demands.back());
  }
  return demands;
}

/// Speeds of a walk at random about the set point.
std::vector<double> random_speeds(double set_point, std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> change(0.0, 0.05);
  std::vector<double> speeds{set_point};
  while (speeds.size() < count)
    speeds.push_back(set_point + 0.95 * (speeds.back() - set_point) + change(random));
  return speeds;
}

}  // namespace

TEST_CASE("a constant error gives a demand by the proportional part and one that rises") {
  const PitchControl control = make_control();
  const std::vector<double> demands = demands_of(control, std::vector<double>(50, 1.3));
  for (std::size_t k = 0; k < demands.size(); ++k) {
    const double time = static_cast<double>(k + 1) * kPeriod;
    CHECK(demands[k] == Approx(2.0 * 0.1 + 0.8 * 0.1 * time));
  }
}

TEST_CASE("gains fall by the schedule, at the angle demanded before") {
  PitchControl control = make_control();
  control.initial = 0.3;
  const auto first_change = [&] { return demands_of(control, {1.3}).front() - 0.3; };
  const double full = first_change();
  control.half_gain_angle = 0.3;
  CHECK(first_change() == Approx(full / 2.0));
  control.half_gain_angle.reset();
  control.schedule = Curve({0.0, 0.2, 0.4}, {1.0, 0.8, 0.6});
  CHECK(first_change() == Approx(full * 0.7));
  control.initial = 0.9;  // beyond the schedule
  CHECK(demands_of(control, {1.3}).front() - 0.9 == Approx(full * 0.6));
}

TEST_CASE("a rotor that turns the other way has the same demands") {
  PitchControl control = make_control();
  control.initial = 0.4;
  std::vector<double> speeds = random_speeds(control.speed, 200, 1);
  const std::vector<double> demands = demands_of(control, speeds);
  control.speed = -control.speed;
  for (double& speed : speeds) speed = -speed;
  CHECK(demands_of(control, speeds) == demands);
}

TEST_CASE("the low-pass answers a step as a filter of first order") {
  PitchControl control = make_control();
  control.integral = 0.0;
  control.filter = 3.0;
  std::vector<double> speeds(100, 1.7);
  speeds.front() = 1.2;
  const std::vector<double> demands = demands_of(control, speeds);
  for (std::size_t k = 0; k < demands.size(); ++k)
    CHECK(demands[k] ==
          Approx(2.0 * 0.5 * (1.0 - std::exp(-3.0 * static_cast<double>(k) * kPeriod))));
}

TEST_CASE("angles and rates stay within their limits, and the angle is smooth") {
  PitchControl control = make_control();
  control.maximum = 0.4;
  control.rate = 0.5;
  control.initial = 0.1;
  constexpr double slack = 1e-12;
  ControlState state = start_control(control);
  space::PrescribedMotion before{0.1, 0.0, 0.0};
  double greatest_rate = 0.0;
  const std::vector<double> speeds = random_speeds(1.25, 2000, 2);
  for (std::size_t k = 0; k < speeds.size(); ++k) {
    const double t = static_cast<double>(k) * kPeriod;
    take_sample(control, speeds[k], t, kPeriod, k == 0, state);
    const space::PrescribedMotion begin = follow(state, t);
    CHECK(begin.value == Approx(before.value).epsilon(slack));
    CHECK(std::abs(begin.rate - before.rate) < 1e-10);
    CHECK(std::abs(begin.acceleration - before.acceleration) < 1e-7);
    for (int i = 0; i <= 8; ++i) {
      const space::PrescribedMotion motion = follow(state, t + 0.125 * i * kPeriod);
      CHECK(motion.value >= control.minimum - slack);
      CHECK(motion.value <= control.maximum + slack);
      CHECK(std::abs(motion.rate) <= *control.rate * (1.0 + 1e-9));
      greatest_rate = std::max(greatest_rate, std::abs(motion.rate));
    }
    before = follow(state, t + kPeriod);
  }
  CHECK(greatest_rate > 0.99 * *control.rate);  // it was at the limit
}

TEST_CASE("rate and acceleration are derivatives of the angle") {
  const PitchControl control = make_control();
  ControlState state = start_control(control);
  const std::vector<double> speeds = random_speeds(1.3, 20, 3);
  for (std::size_t k = 0; k < speeds.size(); ++k)
    take_sample(control, speeds[k], static_cast<double>(k) * kPeriod, kPeriod, k == 0, state);
  constexpr double step = 1e-5;
  for (const double x : {0.1, 0.4, 0.9}) {
    const double t = state.since + x * kPeriod;
    const auto [value, rate, acceleration] = follow(state, t);
    const auto next = follow(state, t + step), last = follow(state, t - step);
    CHECK((next.value - last.value) / (2.0 * step) == Approx(rate).epsilon(1e-6));
    CHECK((next.rate - last.rate) / (2.0 * step) == Approx(acceleration).epsilon(1e-6));
  }
}

TEST_CASE("a demand that grows evenly is followed two samples later") {
  const PitchControl control = make_control();
  ControlState state = start_control(control);
  for (int k = 0; k < 50; ++k) take_sample(control, 1.3, k * kPeriod, kPeriod, k == 0, state);
  const double rise = 0.8 * 0.1;
  const auto [value, rate, acceleration] = follow(state, state.since + 0.3 * kPeriod);
  CHECK(value == Approx(state.demands.back() - rise * 1.7 * kPeriod));
  CHECK(rate == Approx(rise));
  CHECK(std::abs(acceleration) < 1e-9);
}

TEST_CASE("the integral does not wind up at the limits of angle and rate") {
  PitchControl control = make_control();
  control.maximum = 0.2;
  control.rate = 0.3;
  // Long above the set point, and then as much below it: the demand leaves the limit at once.
  std::vector<double> speeds(500, 1.5);
  speeds.insert(speeds.end(), 3, 1.1);
  const std::vector<double> demands = demands_of(control, speeds);
  CHECK(demands[499] == 0.2);
  CHECK(demands[500] == Approx(0.2 - 0.3 * kPeriod));
  // While the rate is at its limit, the integral waits.
  control.maximum = 1.5;
  ControlState state = start_control(control);
  for (int k = 0; k < 20; ++k) take_sample(control, 1.5, k * kPeriod, kPeriod, k == 0, state);
  CHECK(state.demands.back() == Approx(20 * 0.3 * kPeriod));
  CHECK(state.integral == 0.0);
}

TEST_CASE("samples are taken every whole number of steps") {
  PitchControl control = make_control();
  CHECK(count_sample_steps(control.period, 0.01) == 1);
  control.period = 0.02;
  CHECK(count_sample_steps(control.period, 0.01) == 2);
  CHECK(count_sample_steps(control.period, 0.008) == 3);  // 2.5, away from zero
  CHECK(count_sample_steps(control.period, 0.1) == 1);
}
