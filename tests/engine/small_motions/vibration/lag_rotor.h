#pragma once

// Rigid blades on lag hinges about a hub that moves in the plane of rotation: linear models, and
// the equations of Coleman and Feingold (1958, NACA report 1351).

#include <Eigen/Core>
#include <complex>
#include <string>
#include <vector>

#include "engine/small_motions/steady/linear_model.h"
#include "engine/small_motions/vibration/standing_axes.h"

namespace spoke::test {

/// A blade of unit mass and length, hinged away from the hub's axis.
struct LagBlade {
  double offset = 0.1;  ///< of the hinge [m]
  double moment = 0.5;  ///< static moment about the hinge [kg m]
  double inertia = 1.0 / 3.0;
  double mass = 1.0;
  double stiffness = 0.4;  ///< [N m/rad]
  double damping = 0.02;   ///< [N m s/rad]
};

/// Springs, dampers and masses of what the hub stands on.
struct HubSprings {
  double kx = 0.0, ky = 0.0, mx = 0.0, my = 0.0, cx = 0.0, cy = 0.0;
};

/// A linear model in the frame that turns, with the hub's place across the axis as coordinates.
struct LagRotor {
  steady::LinearModel linear;
  std::vector<double> azimuths;
  std::vector<std::string> names;
  vibration::StandingAxes axes;
};
/// Makes a rotor of equal blades at equal angles.
LagRotor make_lag_rotor(int blades, double speed);

/// Returns J of x = J z for springs at the hub.
Eigen::MatrixXd in_plane();
vibration::SecondOrder matrices_of(const HubSprings& springs);

/// Returns the roots of Coleman's equations for three or more blades that have an imaginary part
/// >= 0: in p + iq, the sum of lag angles by exp(i azimuth), and the hub's x and y.
std::vector<std::complex<double>> solve_coleman(int blades, double speed,
                                                const HubSprings& springs);

}  // namespace spoke::test
