#pragma once

// A mass on a bearing, whose motion has closed forms.

#include <Eigen/Core>
#include <string>

namespace spoke::test {

/// Returns ", KEY=[[xx,xy],[yx,yy]]".
std::string matrix_key(const std::string& key, double xx, double xy, double yx, double yy);

/// A scenario of a rotor that slides along x and y, with 40 kg along x and 30 kg along y, and turns
/// about z at `spin` [rad/s] unless that is 0, with a bearing of axis z to the hub, whose matrices
/// or numbers are `keys`. `turn`: of the bearing's axes about z [rad].
std::string make_sliding_mass(const std::string& keys, const Eigen::Vector2d& place,
                              const Eigen::Vector2d& speed, double spin = 0.0, double turn = 0.0,
                              const std::string& gravity = "[0,0,0]");

/// A scenario at rest of a steel shaft along x of 1.5 m and 0.05 m, with discs of 0.07 m and 0.28
/// and 0.35 m at its thirds, on two bearings at its ends whose matrices are `keys`: Friswell,
/// Penny, Garvey & Lees, Dynamics of Rotating Machines, 2010, section 5.9. It does not turn about
/// x.
std::string make_rotor_on_bearings(const std::string& keys);

/// Returns u(t) of u'' = -A u from rest at u(0). Precondition: A has positive eigenvalues.
Eigen::Vector2d advance_undamped(const Eigen::Matrix2d& A, const Eigen::Vector2d& start, double t);

}  // namespace spoke::test
