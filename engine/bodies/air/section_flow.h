#pragma once

// Flow against a section of a blade, and the axes in which it is described.

#include <Eigen/Core>
#include <cmath>

#include "engine/bodies/air/annulus.h"
#include "engine/bodies/air/rotor_place.h"
#include "engine/load.h"

namespace spoke::air {

/// Axes of a section, inertial frame. All but `around` and `outward` lie in the section's plane.
struct SectionAxes {
  Eigen::Vector3d axial;       ///< the rotor's axis, projected onto the plane
  Eigen::Vector3d tangential;  ///< normal to it, in the direction of the turn
  Eigen::Vector3d chord;       ///< from the trailing to the leading edge
  Eigen::Vector3d nose_up;     ///< of moments that raise the leading edge: x, or -x
  Eigen::Vector3d around;   ///< of the circle about the rotor's axis, in the direction of the turn
  Eigen::Vector3d outward;  ///< from the axis; zero on it
  double radius;            ///< [m]
  double pitch_sine, pitch_cosine;  ///< of the chord against the tangential axis, nose up

  /// Returns the angle of flow against the chord, positive against its lower side; 0 where air is
  /// at rest against the section [rad].
  double find_attack(double axial_flow, double ahead) const noexcept;
  /// Returns the flow across the chord, from the lower side to that of suction.
  double find_across(double axial_flow, double ahead) const noexcept {
    return axial_flow * pitch_cosine + ahead * pitch_sine;
  }
};

/// Returns a difference of two velocities; 0 where it is what rounding leaves of them when they
/// cancel. size: of the velocities [m/s].
inline double without_rounding(double difference, double size) noexcept {
  constexpr double share = 1e-12;  // velocities are sums over the bodies that carry a section
  return std::abs(difference) <= share * size ? 0.0 : difference;  // what is no number stays
}

/// Returns the axes of a section. sine, cosine: of the chord's twist; side: 1, or -1 if leading
/// edges look towards -y.
SectionAxes find_axes(const RotorPlace& rotor, const MarkerMotion& section, double sine,
                      double cosine, double side) noexcept;

/// Returns the undisturbed flow against the point of the chord at a distance ahead of the section's
/// axis [m]. in_plane: of the wind against the hub [m/s].
SectionFlow find_flow(const SectionAxes& axes, const MarkerMotion& section,
                      const Eigen::Vector3d& wind, double ahead, double in_plane) noexcept;

/// Returns by what the section's turning raises the flow across its chord at three quarters of it,
/// where it decides on lift, above that at one quarter, on which lift is at right angles [m/s].
double find_rise(const SectionAxes& axes, const MarkerMotion& section, double chord) noexcept;

/// Returns the angle [rad] by which a rise of find_rise() turns the flow.
double find_turning_angle(const SectionAxes& axes, const SectionFlow& flow, double rise) noexcept;

/// Returns the coefficient of the moment about the quarter chord that the section's turning causes
/// by find_turning_angle() [rad], as far as flow is attached: of a thin aerofoil in unsteady flow
/// -pi c theta'/(4 V) (Theodorsen, NACA report 496, 1935). It damps torsion; lift by the flow at
/// three quarters alone would drive it where the aerodynamic centre is ahead of the axis.
double calc_turning_moment(double turning, double attached) noexcept;

}  // namespace spoke::air
