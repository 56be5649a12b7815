// A sampled proportional-integral law, and a cubic B-spline through its demands.

#include "engine/bodies/kernels/pitch_control.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace spoke {
namespace {

/// Returns the share of the old value that a low-pass of this corner frequency [rad/s] keeps within
/// a time [s].
double kept_share(const PitchControl& control, double period) {
  return control.filter ? std::exp(-*control.filter * period) : 0.0;
}

}  // namespace

ControlState start_control(const PitchControl& control) {
  ControlState state = start_angle(control.initial);
  state.speed = control.speed;
  state.integral = control.initial;
  return state;
}

ControlState start_angle(double initial) {
  ControlState state;
  state.demands.fill(initial);
  return state;
}

std::int64_t count_sample_steps(const std::optional<double>& period, double h) {
  assert(h > 0.0);
  if (!period) return 1;
  return std::max<std::int64_t>(1, std::llround(*period / h));
}

void demand_angle(double angle, double t, double period, ControlState& state) noexcept {
  assert(period > 0.0);
  std::shift_left(state.demands.begin(), state.demands.end(), 1);
  state.demands.back() = angle;
  state.since = t;
  state.period = period;
}

void hold_angle(double t, double h, ControlState& state) noexcept {
  assert(h > 0.0);
  const space::PrescribedMotion now = follow(state, t);
  // Of the points before the next demand, those of a spline that has this motion at t.
  const double middle = now.value - now.acceleration * h * h / 6.0;
  const double mean = middle + 0.5 * now.acceleration * h * h;
  state.demands = {middle, mean - h * now.rate, middle, mean + h * now.rate};
  state.since = t;
  state.period = h;
  state.held = 1.0;
}

void take_sample(const PitchControl& control, double speed, double t, double period, bool is_first,
                 ControlState& state) noexcept {
  assert(period > 0.0);
  const double kept = is_first ? 0.0 : kept_share(control, period);
  state.speed = kept * state.speed + (1.0 - kept) * speed;
  const double error = std::copysign(1.0, control.speed) * (state.speed - control.speed);
  const double before = state.demands.back();
  const double gain = calc_gain_factor(control, before);
  const auto limit = [&control](double angle) {
    return std::clamp(angle, control.minimum, control.maximum);
  };
  const double proportional = gain * control.proportional * error;
  const double integral = limit(state.integral + gain * control.integral * period * error);
  double change = limit(integral + proportional) - before;
  const double most = control.rate ? *control.rate * period : std::abs(change);
  // Where the rate is at its limit, the integral does not go on in its direction.
  const bool winds_up = std::abs(change) > most && (integral - state.integral) * change > 0.0;
  if (!winds_up) state.integral = integral;
  change = std::clamp(change, -most, most);
  demand_angle(limit(before + change), t, period, state);
}

space::PrescribedMotion follow(const ControlState& state, double t) noexcept {
  // The uniform cubic B-spline of four control points, x from 0 to 1 within the period.
  const auto& [p0, p1, p2, p3] = state.demands;
  const double x = (t - state.since) / state.period;
  const double d0 = p1 - p0, d1 = p2 - p1, d2 = p3 - p2;  // of its rate
  const double e0 = d1 - d0, e1 = d2 - d1;                // of its acceleration
  const double y = 1.0 - x;
  const double rate = 0.5 * (y * y * d0 + (1.0 + 2.0 * x * y) * d1 + x * x * d2);
  // Where all points are equal, the angle is theirs to the last bit.
  const double value =
      p1 + (x * x * x * d2 + (1.0 + x * (3.0 + x * (3.0 - 2.0 * x))) * d1 - y * y * y * d0) / 6.0;
  return {value, rate / state.period, (y * e0 + x * e1) / (state.period * state.period)};
}

}  // namespace spoke
