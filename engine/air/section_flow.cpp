// The plane of a section, in which alone flow counts: what goes along the blade does not.

#include "engine/air/section_flow.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace spoke::air {

SectionAxes find_axes(const RotorPlace& rotor, const MarkerMotion& section, double sine,
                      double cosine, double side) noexcept {
  constexpr double least_projection = 1e-6;
  const auto along = section.rotation.col(0);
  SectionAxes axes;
  axes.axial = rotor.axis - along.dot(rotor.axis) * along;
  const double size = axes.axial.norm();
  if (size > least_projection)
    axes.axial /= size;
  else  // a blade along the rotor's axis
    axes.axial = section.rotation.col(2);
  axes.tangential = side * axes.axial.cross(along);
  axes.chord = (side * cosine) * section.rotation.col(1) + sine * section.rotation.col(2);
  axes.nose_up = side * along;
  axes.pitch = std::atan2(axes.chord.dot(axes.axial), axes.chord.dot(axes.tangential));
  const Eigen::Vector3d arm = section.position - rotor.center;
  axes.outward = arm - arm.dot(rotor.axis) * rotor.axis;
  axes.radius = axes.outward.norm();
  if (axes.radius > 0.0) axes.outward /= axes.radius;
  axes.around = axes.radius > 0.0 ? side * rotor.axis.cross(axes.outward) : axes.tangential;
  return axes;
}

SectionFlow find_flow(const SectionAxes& axes, const MarkerMotion& section,
                      const Eigen::Vector3d& wind, double ahead, double in_plane) noexcept {
  const Eigen::Vector3d flow =
      wind - section.velocity - section.angular_velocity.cross(ahead * axes.chord);
  return {flow.dot(axes.axial), -flow.dot(axes.tangential), in_plane};
}

double find_turning_angle(const SectionAxes& axes, const MarkerMotion& section,
                          const SectionFlow& flow, double chord) noexcept {
  const double rise = 0.5 * chord * section.angular_velocity.dot(axes.nose_up);
  if (rise == 0.0) return 0.0;
  // The chord's normal, towards the suction side, has these parts.
  const double axial = std::cos(axes.pitch), ahead = std::sin(axes.pitch);
  const double along_chord = flow.ahead * axial - flow.axial * ahead;
  const double normal = flow.axial * axial + flow.ahead * ahead;
  const double angle = std::atan2(normal + rise, along_chord) - std::atan2(normal, along_chord);
  return std::remainder(angle, 2.0 * std::numbers::pi);
}

double calc_turning_moment(double turning, double attached) noexcept {
  return -0.5 * std::numbers::pi * attached * turning;
}

}  // namespace spoke::air
