#pragma once

// Data of Fig. 8 and Fig. 9: the drive, and the deflection of a blade's tip, over time.

#include <string>
#include <vector>

#include "models/drive.h"
#include "models/scenario.h"

namespace spoke::reproduce {

struct DrivePoint {
  double t = 0.0;  ///< [s]
  DriveMotion motion = {};
};
/// Returns `count` + 1 points of the drive from 0 to `duration` [s]. Precondition: the drive
/// prescribes the motion.
std::vector<DrivePoint> sample_drive(const Drive& drive, double duration, int count);

/// The transverse displacement of the tip in the hub's frame, "tip.y", of one blade.
struct Deflection {
  std::string name = {};
  struct Point {
    double t = 0.0, y = 0.0;  ///< [s, m]
  };
  std::vector<Point> points = {};  ///< every 0.05 s
  double lag = 0.0;                ///< the value furthest below zero, over all steps [m]
  double lag_time = 0.0;           ///< [s]
  /// Largest |tip.y| from the end of the ramp on [m].
  double residual = 0.0;
};
/// Simulates one blade of the scenario with generalized_alpha at `step` [s].
Deflection simulate_deflection(std::string name, Scenario scenario, double step);

/// The exact solution, independent of Spoke: the geometrically exact (Reissner) beam in its
/// shear-rigid limit without rotary inertia, which is the Euler-Bernoulli beam, converged in mesh
/// and step to 1e-8 m or better; docs/formulation.md, section 8.1.
namespace exact {
inline constexpr double kLag = -0.53411139;        ///< [m]
inline constexpr double kLagTime = 6.7659135;      ///< [s]
inline constexpr double kResidual = 0.0082960479;  ///< [m]
/// Returns tip.y at some times.
std::vector<Deflection::Point> points();
}  // namespace exact

}  // namespace spoke::reproduce
