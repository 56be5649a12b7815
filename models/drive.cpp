// Angle, speed, acceleration and torque of each kind of drive at a time.

#include "models/drive.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace spoke {
namespace {

using std::numbers::pi;

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;  // for Clang 14

/// The ramp of (P 12), its factor corrected to Ts/(2 pi), as a fraction of the way from rest to
/// full speed: for tau = t/Ts from 0 to 1, in units of ws Ts [rad], ws [rad/s] and ws/Ts [rad/s^2].
struct Ramp {
  double angle;         ///< tau^2/2 + (cos(2 pi tau) - 1)/(4 pi^2)
  double speed;         ///< tau - sin(2 pi tau)/(2 pi)
  double acceleration;  ///< 1 - cos(2 pi tau)
};

Ramp calc_ramp(double tau) {
  const double sine = std::sin(pi * tau);
  return {tau * tau / 2.0 - sine * sine / (2.0 * pi * pi), calc_rise(tau, 1.0), 2.0 * sine * sine};
}

DriveMotion calc_spin_up(double speed, double ramp, double t) {
  if (t >= ramp) return {speed * (t - ramp / 2.0), speed, 0.0};
  if (t <= 0.0) return {};
  const Ramp r = calc_ramp(t / ramp);
  return {speed * ramp * r.angle, speed * r.speed, speed / ramp * r.acceleration};
}

DriveMotion calc_up_and_down(const SpinUpHoldSpinDown& drive, double t) {
  const double start_down = drive.ramp + drive.hold;
  if (t <= start_down) return calc_spin_up(drive.speed, drive.ramp, t);
  // The way down is a spin-up seen backwards from the time of rest.
  const double rest = start_down + drive.ramp_down;
  const double total = drive.speed * (drive.ramp / 2.0 + drive.hold + drive.ramp_down / 2.0);
  const DriveMotion mirrored = calc_spin_up(drive.speed, drive.ramp_down, rest - t);
  return {total - mirrored.angle, mirrored.speed, -mirrored.acceleration};
}

}  // namespace

bool turns_hub(const Drive& drive) {
  if (std::holds_alternative<FixedDrive>(drive)) return false;
  const auto* coasting = std::get_if<FreeDrive>(&drive);
  return !coasting || coasting->initial_speed != 0.0;
}

bool prescribes_motion(const Drive& drive) {
  return !std::holds_alternative<TorqueDrive>(drive) &&
         !std::holds_alternative<TorqueBySpeed>(drive) && !std::holds_alternative<FreeDrive>(drive);
}

DriveMotion calc_motion(const Drive& drive, double t) {
  assert(prescribes_motion(drive));
  return std::visit(
      Overloaded{[&](const SpinUp& d) { return calc_spin_up(d.speed, d.ramp, t); },
                 [&](const SpinUpHoldSpinDown& d) { return calc_up_and_down(d, t); },
                 [&](const SpeedTable& d) {
                   return DriveMotion{d.speed.integral(t), d.speed.value(t), d.speed.derivative(t)};
                 },
                 [&](const ConstantSpeed& d) {
                   return DriveMotion{d.speed * t, d.speed, 0.0};
                 },
                 [](const auto&) { return DriveMotion{}; }},
      drive);
}

double calc_torque(const Brake& brake, double speed) {
  const double x = std::clamp(speed / brake.speed, -1.0, 1.0);
  return -brake.torque * x * (1.5 - 0.5 * x * x);
}

double calc_torque(const Drive& drive, double t, double speed) {
  const auto braked = [speed](double torque, const Brake& brake) {
    return brake.torque > 0.0 ? torque + calc_torque(brake, speed) : torque;
  };
  if (const auto* torque = std::get_if<TorqueDrive>(&drive))
    return braked(torque->torque.value(t), torque->brake);
  const auto* by_speed = std::get_if<TorqueBySpeed>(&drive);
  if (by_speed == nullptr) return 0.0;
  return braked(by_speed->torque.value(speed) * calc_rise(t, by_speed->ramp), by_speed->brake);
}

double calc_initial_speed(const Drive& drive) {
  return std::visit(Overloaded{[](const TorqueDrive& d) { return d.initial_speed; },
                               [](const TorqueBySpeed& d) { return d.initial_speed; },
                               [](const FreeDrive& d) { return d.initial_speed; },
                               [&](const auto&) { return calc_motion(drive, 0.0).speed; }},
                    drive);
}

std::string_view name_of(const Drive& drive) {
  return std::visit(
      Overloaded{[](const SpinUp&) { return "spin_up"; },
                 [](const SpinUpHoldSpinDown&) { return "spin_up_hold_spin_down"; },
                 [](const SpeedTable&) { return "table"; },
                 [](const TorqueDrive&) { return "torque"; },
                 [](const FreeDrive&) { return "free"; }, [](const FixedDrive&) { return "fixed"; },
                 [](const ConstantSpeed&) { return "constant"; },
                 [](const TorqueBySpeed&) { return "torque_by_speed"; }},
      drive);
}

}  // namespace spoke
