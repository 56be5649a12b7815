#pragma once

// Steady performance of a rotor in wind along its axis: thrust and power over wind speed, or over
// tip-speed ratio and pitch.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "models/scenario.h"
#include "spoke/export.h"

namespace spoke {

/// Which operating points are asked for.
struct PerformanceOptions {
  /// Wind speeds at the hub [m/s]; of a map one, and none: the scenario's.
  std::vector<double> wind{};
  /// Tip-speed ratios of a map, each with each of `pitch`; none: the rotor finds its speed itself.
  std::vector<double> tip_speed_ratio{};
  /// Pitch angles [rad]: of a map one or more. Over wind speeds at most one, at which pitch is
  /// held. None: those of [control.pitch], or joints as they stand.
  std::vector<double> pitch{};
  /// Name of the joint that pitches a blade, where there is no [control.pitch].
  std::string joint = "pitch";
  bool is_rigid = false;  ///< blades undeformed
  std::string rotor{};    ///< of several the one by this name; empty: there is one
  /// Called with the number of points that are done. An exception that it throws ends the search.
  std::function<void(std::size_t)> progress{};
};

/// A steady state of a rotor in uniform wind.
struct PerformancePoint {
  double wind = 0.0;             ///< speed of the wind at the hub [m/s]
  double speed = 0.0;            ///< of the hub [rad/s]
  double tip_speed_ratio = 0.0;  ///< undeformed radius times speed by wind
  double pitch = 0.0;            ///< angle of the pitch joints [rad]
  double thrust = 0.0;           ///< of the air on the blades, along the axis [N]
  double torque = 0.0;           ///< of the air on the blades, about the axis [N m]
  double power = 0.0;            ///< torque times speed [W]
  double thrust_coefficient = 0.0, power_coefficient = 0.0;  ///< by the wind; 0 without wind
  double tip_displacement = 0.0;  ///< of the first blade's tip along the axis [m]
  /// Why there is no steady state; empty: there is one.
  std::string gap{};
};

/// Operating points.
struct PerformanceResult {
  bool is_map = false;  ///< over tip-speed ratio and pitch, the latter running fastest
  bool is_rigid = false;
  std::string rotor{};   ///< that was asked for by its name; else empty
  double radius = 0.0;   ///< of the undeformed tip [m]
  double density = 0.0;  ///< of the air [kg/m^3]
  std::vector<PerformancePoint> points;
};

/// Finds the steady states of a rotor of a scenario in air, alone, which is uniform, steady and
/// blows along the wind's direction; of it the part along the rotor's axis counts, as gravity does,
/// and the support is rigid. Where the drive prescribes the speed, the rotor has the speed with
/// which that ends. Where it is a torque by speed, the rotor turns as fast as the air drives it
/// against that torque; up to the set point of [control.pitch] at its least pitch, and beyond at
/// the pitch that holds the set point. Throws InputError where the scenario has no air, or an
/// option does not fit.
SPOKE_EXPORT PerformanceResult solve_performance(const Scenario& scenario,
                                                 const PerformanceOptions& options);

}  // namespace spoke
