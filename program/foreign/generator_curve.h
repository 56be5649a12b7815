#pragma once

// Torque of generators by their speed, as points of a curve.

#include <string>
#include <vector>

namespace spoke::foreign {

/// Points of a curve: speeds, increasing, and torques that brake [rad/s, N m].
struct TorqueCurve {
  std::vector<double> speed, torque;
  void add(double w, double t) {
    speed.push_back(w);
    torque.push_back(t);
  }
};

/// A torque that grows with the square of the speed up to where a straight line takes over, which
/// leads from the synchronous speed, of no torque, to the rated one; constant beyond.
struct VariableSpeed {
  double rated_speed = 0.0;   ///< [rad/s], > 0
  double rated_torque = 0.0;  ///< [N m], > 0
  double square =
      0.0;            ///< torque by the speed squared [N m s^2], 0 to rated_torque / rated_speed^2
  double slip = 0.0;  ///< of the rated speed against the synchronous one, 0 or more
  /// Returns where the line takes over [rad/s].
  double transition() const;
  double torque_at(double speed) const;
  TorqueCurve points() const;
};

/// An induction generator: a line about the synchronous speed, constant beyond the pull-out torque.
struct InductionGenerator {
  double synchronous_speed = 0.0;  ///< [rad/s], > 0
  double rated_torque = 0.0;       ///< [N m], > 0
  double slip = 0.0;               ///< of the rated speed, > 0
  double pull_out = 1.0;           ///< largest torque by the rated one, > 0
  TorqueCurve points() const;
};

/// An induction generator by Thevenin's equivalent circuit, of three phases in a star.
struct TheveninGenerator {
  double frequency = 0.0;  ///< of the line [Hz], > 0
  int poles = 2;
  double stator_resistance = 0.0, rotor_resistance = 0.0;  ///< [ohm], > 0
  double line_voltage = 0.0;                               ///< between lines [V], > 0
  double stator_reactance = 0.0, rotor_reactance = 0.0;    ///< of leakage [ohm], > 0
  double magnetizing_reactance = 0.0;                      ///< [ohm], > 0
  double torque_at(double speed) const;
  TorqueCurve points() const;
};

}  // namespace spoke::foreign
