#pragma once

// A rotor of a scenario in steady rotation in wind: what air does to it at a wind speed, a speed
// of the hub and an angle of pitch.

#include <optional>
#include <string>
#include <vector>

#include "engine/small_motions/steady/find_equilibrium.h"
#include "models/scenario.h"

namespace spoke::steady {

/// What air does to a rotor, and how it deflects.
struct RotorAnswer {
  double thrust = 0.0;            ///< [N]
  double torque = 0.0;            ///< [N m]
  double tip_displacement = 0.0;  ///< of the first blade, along the axis [m]
};

class RotorInWind {
 public:
  /// Takes a rotor of a scenario in air, by its number; `joints` pitch its blades. `is_rigid`:
  /// undeformed.
  RotorInWind(const Scenario& scenario, int rotor, const std::vector<std::string>& joints,
              bool is_rigid);

  /// Returns what air does in wind of this speed [m/s] at a speed of the hub [rad/s], where the
  /// pitch joints stand at `angle` [rad]; none: as they do in the scenario. Goes on from the
  /// equilibrium before. Throws DivergenceError where there is none.
  RotorAnswer find(double wind, double speed, std::optional<double> angle);

 private:
  Equilibrium find_state(SteadyModel& model);

  Scenario scenario_;
  int rotor_;
  std::vector<std::string> joints_;
  bool is_rigid_;
  Eigen::Vector3d direction_;  ///< of the wind
  std::unique_ptr<SteadyModel> before_;
  std::optional<Equilibrium> at_;  ///< of `before_`
};

}  // namespace spoke::steady
