#pragma once

// The hub's coordinates seen from outside: along axes that stand while the hub turns.

#include <Eigen/Core>
#include <vector>

#include "engine/small_motions/steady/linear_model.h"

namespace spoke::vibration {

/// A matrix that depends on the azimuth psi of the hub: mean + cosine cos psi + sine sin psi.
struct Turning {
  Eigen::MatrixXd mean, cosine, sine;

  Eigen::MatrixXd at(double psi) const;
};

/// How coordinates z of the hub along standing axes go with those along axes that turn, x = T^T z.
/// The axes meet at azimuth zero.
struct StandingAxes {
  Turning T;           ///< by the azimuth of the hub
  Eigen::MatrixXd W;   ///< dT/dt = W T = T W [1/s]
  double speed = 0.0;  ///< of the hub [rad/s]
};

/// Makes the axes for these components of a twist, of 3 in the plane or of 6 in space. Throws
/// std::logic_error if they have one of two components across the axis without the other.
StandingAxes make_standing_axes(const std::vector<int>& components, bool is_spatial, double speed);

/// Matrices that multiply x'', x' and x.
struct SecondOrder {
  Eigen::MatrixXd M, C, K;
};

/// Returns columns for x as columns for T z with the same forces: as
/// x = T^T z, x' = T^T (z' - W z), x'' = T^T (z'' - 2 W z' + W^2 z),
/// they are (M, C - 2 M W, K - C W + M W^2), which T^T must follow.
SecondOrder stand_columns(const SecondOrder& columns, const StandingAxes& axes);
/// The same with W given, of coordinates of any kind.
SecondOrder stand_columns(const SecondOrder& columns, const Eigen::MatrixXd& W);

}  // namespace spoke::vibration
