#pragma once

// A periodic motion at equal parts of a turn.

#include <Eigen/Core>

namespace spoke::steady {
class SteadyModel;
}

namespace spoke::vibration {

/// Motion of all coordinates of a PeriodicSystem over a turn, in columns by azimuth.
struct TurnMotion {
  Eigen::MatrixXd x, v, a;

  Eigen::Index parts() const { return x.cols(); }
  double azimuth(Eigen::Index l) const;
};

/// Returns the motion of harmonics, as find_harmonics() returns them, at so many parts of a turn as
/// they are known by. `speed`: of the hub [rad/s].
TurnMotion make_turn_motion(const Eigen::MatrixXcd& harmonics, double speed);

/// Puts the hub where it is at the l-th azimuth. `hub`: number of the hub's coordinates, 0 or 1.
void place_hub(const TurnMotion& motion, Eigen::Index l, Eigen::Index hub,
               steady::SteadyModel& model);

}  // namespace spoke::vibration
