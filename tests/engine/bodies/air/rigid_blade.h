#pragma once

// A blade that does not bend, on a rotor that turns, and aerofoils of closed form.

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "engine/bodies/air/blade_air.h"
#include "models/air.h"

namespace spoke::test {

/// Position and motion of a rigid blade. The rotor's axis is x; at azimuth 0 the blade points along
/// z.
struct BladePlace {
  double speed = 0.0;    ///< about the axis [rad/s]
  double azimuth = 0.0;  ///< [rad]
  double cone = 0.0;     ///< of the blade towards +x [rad]
  double pitch = 0.0;    ///< nose up, towards +x [rad]
  double pitch_rate = 0.0;
  double hub_radius = 0.0;
  bool backward = false;  ///< the leading edge looks backward: for rotors of negative speed
};

/// Returns the motion of the sections at distances from the root.
std::vector<MarkerMotion> move_blade(const BladePlace& place, const std::vector<double>& stations);

/// A blade's air, what it is given and what comes out.
struct AirRun {
  const air::BladeAir& blade;
  std::vector<double> state;
  std::vector<Wrench> loads;
  std::vector<air::StationAir> seen;

  explicit AirRun(const air::BladeAir& blade);
  /// Evaluates in a uniform wind; states go on.
  void go(const BladePlace& place, const Eigen::Vector3d& wind, double elapsed, bool held = false);
  Eigen::Vector3d force() const;
  /// About the origin, the hub's centre.
  Eigen::Vector3d moment(const BladePlace& place) const;
};

/// Makes an aerofoil from functions of the angle of attack, in steps of a quarter of a degree.
spatial::Airfoil make_airfoil(const std::string& name, const std::function<double(double)>& lift,
                              double drag, double moment = 0.0);

/// Returns the lift 2 pi sin(angle) of a plate to 10 degrees, that of separated flow beyond 30.
double plate_lift(double angle);

/// Returns air with these aerofoils, all steady.
spatial::Air steady_air(std::vector<spatial::Airfoil> airfoils);

/// Makes the aerodynamics of a blade with one aerofoil from functions of the distance from the
/// root.
spatial::BladeAerodynamics make_blade(const std::vector<double>& stations,
                                      const std::string& airfoil,
                                      const std::function<double(double)>& chord,
                                      const std::function<double(double)>& twist);

/// Returns `count` numbers evenly from `first` to `last`.
std::vector<double> spread(double first, double last, int count);

/// An elapsed time after which all is steady.
inline constexpr double kForever = std::numeric_limits<double>::infinity();

}  // namespace spoke::test
