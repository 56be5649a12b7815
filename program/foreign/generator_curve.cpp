// Points lie close to each other beside corners, so that the smooth curve through them turns there.

#include "program/foreign/generator_curve.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace spoke::foreign {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
/// The distance of points beside a corner, by the length of a piece.
constexpr double kBeside = 0.01;

}  // namespace

double VariableSpeed::transition() const {
  constexpr double least = 1e-9;
  if (!(slip > least)) return rated_speed;
  const double synchronous = rated_speed / (1.0 + slip);
  const double slope = rated_torque / (rated_speed - synchronous);
  if (square == 0.0) return synchronous;
  const double root = std::sqrt(std::max(0.0, slope * (slope - 4.0 * square * synchronous)));
  return std::clamp((slope - root) / (2.0 * square), synchronous, rated_speed);
}

double VariableSpeed::torque_at(double w) const {
  if (w >= rated_speed) return rated_torque;
  const double from = transition();
  if (w <= from) return w > 0.0 ? square * w * w : 0.0;
  const double synchronous = rated_speed / (1.0 + slip);
  return rated_torque * (w - synchronous) / (rated_speed - synchronous);
}

TorqueCurve VariableSpeed::points() const {
  constexpr int pieces = 32;
  const double from = transition(), width = from / pieces;
  std::vector<double> speeds;
  for (int i = 0; i < pieces; ++i) speeds.push_back(width * i);
  for (const double before : {2.0, 1.0}) speeds.push_back(from - before * kBeside * width);
  const double line = rated_speed - from;
  const double step = std::max(kBeside * line, 1e-6 * rated_speed);
  speeds.push_back(from);
  if (line > 4.0 * step)
    speeds.insert(speeds.end(), {from + step, rated_speed - step, rated_speed});
  else if (line > 0.0)
    speeds.push_back(rated_speed);
  TorqueCurve curve;
  for (const double w : speeds)
    curve.add(w, w == from && from < rated_speed ? square * w * w : torque_at(w));
  curve.add(rated_speed + step, rated_torque);
  return curve;
}

TorqueCurve InductionGenerator::points() const {
  const double range = slip * synchronous_speed * pull_out, most = rated_torque * pull_out;
  TorqueCurve curve;
  curve.add(synchronous_speed - (1.0 + kBeside) * range, -most);
  for (const double share : {-1.0, -1.0 + kBeside, 1.0 - kBeside, 1.0})
    curve.add(synchronous_speed + share * range, share * most);
  curve.add(synchronous_speed + (1.0 + kBeside) * range, most);
  return curve;
}

double TheveninGenerator::torque_at(double w) const {
  using Complex = std::complex<double>;
  const double synchronous = 2.0 * kTwoPi * frequency / poles;
  const double slip = (synchronous - w) / synchronous;
  if (slip == 0.0) return 0.0;
  const Complex stator(stator_resistance, stator_reactance),
      magnetizing(0.0, magnetizing_reactance);
  const Complex impedance = stator * magnetizing / (stator + magnetizing);
  const double voltage =
      line_voltage / std::sqrt(3.0) * std::abs(magnetizing / (stator + magnetizing));
  const double resistance = rotor_resistance / slip;
  const double current = voltage / std::abs(impedance + Complex(resistance, rotor_reactance));
  return -3.0 * current * current * resistance / synchronous;
}

TorqueCurve TheveninGenerator::points() const {
  constexpr int pieces = 100;
  const double synchronous = 2.0 * kTwoPi * frequency / poles;
  // Points are close to each other within the slip of the largest torque, about.
  const double bend = rotor_resistance / (stator_reactance + rotor_reactance);
  const double most = std::asinh(1.0 / bend);
  TorqueCurve curve;
  for (int i = -pieces; i <= pieces; ++i) {
    const double slip = bend * std::sinh(most * i / pieces);
    curve.add(synchronous * (1.0 + slip), torque_at(synchronous * (1.0 + slip)));
  }
  return curve;
}

}  // namespace spoke::foreign
